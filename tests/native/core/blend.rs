//! The rigid blend of whole scenes.

use c2warp::project::Blend;
use glam::{DMat2, DVec2};
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, project, scenes, solved, spread};

proptest! {
    #![proptest_config(cases(32))]

    #[test]
    fn handles_go_where_they_are_taken((rings, places, support) in scenes(), degrees in -2000.0..2000.0_f64) {
        let mut project = project(&rings, &places, support);
        let solution = solved(&project).expect("a valid scene");
        let to = |p: DVec2| p * 0.7 + DVec2::new(3.0, 40.0);
        let turned = |(id, &p): (usize, &DVec2)| point_handle(id, p, to(p), degrees * id as f64);
        project.handles = places.iter().enumerate().map(turned).collect();
        let pose = solution.poser().pose(&project.handles, Blend::Rigid).expect("finite");
        for &rest in &places {
            prop_assert!(solution.map(&pose, rest).expect("inside").posed.distance(to(rest)) <= 1e-9);
        }
        // The mesh is posed as single points are.
        for (&vertex, posed) in solution.vertices().iter().zip(solution.posed_vertices(&pose)).step_by(50) {
            if let Some(mapped) = solution.map(&pose, vertex) {
                prop_assert!(mapped.posed.distance(posed) <= 1e-6);
            }
        }
    }

    #[test]
    fn the_determinant_is_that_of_the_map(
        (rings, places, support) in scenes(),
        turns in proptest::collection::vec(-200.0..200.0_f64, 8),
    ) {
        let mut project = project(&rings, &places, support);
        let solution = solved(&project).expect("a valid scene");
        let turned = |(id, &p): (usize, &DVec2)| point_handle(id, p, p + DVec2::splat(turns[id % 8] / 10.0), turns[id % 8]);
        project.handles = places.iter().enumerate().map(turned).collect();
        for handle in &mut project.handles {
            handle.scale = 1.3;
        }
        let pose = solution.poser().pose(&project.handles, Blend::Rigid).expect("finite");
        let step = 1e-5;
        let at = |p: DVec2| solution.map(&pose, p).map(|mapped| mapped.posed);
        let (mut compared, mut apart) = (0, 0);
        for p in spread(200) {
            let axis = |axis: DVec2| Some((at(p + step * axis)? - at(p - step * axis)?) / (2.0 * step));
            let (Some(mapped), Some(x), Some(y)) = (solution.map(&pose, p), axis(DVec2::X), axis(DVec2::Y)) else { continue };
            let expected = DMat2::from_cols(x, y).determinant();
            compared += 1;
            apart += usize::from((mapped.det - expected).abs() > 1e-3 * (1.0 + x.length() * y.length()));
            prop_assert!(mapped.posed.is_finite() && mapped.det.is_finite());
        }
        // Shortest paths have ridges, across which distances have no derivative.
        prop_assert!(apart * 20 <= compared, "{apart} of {compared}");
    }
}
