//! A solver that has solved before, and one that has not.

use c2warp::{
    Error, Picture, Solution, Solver,
    project::{ImageRef, Project},
    solve,
};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, scenes};

/// Everything of a solution that is drawn.
fn drawn(solution: &Solution) -> impl PartialEq + use<'_> {
    let nearest: Vec<Option<usize>> = (0..solution.samples()).map(|sample| solution.nearest_site(sample)).collect();
    (solution.vertices(), solution.triangles(), solution.weights(), solution.phi_sums(), nearest)
}

fn advance(solver: &mut Solver, project: &Project, picture: &Picture) -> Result<(), Error> {
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    Ok(())
}

/// Solves projects one after the other, and each from nothing: the same bits, or the same refusal.
fn check(projects: &[Project], picture: &Picture) -> Result<(), TestCaseError> {
    let mut solver = Solver::new();
    for project in projects {
        match (advance(&mut solver, project, picture), solve(project, picture)) {
            (Ok(()), Ok(fresh)) => {
                let known = solver.solution().expect("every stage has run");
                prop_assert!(drawn(known) == drawn(&fresh), "{:?}", project.handles);
            }
            (Err(known), Err(fresh)) => prop_assert_eq!(known, fresh),
            (known, fresh) => prop_assert!(false, "{known:?}, but {:?}", fresh.map(|_| ())),
        }
    }
    Ok(())
}

#[test]
fn a_picture_of_another_size_has_an_outline_of_its_own() {
    let mut solver = Solver::new();
    assert!(solver.solution().is_none());
    for (width, height) in [(64, 48), (200, 100)] {
        let rgba = vec![255; (width * height * 4) as usize];
        let picture = Picture::new(width, height, &rgba).expect("a picture of fair size");
        let mut project = Project::new(ImageRef::new("white.png", width, height));
        let far = DVec2::new(f64::from(width), f64::from(height)) - 4.0;
        project.samples = 300;
        project.handles =
            vec![point_handle(0, DVec2::splat(4.0), DVec2::splat(4.0), 0.0), point_handle(1, far, far, 0.0)];
        assert!(!solver.has_solved(&project));
        advance(&mut solver, &project, &picture).expect("handles on the picture");
        assert!(solver.has_solved(&project));
        // Of a smaller picture both would be solved as well, but on another outline.
        project.image.width += 1;
        assert!(!solver.has_solved(&project));
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn what_was_solved_before_changes_no_bit((rings, places, support) in scenes(), more in (10.0..390.0_f64, 10.0..390.0_f64)) {
        let mut project = crate::scenes::project(&rings, &places, support);
        let size = project.image.width;
        let rgba = vec![255; size as usize * size as usize * 4];
        let picture = Picture::new(size, size, &rgba).expect("a picture of fair size");
        let mut projects = vec![project.clone()];
        // A corner of the outline, the middle of an edge, close to a handle, anywhere.
        let edge = rings[0][0].midpoint(rings[0][1]);
        for p in [rings[0][2], edge, places[0] + DVec2::new(0.3, 0.1), more.into()] {
            project.handles.push(point_handle(project.handles.len(), p, p, 0.0));
            projects.push(project.clone());
            if solve(&project, &picture).is_err() {
                project.handles.pop();
            }
        }
        project.samples *= 2;
        project.handles.remove(0);
        projects.push(project.clone());
        project.pose.density = 60;
        projects.push(project);
        projects.push(projects[0].clone());
        check(&projects, &picture)?;
    }
}
