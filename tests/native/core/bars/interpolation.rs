//! Tests that the warp interpolates bars and polygons (paper, section V-D).

use c2warp::project::{Blend, PoseMode, Rotation, Shape, Support};
use glam::DVec2;

use super::{all_kinds, check_lines, map_point, parameters, solve_and_pose, square};
use crate::handles::bar;
use crate::scenes::{spread, symmetric_within};

#[test]
fn points_on_bars_and_polygons_stay_on_them() {
    for support in [Support::Paper, Support::Smooth] {
        for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
            for (density, blend) in [(0, Blend::Linear), (60, Blend::Linear), (60, Blend::Rigid)] {
                let mut project = square(support, all_kinds());
                (project.pose.mode, project.pose.density, project.pose.blend) = (mode, density, blend);
                let (solution, pose) = solve_and_pose(&project);
                check_lines(&project, &solution, &pose);
            }
        }
    }
}

#[test]
fn weights_on_a_bar_belong_to_it_and_sum_to_one() {
    let project = square(Support::Smooth, all_kinds());
    let (solution, _) = solve_and_pose(&project);
    let Shape::Bar { rest, .. } = &project.handles[1].shape else { panic!("a bar") };
    for pair in rest.windows(2) {
        for t in parameters() {
            let weights = solution.weights_at(pair[0].lerp(pair[1], t)).expect("inside");
            assert!((weights.iter().map(|&(_, weight)| weight).sum::<f64>() - 1.0).abs() <= 1e-12);
            for (site, weight) in weights {
                assert!(weight >= 0.0);
                assert!(weight == 0.0 || solution.sites()[site].kind.handle() == Some(1));
            }
        }
    }
}

#[test]
fn pose_ignores_rest_positions_changed_after_solving() {
    let mut project = square(Support::Smooth, all_kinds());
    let (solution, pose) = solve_and_pose(&project);
    for handle in &mut project.handles {
        match &mut handle.shape {
            Shape::Point { rest, .. } => *rest += 10.0,
            Shape::Bar { rest, .. } | Shape::Polygon { rest, .. } => rest.iter_mut().for_each(|corner| *corner += 10.0),
        }
    }
    let again = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    for (before, after) in pose.motions().iter().zip(again.motions()) {
        let by = (before.translation - after.translation).length() + (before.angle - after.angle).abs();
        assert!(by < 1e-9, "{before:?} and {after:?}");
    }
}

#[test]
fn symmetric_scene_with_bars_has_a_symmetric_result() {
    let mirror = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    for (mode, fix_boundary) in [(PoseMode::Harmonic, false), (PoseMode::Rigid, false), (PoseMode::Rigid, true)] {
        let left = bar("left", &[(80.0, 100.0), (110.0, 250.0)], &[(60.0, 110.0), (120.0, 270.0)]);
        let right = bar("right", &[(320.0, 100.0), (290.0, 250.0)], &[(340.0, 110.0), (280.0, 270.0)]);
        let brow =
            bar("brow", &[(150.0, 80.0), (200.0, 60.0), (250.0, 80.0)], &[(140.0, 70.0), (200.0, 80.0), (260.0, 70.0)]);
        let mut project = square(Support::Smooth, vec![left, right, brow]);
        project.fix_boundary = fix_boundary;
        (project.pose.mode, project.pose.density) = (mode, 50);
        let (solution, pose) = solve_and_pose(&project);
        let within = symmetric_within(mode, &solution, &pose).unwrap_or(0.1);
        for p in spread(3000) {
            let Some(here) = solution.map(&pose, p) else { continue };
            let there = map_point(&solution, &pose, mirror(p));
            assert!(
                mirror(here.posed).distance(there) <= within,
                "{mode:?}: {p} is mapped to {} and {there}",
                here.posed
            );
        }
    }
}

#[test]
fn det_matches_the_jacobian_around_joints() {
    let (solution, pose) = solve_and_pose(&square(Support::Smooth, all_kinds()));
    let mut worst = 0.0_f64;
    let step = 1e-5;
    for p in spread(3000) {
        let at = |p: DVec2| solution.map(&pose, p).map(|mapped| mapped.posed);
        let sides = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|axis| at(p + step * axis));
        let (Some(mapped), [Some(right), Some(left), Some(down), Some(up)]) = (solution.map(&pose, p), sides) else {
            continue;
        };
        let det = ((right - left) / (2.0 * step)).perp_dot((down - up) / (2.0 * step));
        worst = worst.max((mapped.det - det).abs() / det.abs().max(1.0));
    }
    assert!(worst < 1e-4, "{worst}");
}

#[test]
fn turns_over_180_degrees_are_counted() {
    let mut project =
        square(Support::Smooth, vec![bar("bar", &[(100.0, 200.0), (200.0, 200.0)], &[(200.0, 200.0), (100.0, 200.0)])]);
    project.handles[0].rotation = Rotation::Degrees(500.0);
    let (solution, pose) = solve_and_pose(&project);
    assert!(pose.motions().iter().all(|motion| (motion.angle.to_degrees() - 540.0).abs() < 1e-9));
    project.handles[0] = bar("bar", &[(100.0, 200.0), (200.0, 200.0)], &[(150.0, 200.0), (150.0, 200.0)]);
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    for p in spread(300) {
        assert!(solution.map(&pose, p).is_none_or(|mapped| mapped.posed.is_finite()));
    }
}
