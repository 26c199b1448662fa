//! Property tests of the rigid blend.

use c2warp::project::Blend;
use glam::{DMat2, DVec2};
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, project, scenes, solved, spread};

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn handles_reach_their_posed_positions((rings, positions, support) in scenes(), degrees in -2000.0..2000.0_f64) {
        let mut project = project(&rings, &positions, support);
        let solution = solved(&project).expect("a valid scene");
        let to = |p: DVec2| p * 0.7 + DVec2::new(3.0, 40.0);
        let turned = |(id, &p): (usize, &DVec2)| point_handle(id, p, to(p), degrees * id as f64);
        project.handles = positions.iter().enumerate().map(turned).collect();
        let pose = solution.poser().pose(&project.handles, Blend::Rigid).expect("finite");
        for &rest in &positions {
            prop_assert!(solution.map(&pose, rest).expect("inside").posed.distance(to(rest)) <= 1e-9);
        }
        // Mesh vertices and single points have the same posed positions.
        for (&vertex, posed) in solution.vertices().iter().zip(solution.posed_vertices(&pose)).step_by(50) {
            if let Some(mapped) = solution.map(&pose, vertex) {
                prop_assert!(mapped.posed.distance(posed) <= 1e-6);
            }
        }
    }

    #[test]
    fn determinant_matches_finite_differences(
        (rings, positions, support) in scenes(),
        turns in proptest::collection::vec(-200.0..200.0_f64, 8),
    ) {
        let mut project = project(&rings, &positions, support);
        let solution = solved(&project).expect("a valid scene");
        let turned = |(id, &p): (usize, &DVec2)| point_handle(id, p, p + DVec2::splat(turns[id % 8] / 10.0), turns[id % 8]);
        project.handles = positions.iter().enumerate().map(turned).collect();
        for handle in &mut project.handles {
            handle.scale = 1.3;
        }
        let pose = solution.poser().pose(&project.handles, Blend::Rigid).expect("finite");
        let step = 1e-5;
        let at = |p: DVec2| solution.map(&pose, p).map(|mapped| mapped.posed);
        let (mut compared, mut different) = (0, 0);
        for p in spread(200) {
            let axis = |axis: DVec2| Some((at(p + step * axis)? - at(p - step * axis)?) / (2.0 * step));
            let (Some(mapped), Some(x), Some(y)) = (solution.map(&pose, p), axis(DVec2::X), axis(DVec2::Y)) else { continue };
            let expected = DMat2::from_cols(x, y).determinant();
            compared += 1;
            different += usize::from((mapped.det - expected).abs() > 1e-3 * (1.0 + x.length() * y.length()));
            prop_assert!(mapped.posed.is_finite() && mapped.det.is_finite());
        }
        // Distances have no derivative across the ridges of shortest paths.
        prop_assert!(different * 20 <= compared, "{different} of {compared}");
    }
}
