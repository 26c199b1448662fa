//! Tests of point clouds.

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

/// Returns the points of a jittered grid of 40 × 40 points at 10 px for which `kept` is true.
fn jittered_grid(kept: impl Fn(DVec2) -> bool) -> Vec<DVec2> {
    let grid = (0..40).flat_map(|y| (0..40).map(move |x| 10.0 * DVec2::new(x.into(), y.into())));
    grid.zip(spread(1600)).map(|(p, jitter)| p + (jitter - 200.0) / 100.0).filter(|&p| kept(p)).collect()
}

fn scene(positions: &[DVec2]) -> Project {
    project(&[], positions, Support::Paper)
}

fn solved_on(points: Vec<DVec2>, positions: &[DVec2]) -> CloudSolution {
    let cloud = PointCloud::new(points, NEIGHBOURS).expect("a cloud");
    solve_cloud(&scene(positions), &cloud).expect("a scene that can be solved")
}

fn some_positions() -> [DVec2; 5] {
    [(52.0, 61.0), (330.5, 140.0), (200.0, 350.0), (203.0, 344.0), (203.02, 344.0)].map(DVec2::from)
}

#[test]
fn weights_are_non_negative_and_sum_to_one() {
    let points = jittered_grid(|_| true);
    let solution = solved_on(points.clone(), &some_positions());
    for p in points.into_iter().chain(spread(1000)).filter(|p| p.min_element() > 2.0 && p.max_element() < 388.0) {
        let weights = solution.weights_at(p).expect("within the cloud");
        assert!((weights.iter().map(|entry| entry.1).sum::<f64>() - 1.0).abs() < 1e-12, "at {p}");
        assert!(weights.iter().all(|entry| entry.1 >= 0.0), "at {p}");
        assert!(weights.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }
}

#[test]
fn handles_have_full_weight_at_their_rest_positions() {
    let points = jittered_grid(|_| true);
    let mut positions = some_positions().to_vec();
    positions.push(points[777]);
    let solution = solved_on(points, &positions);
    let real = solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real());
    assert_eq!(real.clone().count(), positions.len());
    for (at, site) in real {
        assert_eq!(site.rest, positions[site.kind.handle().expect("real")]);
        assert_eq!(solution.weights_at(site.rest), Some(vec![(at, 1.0)]));
    }
    assert_eq!(solution.weights().len(), 1600 + 5);
}

