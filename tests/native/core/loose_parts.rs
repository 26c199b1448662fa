//! Parts without a handle: they stay in place, or follow the nearest part that has one.

use c2warp::{
    Picture, Solution,
    project::{DomainSpec, Handle, LooseParts, Project},
    solve,
};
use glam::DVec2;

/// A row of squares, with a handle on the second.
fn squares(loose_parts: LooseParts) -> (Project, Solution) {
    let side = 300;
    let rgba = (0..side * side)
        .flat_map(|i| [40, 90, 60, if i % side % 60 < 40 && (100..140).contains(&(i / side)) { 255 } else { 0 }])
        .collect::<Vec<u8>>();
    let mut project = Project::for_picture(side, side);
    project.handles = vec![Handle::point("a", [80.0, 120.0]).posed_at([[90.0, 150.0]]).turned(30.0)];
    project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
    project.loose_parts = loose_parts;
    let solution = solve(&project, &Picture::new(side, side, &rgba).expect("a picture")).expect("a solution");
    (project, solution)
}

#[test]
fn loose_parts_stay_or_follow_the_nearest_part_with_a_handle() {
    for (loose_parts, follows) in [(LooseParts::Stay, false), (LooseParts::Follow, true)] {
        let (project, solution) = squares(loose_parts);
        let pose = solution.pose(&project).expect("a pose");
        assert_eq!(solution.report(&pose).loose_islands, 4);
        let posed = solution.posed_vertices(&pose);
        // The turn about the handle, and its move.
        let turned = |p: DVec2| {
            DVec2::from_angle(30_f64.to_radians()).rotate(p - DVec2::new(80.0, 120.0)) + DVec2::new(90.0, 150.0)
        };
        for (&rest, &posed) in solution.vertices().iter().zip(&posed) {
            let has_handle = (50.0..110.0).contains(&rest.x);
            let expected = if follows || has_handle { turned(rest) } else { rest };
            assert!(posed.distance(expected) < 1e-9, "{rest} is at {posed}, not at {expected}");
        }
        // The map agrees with the mesh.
        let p = DVec2::new(200.0, 120.0);
        let mapped = solution.map(&pose, p).expect("a loose part").posed;
        assert!(mapped.distance(if follows { turned(p) } else { p }) < 1e-9);
        assert!(solution.report(&pose).min_phi_sum > 0.0);
    }
}
