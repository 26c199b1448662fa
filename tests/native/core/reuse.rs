//! Tests that a reused solver gives the same results as a new one.

use c2warp::{
    Error, Picture, Solution, Solver,
    project::{ImageRef, Project},
    solve,
};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, scenes};

/// Returns the parts of a solution that determine the picture.
fn essentials(solution: &Solution) -> impl PartialEq + use<'_> {
    let nearest: Vec<Option<usize>> = (0..solution.samples()).map(|sample| solution.nearest_site(sample)).collect();
    (solution.vertices(), solution.triangles(), solution.weights(), solution.phi_sums(), nearest)
}

fn advance(solver: &mut Solver, project: &Project, picture: &Picture) -> Result<(), Error> {
    solver.begin(project, picture)?;
    while solver.advance()?.is_some() {}
    Ok(())
}

/// Solves projects with one solver and with new ones. The results must have the same bits, or the same error.
fn check(projects: &[Project], picture: &Picture) -> Result<(), TestCaseError> {
    let mut solver = Solver::new();
    for project in projects {
        match (advance(&mut solver, project, picture), solve(project, picture)) {
            (Ok(()), Ok(fresh)) => {
                let reused = solver.solution().expect("every stage has run");
                prop_assert!(essentials(reused) == essentials(&fresh), "{:?}", project.handles);
            }
            (Err(reused), Err(fresh)) => prop_assert_eq!(reused, fresh),
            (reused, fresh) => prop_assert!(false, "{reused:?}, but {:?}", fresh.map(|_| ())),
        }
    }
    Ok(())
}

#[test]
fn picture_of_another_size_has_a_new_outline() {
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
        // A picture of another size has another outline.
        project.image.width += 1;
        assert!(!solver.has_solved(&project));
    }
}

proptest! {
    #![proptest_config(cases(12))]

    #[test]
    fn previous_projects_do_not_change_the_result((rings, positions, support) in scenes(), more in (10.0..390.0_f64, 10.0..390.0_f64)) {
        let mut project = crate::scenes::project(&rings, &positions, support);
        let size = project.image.width;
        let rgba = vec![255; size as usize * size as usize * 4];
        let picture = Picture::new(size, size, &rgba).expect("a picture of fair size");
        let mut projects = vec![project.clone()];
        // Add a handle on a corner of the outline, on an edge, close to a handle, and anywhere.
        let edge = rings[0][0].midpoint(rings[0][1]);
        for p in [rings[0][2], edge, positions[0] + DVec2::new(0.3, 0.1), more.into()] {
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
