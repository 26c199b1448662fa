//! Point clouds.

use c2warp::{
    Error,
    cloud::{CloudSolution, PointCloud},
    project::{PoseMode, Project, Support},
    solve_cloud,
};
use glam::DVec2;

use crate::handles::point_handle;
use crate::scenes::{project, spread};

const NEIGHBOURS: usize = 8;

/// A grid of 40 by 40 points, 10 px apart and a little shaken, where `kept` says so.
fn shaken(kept: impl Fn(DVec2) -> bool) -> Vec<DVec2> {
    let grid = (0..40).flat_map(|y| (0..40).map(move |x| 10.0 * DVec2::new(x.into(), y.into())));
    grid.zip(spread(1600)).map(|(p, shake)| p + (shake - 200.0) / 100.0).filter(|&p| kept(p)).collect()
}

fn scene(places: &[DVec2]) -> Project {
    project(&[], places, Support::Paper)
}

fn solved_on(points: Vec<DVec2>, places: &[DVec2]) -> CloudSolution {
    let cloud = PointCloud::new(points, NEIGHBOURS).expect("a cloud");
    solve_cloud(&scene(places), &cloud).expect("a scene that can be solved")
}

fn some_places() -> [DVec2; 5] {
    [(52.0, 61.0), (330.5, 140.0), (200.0, 350.0), (203.0, 344.0), (203.02, 344.0)].map(DVec2::from)
}

#[test]
fn weights_sum_to_one_and_none_is_negative() {
    let points = shaken(|_| true);
    let solution = solved_on(points.clone(), &some_places());
    for p in points.into_iter().chain(spread(1000)).filter(|p| p.min_element() > 2.0 && p.max_element() < 388.0) {
        let weights = solution.weights_at(p).expect("within the cloud");
        assert!((weights.iter().map(|entry| entry.1).sum::<f64>() - 1.0).abs() < 1e-12, "at {p}");
        assert!(weights.iter().all(|entry| entry.1 >= 0.0), "at {p}");
        assert!(weights.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }
}

#[test]
fn handles_have_all_the_weight_at_their_own_places() {
    let points = shaken(|_| true);
    let mut places = some_places().to_vec();
    places.push(points[777]);
    let solution = solved_on(points, &places);
    let real = solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real());
    assert_eq!(real.clone().count(), places.len());
    for (at, site) in real {
        assert_eq!(site.rest, places[site.kind.handle().expect("real")]);
        assert_eq!(solution.weights_at(site.rest), Some(vec![(at, 1.0)]));
    }
    assert_eq!(solution.weights().len(), 1600 + 5);
}