#[test]
fn supports_cover_their_cells_and_avoid_real_sites() {
    let solution = solved_on(jittered_grid(|_| true), &some_positions());
    assert!(solution.sites().len() > 5);
    assert!(
        solution
            .sites()
            .iter()
            .all(|site| site.cell_radius < site.support_radius && site.support_radius < site.clearance)
    );
    assert!((0..solution.weights().len()).all(|point| solution.weights().row(point).next().is_some()));
    for site in 0..solution.sites().len() {
        assert!((solution.harmonic_weights(site).map(|(_, harmonic)| harmonic).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn handles_reach_their_posed_positions_in_both_modes() {
    let positions = some_positions();
    for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
        let mut project = scene(&positions);
        project.pose.mode = mode;
        project.handles[0] = point_handle(0, positions[0], positions[0] + DVec2::new(30.0, -10.0), 20.0);
        let points = jittered_grid(|_| true);
        let cloud = PointCloud::new(points.clone(), NEIGHBOURS).expect("a cloud");
        let solution = solve_cloud(&project, &cloud).expect("a scene that can be solved");
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("a pose");
        assert_eq!(solution.map(&pose, positions[0]), Some(positions[0] + DVec2::new(30.0, -10.0)));
        assert_eq!(solution.map(&pose, positions[1]), Some(positions[1]));
        let posed = solution.posed_points(&pose);
        assert_eq!(posed.len(), points.len());
        assert!(posed.iter().all(|p| p.is_finite()));
    }
}

#[test]
fn weights_follow_the_shape_and_parts_are_independent() {
    // Two bands that are joined on the right by a third band, and a separate part below.
    let kept = |p: DVec2| p.y < 95.0 || (145.0..245.0).contains(&p.y) || (p.x > 300.0 && p.y < 245.0) || p.y > 305.0;
    let points = jittered_grid(kept);
    let positions = [(20.0, 50.0), (20.0, 200.0)].map(DVec2::from);
    let solution = solved_on(points.clone(), &positions);
    assert!(solution.sites().iter().take(2).all(|site| site.clearance > 600.0), "the shortest path goes around");
    for (point, p) in points.iter().enumerate() {
        assert_eq!(solution.weights().row(point).next().is_none(), p.y > 300.0, "at {p}");
        assert_eq!(solution.nearest_site(point).is_none(), p.y > 300.0, "at {p}");
    }
    assert_eq!(solution.weights_at((150.0, 120.0).into()), None);
}

#[test]
fn order_of_handles_does_not_matter() {
    let mut positions = some_positions();
    let one = solved_on(jittered_grid(|_| true), &positions);
    positions.reverse();
    let other = solved_on(jittered_grid(|_| true), &positions);
    assert_eq!((one.weights(), one.scores()), (other.weights(), other.scores()));
}

#[test]
fn every_point_of_a_cloud_has_weights() {
    let cloud = PointCloud::new(jittered_grid(|p| p.x + p.y < 250.0), 2).expect("a cloud");
    let positions = [DVec2::new(52.0, 61.0), DVec2::new(55.0, 60.0), DVec2::new(120.0, 40.0)];
    let solution = solve_cloud(&scene(&positions), &cloud).expect("a scene that can be solved");
    for p in spread(20_000) {
        assert_eq!(solution.weights_at(p).is_some(), cloud.contains(p), "{p}");
    }
}

#[test]
fn sparse_clouds_are_solved() {
    // With so few points, all of them become sites.
    let points: Vec<DVec2> = jittered_grid(|_| true).into_iter().step_by(97).collect();
    let positions = [points[3], points[3] + DVec2::new(0.5, 0.0), points[3] + DVec2::new(0.0, 0.02)];
    let solution = solved_on(points.clone(), &positions);
    assert!((0..solution.weights().len()).all(|point| solution.weights().row(point).next().is_some()));
    // A cluster of more handles than neighbours stays connected to the cloud.
    let cluster: Vec<DVec2> = (0..20).map(|i| points[5] + 0.1 * DVec2::new(f64::from(i), f64::from(i % 3))).collect();
    let solution = solved_on(points, &cluster);
    assert!((0..solution.weights().len()).all(|point| solution.nearest_site(point).is_some()));
}

#[test]
fn errors_name_the_point_or_handle() {
    let points = jittered_grid(|_| true);
    let rejected = |points: &[DVec2], neighbours| {
        let error = PointCloud::new(points.to_vec(), neighbours).expect_err("no cloud");
        assert_eq!(error.code(), "cloud");
        error
    };
    assert_eq!(rejected(&points[..8], 8), Error::CloudNeighbours { points: 8, neighbours: 8 });
    assert_eq!(rejected(&points, 0), Error::CloudNeighbours { points: 1600, neighbours: 0 });
    assert_eq!(rejected(&[], 1), Error::CloudNeighbours { points: 0, neighbours: 1 });
    for wrong in [f64::NAN, f64::INFINITY, 1e7] {
        let mut points = points.clone();
        points[31].x = wrong;
        assert_eq!(rejected(&points, 8), Error::CloudPoint { point: 31 });
    }
    let mut twice = points.clone();
    twice[700] = twice[31];
    assert_eq!(rejected(&twice, 1), Error::CloudDuplicate { point: 700, other: 31 });
    assert_eq!(rejected(&twice, 8), Error::CloudDuplicate { point: 700, other: 31 });

    let cloud = PointCloud::new(points, NEIGHBOURS).expect("a cloud");
    let rejected = |positions: &[DVec2]| solve_cloud(&scene(positions), &cloud).expect_err("an invalid handle");
    let outside = [(50.0, 50.0), (450.0, 50.0)].map(DVec2::from);
    assert_eq!(rejected(&outside), Error::HandleOutside { id: "h1".into(), x: 450.0, y: 50.0 });
    assert_eq!(rejected(&[DVec2::splat(50.0), DVec2::splat(50.001)]).code(), "handles-too-close");
    assert_eq!(rejected(&[DVec2::splat(f64::NAN)]).code(), "project");
}
