//! Tests of bars and polygons in the rigid pose mode.

use c2warp::{
    Solution,
    deform::Pose,
    project::{PoseMode, Project, Shape, Support},
    solve,
};
use c2warp_tests::Scene;
use glam::DVec2;

use super::{map_point, solve_and_pose, square};
use crate::handles::{bar, point_handle};

/// Enlarges a scene `times` times, and solves and poses it as the editor does.
fn solve_in_rigid_mode(name: &str, times: u32, change: impl FnOnce(&mut Project)) -> (Solution, Pose) {
    let mut scene = Scene::enlarged(name, times);
    let project = &mut scene.project;
    project.weighting.support = Support::Smooth;
    (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
    change(project);
    let solution = solve(&scene.project, &scene.solver_picture()).expect("a valid scene");
    let pose = solution.poser().pose(&scene.project.handles, scene.project.pose.blend).expect("finite");
    (solution, pose)
}

#[test]
fn mesh_at_rest_stays_around_joints() {
    for name in ["portrait", "tower"] {
        let (solution, pose) = solve_in_rigid_mode(name, 2, |project| {
            for handle in &mut project.handles {
                match &mut handle.shape {
                    Shape::Point { rest, posed } => *posed = *rest,
                    Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => posed.clone_from(rest),
                }
            }
        });
        let posed = solution.posed_vertices(&pose);
        let moved = posed.iter().zip(solution.vertices()).map(|(p, q)| p.distance(*q));
        // The quadrature stores weights as f32, but their sums are exact.
        let farthest = moved.fold(0.0, f64::max);
        assert!(farthest < 1e-8, "{name}: {farthest} px");
    }
}

#[test]
fn area_squeezed_between_bars_does_not_fold() {
    // The gap between mouth and jaw shrinks from 45 to 22 px. Its virtual sites depend on the number of samples.
    for samples in [4_000, 5_000, 7_000, 9_000, 10_000, 16_000] {
        let (solution, pose) = solve_in_rigid_mode("portrait", 4, |project| project.samples = samples);
        let det = |&p: &DVec2| solution.map(&pose, p).expect("a sample").det;
        let least = solution.vertices()[..solution.samples()].iter().map(det).fold(f64::INFINITY, f64::min);
        eprintln!("{samples} samples: least det {least:.3}");
        // With too few quadrature points the least determinant was -0.7.
        assert!(least > 0.05, "{samples} samples: {least}");
        assert_eq!(solution.folded_triangles(&pose), 0);
    }
}

#[test]
fn stretched_bar_keeps_the_scale_of_the_picture() {
    let longer = bar("longer", &[(160.0, 200.0), (240.0, 200.0)], &[(150.0, 200.0), (250.0, 200.0)]);
    let mut project = square(Support::Smooth, vec![longer]);
    (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
    let (solution, pose) = solve_and_pose(&project);
    let between = |[a, b]: [(f64, f64); 2]| {
        map_point(&solution, &pose, a.into()).distance(map_point(&solution, &pose, b.into()))
            / DVec2::from(a).distance(b.into())
    };
    assert!((between([(170.0, 200.0), (230.0, 200.0)]) - 1.25).abs() < 1e-9);
    for edge in [[(30.0, 30.0), (370.0, 30.0)], [(30.0, 370.0), (370.0, 370.0)], [(30.0, 30.0), (30.0, 370.0)]] {
        // 1.25 if the stretch of the bar were applied to the whole picture.
        assert!((between(edge) - 1.0).abs() < 0.05, "{}", between(edge));
    }
}

#[test]
fn bar_of_zero_length_acts_like_a_tiny_bar() {
    let far: Vec<DVec2> = [(40.0, 40.0), (360.0, 60.0), (200.0, 360.0), (60.0, 300.0)].map(DVec2::from).into();
    let drawn_to = |length: f64| {
        let bar = bar("bar", &[(160.0, 200.0), (240.0, 200.0)], &[(160.0, 200.0), (160.0 + length, 200.0)]);
        let corner = DVec2::new(350.0, 350.0);
        let mut project = square(Support::Smooth, vec![bar, point_handle(0, corner, corner, 0.0)]);
        (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
        let (solution, pose) = solve_and_pose(&project);
        far.iter().map(|&p| map_point(&solution, &pose, p)).collect::<Vec<_>>()
    };
    let ([tiny, tinier, zero], moved) = ([0.008, 0.0008, 0.0].map(&drawn_to), drawn_to(80.0));
    for (k, p) in far.iter().enumerate() {
        assert!(moved[k].distance(*p) < 1e-6);
        for (length, tiny) in [(0.008, &tiny), (0.0008, &tinier)] {
            // The corners are three to four times as far from the bar as its ends from each other.
            assert!(tiny[k].distance(zero[k]) < 4.0 * length, "{p} is mapped to {} and {}", tiny[k], zero[k]);
        }
    }
}

#[test]
fn handle_scale_applies_to_the_picture_around_it() {
    let rest = DVec2::new(160.0, 220.0);
    let mut project = square(Support::Smooth, vec![point_handle(0, rest, rest, 0.0).scaled(1.25)]);
    (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
    let (solution, pose) = solve_and_pose(&project);
    for p in [(30.0, 30.0), (370.0, 30.0), (200.0, 360.0)].map(DVec2::from) {
        let to = rest + 1.25 * (p - rest);
        assert!(
            map_point(&solution, &pose, p).distance(to) < 1e-6,
            "{p} is mapped to {}",
            map_point(&solution, &pose, p)
        );
    }
}