#[test]
fn supports_cover_their_cells_and_are_clear_of_real_sites() {
    let solution = solved_on(shaken(|_| true), &some_places());
    assert!(solution.sites().len() > 5);
    assert!(
        solution
            .sites()
            .iter()
            .all(|site| site.cell_radius < site.support_radius && site.support_radius < site.clearance)
    );
    assert!((0..solution.weights().len()).all(|point| solution.weights().row(point).next().is_some()));
    for site in 0..solution.sites().len() {
        assert!((solution.harmonic_weights(site).map(|(_, share)| share).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_pose_moves_handles_where_they_are_taken_in_either_mode() {
    let places = some_places();
    for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
        let mut project = scene(&places);
        project.pose.mode = mode;
        project.handles[0] = point_handle(0, places[0], places[0] + DVec2::new(30.0, -10.0), 20.0);
        let points = shaken(|_| true);
        let cloud = PointCloud::new(points.clone(), NEIGHBOURS).expect("a cloud");
        let solution = solve_cloud(&project, &cloud).expect("a scene that can be solved");
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("a pose");
        assert_eq!(solution.map(&pose, places[0]), Some(places[0] + DVec2::new(30.0, -10.0)));
        assert_eq!(solution.map(&pose, places[1]), Some(places[1]));
        let posed = solution.posed_points(&pose);
        assert_eq!(posed.len(), points.len());
        assert!(posed.iter().all(|p| p.is_finite()));
    }
}

#[test]
fn weights_follow_the_shape_and_parts_are_independent() {
    // Two bands, joined on the right by a third, and a part of its own below.
    let kept = |p: DVec2| p.y < 95.0 || (145.0..245.0).contains(&p.y) || (p.x > 300.0 && p.y < 245.0) || p.y > 305.0;
    let points = shaken(kept);
    let places = [(20.0, 50.0), (20.0, 200.0)].map(DVec2::from);
    let solution = solved_on(points.clone(), &places);
    assert!(solution.sites().iter().take(2).all(|site| site.clearance > 600.0), "the way leads around");
    for (point, p) in points.iter().enumerate() {
        assert_eq!(solution.weights().row(point).next().is_none(), p.y > 300.0, "at {p}");
        assert_eq!(solution.nearest_site(point).is_none(), p.y > 300.0, "at {p}");
    }
    assert_eq!(solution.weights_at((150.0, 120.0).into()), None);
}

#[test]
fn the_order_of_handles_does_not_matter() {
    let mut places = some_places();
    let one = solved_on(shaken(|_| true), &places);
    places.reverse();
    let other = solved_on(shaken(|_| true), &places);
    assert_eq!((one.weights(), one.scores()), (other.weights(), other.scores()));
}

#[test]
fn all_of_a_cloud_has_weights_beside_handles_too() {
    let cloud = PointCloud::new(shaken(|p| p.x + p.y < 250.0), 2).expect("a cloud");
    let places = [DVec2::new(52.0, 61.0), DVec2::new(55.0, 60.0), DVec2::new(120.0, 40.0)];
    let solution = solve_cloud(&scene(&places), &cloud).expect("a scene that can be solved");
    for p in spread(20_000) {
        assert_eq!(solution.weights_at(p).is_some(), cloud.contains(p), "{p}");
    }
}

#[test]
fn sparse_clouds_end_too() {
    // So few points that all of them become sites.
    let points: Vec<DVec2> = shaken(|_| true).into_iter().step_by(97).collect();
    let places = [points[3], points[3] + DVec2::new(0.5, 0.0), points[3] + DVec2::new(0.0, 0.02)];
    let solution = solved_on(points.clone(), &places);
    assert!((0..solution.weights().len()).all(|point| solution.weights().row(point).next().is_some()));
    // A crowd of handles larger than the number of neighbours hangs together with the cloud.
    let crowd: Vec<DVec2> = (0..20).map(|i| points[5] + 0.1 * DVec2::new(f64::from(i), f64::from(i % 3))).collect();
    let solution = solved_on(points, &crowd);
    assert!((0..solution.weights().len()).all(|point| solution.nearest_site(point).is_some()));
}

#[test]
fn every_refusal_names_point_or_handle() {
    let points = shaken(|_| true);
    let refusal = |points: &[DVec2], neighbours| {
        let error = PointCloud::new(points.to_vec(), neighbours).expect_err("no cloud");
        assert_eq!(error.code(), "cloud");
        error
    };
    assert_eq!(refusal(&points[..8], 8), Error::CloudNeighbours { points: 8, neighbours: 8 });
    assert_eq!(refusal(&points, 0), Error::CloudNeighbours { points: 1600, neighbours: 0 });
    assert_eq!(refusal(&[], 1), Error::CloudNeighbours { points: 0, neighbours: 1 });
    for wrong in [f64::NAN, f64::INFINITY, 1e7] {
        let mut points = points.clone();
        points[31].x = wrong;
        assert_eq!(refusal(&points, 8), Error::CloudPoint { point: 31 });
    }
    let mut twice = points.clone();
    twice[700] = twice[31];
    assert_eq!(refusal(&twice, 1), Error::CloudDuplicate { point: 700, other: 31 });
    assert_eq!(refusal(&twice, 8), Error::CloudDuplicate { point: 700, other: 31 });

    let cloud = PointCloud::new(points, NEIGHBOURS).expect("a cloud");
    let refusal = |places: &[DVec2]| solve_cloud(&scene(places), &cloud).expect_err("a handle that is refused");
    let outside = [(50.0, 50.0), (450.0, 50.0)].map(DVec2::from);
    assert_eq!(refusal(&outside), Error::HandleOutside { id: "h1".into(), x: 450.0, y: 50.0 });
    assert_eq!(refusal(&[DVec2::splat(50.0), DVec2::splat(50.001)]).code(), "handles-too-close");
    assert_eq!(refusal(&[DVec2::splat(f64::NAN)]).code(), "project");
}
