//! Tests of bars that leave the domain or run along its outline.

use std::f64::consts::TAU;

use c2warp::{
    Error,
    project::{Shape, Support},
};
use glam::DVec2;

use super::{ON_BAR, map_point, parameters, solve_and_pose, square};
use crate::handles::{bar, line, point_handle, points, polygon};
use crate::scenes::{project, solved, spread};

#[test]
fn bar_across_a_hole_moves_both_sides_and_reports_the_gap() {
    let rings = [
        points(&[(20.0, 20.0), (380.0, 20.0), (380.0, 380.0), (20.0, 380.0)]),
        points(&[(150.0, 150.0), (250.0, 150.0), (250.0, 250.0), (150.0, 250.0)]),
    ];
    let mut project = project(&rings, &[], Support::Smooth);
    project.handles = vec![bar("over", &[(100.0, 200.0), (400.0, 200.0)], &[(100.0, 180.0), (400.0, 230.0)])];
    let (solution, pose) = solve_and_pose(&project);
    let goal = |x: f64| DVec2::new(100.0, 180.0).lerp(DVec2::new(400.0, 230.0), (x - 100.0) / 300.0);
    for x in [100.0, 123.0, 150.0, 250.0, 301.0, 380.0] {
        assert!(map_point(&solution, &pose, DVec2::new(x, 200.0)).distance(goal(x)) <= ON_BAR, "{x}");
    }
    let outside: Vec<[DVec2; 2]> = solution.outside().iter().map(|part| [part.from, part.to]).collect();
    assert_eq!(outside, [(150.0, 250.0), (380.0, 400.0)].map(|(from, to)| [from, to].map(|x| DVec2::new(x, 200.0))));
    assert!(solution.outside().iter().all(|part| part.handle == "over"));
}

/// The bar lies on the outline within or just overhang rounding, and extends past its end. The part outside is
/// reported.
#[test]
fn bar_along_the_outline_is_cut_at_the_end_of_the_domain() {
    for offset in [0.0, 1e-13, 1e-9, 9e-7, 1e-6, 1.5e-6, 1.99e-6, 3e-6, 1e-5] {
        for overhang in [5.0, 50.0, 900.0] {
            let along = [(20.0 - offset, 20.0 - overhang), (20.0 - offset, 200.0)];
            let project = square(Support::Smooth, vec![bar("along", &along, &along)]);
            match solved(&project) {
                Ok(solution) => {
                    let outside = solution.outside();
                    assert!(
                        outside.iter().any(|part| part.to.y - part.from.y > 0.99 * overhang),
                        "{offset} {overhang}: {outside:?}"
                    );
                }
                Err(Error::HandleOutside { id, .. }) => assert!(id == "along" && offset > 9e-7, "{offset} {overhang}"),
                Err(other) => panic!("{offset} {overhang}: {other}"),
            }
        }
        let corner = [(100.0, 150.0), (200.0, 20.0 - offset), (250.0, 150.0)];
        let other = [(120.0, 200.0), (20.0 - offset, 240.0)];
        let handles = vec![polygon("corner", &corner, &corner), bar("end", &other, &other)];
        let (solution, pose) = solve_and_pose(&square(Support::Smooth, handles));
        for p in spread(200).filter(|p| p.min_element() > 21.0 && p.max_element() < 379.0) {
            assert!(map_point(&solution, &pose, p).distance(p) <= ON_BAR, "{offset} {p}");
        }
    }
}

/// A bar outside by less than rounding once had no distances around the corner, in either direction.
#[test]
fn bar_along_the_outline_has_distances_around_its_corners() {
    // A notch 1 px wide ends in a narrow neck.
    let notched = [
        [(20.0, 100.0), (199.5, 100.0), (199.5, 200.0), (200.5, 200.0), (200.5, 100.0), (380.0, 100.0)],
        [(380.0, 300.0), (200.5, 300.0), (200.5, 200.004), (199.5, 200.004), (199.5, 300.0), (20.0, 300.0)],
    ];
    let ring = points(notched.as_flattened());
    for (offset, end) in [(0.0, 210.0), (5e-9, 210.0), (1e-7, 210.0), (5e-7, 210.0), (9e-7, 200.004)] {
        for rest in [(199.5, 230.0), (190.0, 250.0)] {
            let along = [(200.5 - offset, 299.999), (200.5 - offset, end)];
            let behind = point_handle(0, rest.into(), DVec2::new(180.0, 220.0), 0.0);
            let mut project = project(std::slice::from_ref(&ring), &[], Support::Smooth);
            project.handles = vec![bar("along", &along, &along.map(|(x, y)| (x + 20.0, y))), behind];
            let (solution, pose) = solve_and_pose(&project);
            let error = map_point(&solution, &pose, rest.into()).distance((180.0, 220.0).into());
            assert!(error <= ON_BAR, "offset {offset}, {rest:?}: {error} px off");
            assert!(solution.sites().iter().all(|site| site.separation.is_finite()), "offset {offset}, {rest:?}");
        }
    }
}

/// The bar runs along the floor of a notch, outside by about the rounding tolerance, and ends at a wall.
#[test]
fn bar_that_leaves_a_notch_is_cut_without_panic() {
    let ring = points(&[
        (20.0, 20.0),
        (100.0, 20.0),
        (100.0, 60.0),
        (104.0, 60.0),
        (104.0, 20.0),
        (380.0, 20.0),
        (200.0, 380.0),
    ]);
    for offset in [0.9e-6, 1.1e-6, 1.3e-6, 1.7e-6, 2.1e-6] {
        for samples in [300, 1000, 3000] {
            let bent = [(300.0, 150.0), (104.0, 60.0), (100.0, 60.0 - offset)];
            let mut project = project(std::slice::from_ref(&ring), &[], Support::Smooth);
            project.samples = samples;
            project.handles = vec![bar("bent", &bent, &bent)];
            project.handles.push(point_handle(0, DVec2::new(102.0, 62.0), DVec2::new(102.0, 62.0), 0.0));
            solved(&project).expect("the bar is cut");
        }
    }
}

/// If the halves were two bodies, they would keep clear of each other and need up to a thousand sites.
#[test]
fn bar_with_a_corner_just_outside_stays_one_body() {
    let bent = |out: f64, by: DVec2| {
        let rest = [(100.0, 150.0), (200.0, 20.0 - out), (250.0, 150.0)];
        let mut project = square(Support::Smooth, vec![bar("bent", &rest, &rest.map(|(x, y)| (x + by.x, y + by.y)))]);
        let offset = DVec2::new(150.0, 300.0);
        project.handles.push(point_handle(0, offset, offset + by, 0.0));
        solve_and_pose(&project)
    };
    let by = DVec2::new(14.0, -9.0);
    let within = bent(-1e-3, by).0.sites().len();
    for out in [0.0, 1e-5, 1e-3, 0.01, 0.1, 0.3] {
        let (solution, pose) = bent(out, by);
        assert!(solution.sites().len() <= within + 5, "{out}: {} sites, {within} within", solution.sites().len());
        for p in spread(500).filter(|p| p.min_element() > 20.0 && p.max_element() < 380.0) {
            assert!(map_point(&solution, &pose, p).distance(p + by) <= ON_BAR, "{out}: {p}");
        }
    }
}

/// A segment shorter than the tolerated overhang is joined at both ends and needs no sites.
#[test]
fn bar_with_a_corner_just_outside_stays_on_its_line() {
    let turned = |by: f64| move |p: DVec2| DVec2::new(200.0, 200.0) + DVec2::from_angle(by).rotate(p - 200.0);
    let stretched = |p: DVec2| DVec2::new(200.0 + 4.0 * (p.x - 200.0), p.y);
    let poses: [&dyn Fn(DVec2) -> DVec2; 3] = [&turned(TAU / 2.0), &turned(-TAU / 5.0), &stretched];
    for out in [1e-9, 0.01, 0.3, 0.49, 0.51, 4.0] {
        let overhang = 380.0 + out;
        for corners in
            [&[(200.0, 200.0), (overhang, 200.0)][..], &[(100.0, 20.0 - out), (90.0, 250.0), (overhang, 300.0)]]
        {
            for posed_at in poses {
                let rest = points(corners);
                let posed_corners: Vec<DVec2> = rest.iter().map(|&p| posed_at(p)).collect();
                let shape = Shape::Bar { rest: rest.clone(), posed: posed_corners.clone() };
                let (solution, pose) = solve_and_pose(&square(Support::Smooth, vec![line("bar", shape)]));
                for (i, t) in (1..rest.len()).flat_map(|i| parameters().map(move |t| (i, t))) {
                    let at = rest[i - 1].lerp(rest[i], t);
                    if at.x < 380.0 && at.y > 20.0 {
                        let expected = posed_corners[i - 1].lerp(posed_corners[i], t);
                        let error = map_point(&solution, &pose, at).distance(expected);
                        assert!(error <= ON_BAR, "{error} px off at {t} of segment {i} with {out} px outside");
                    }
                }
            }
        }
    }
}
