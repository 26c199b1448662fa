//! Tests of the public API with projects that are built in code. They follow the same rules as project files.

use c2warp::{
    Error, InputMesh, Picture, ResampleOptions,
    cloud::PointCloud,
    distances,
    domain::Domain,
    pose::Poser,
    project::{Blend, DomainSpec, Handle, Project, Shape, Support},
    solve, solve_cloud, solve_domain, solve_mesh,
};
use glam::DVec2;

use crate::handles::bar;
use crate::scenes::{SIZE, project, solved};

const RING: [(f64, f64); 4] = [(40.0, 40.0), (360.0, 40.0), (360.0, 360.0), (40.0, 360.0)];

/// An edit that makes a project invalid, and the expected message.
type InvalidEdit = (fn(&mut Project), &'static str);

/// Returns a project with a square domain and two handles.
fn two_handles() -> Project {
    two_handles_from(DVec2::splat(100.0))
}

fn two_handles_from(first: DVec2) -> Project {
    project(&[RING.map(DVec2::from).to_vec()], &[first, DVec2::splat(300.0)], Support::Paper)
}

#[test]
fn invalid_projects_are_rejected_by_key_before_solving() {
    let rgba = vec![255; (SIZE * SIZE * 4) as usize];
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
    let corners: Vec<DVec2> = RING.map(DVec2::from).to_vec();
    let mesh = InputMesh::new(corners.clone(), vec![[0, 1, 2], [0, 2, 3]]).expect("a square");
    let grid = (0..400).map(|i| DVec2::new(f64::from(i % 20), f64::from(i / 20)) * 20.0).collect();
    let cloud = PointCloud::new(grid, 8).expect("a grid");
    let edits: [InvalidEdit; 7] = [
        // Each of these once exhausted memory, ran forever or panicked.
        (|project| project.samples = 0, "samples: expected a whole number from 100 to 2000000, found 0"),
        (
            |project| project.samples = u32::MAX,
            "samples: expected a whole number from 100 to 2000000, found 4294967295",
        ),
        (|project| project.weighting.degree = 0, "weighting.degree: expected a whole number from 5 to 32, found 0"),
        (
            |project| project.weighting.degree = u32::MAX,
            "weighting.degree: expected a whole number from 5 to 32, found 4294967295",
        ),
        (
            |project| project.weighting.shape_factor = f64::NAN,
            "weighting.shape_factor: expected a number from 0 to 1, found NaN",
        ),
        (|project| project.handles[1].id = "h0".into(), "handles[1].id: \"h0\" is already the id of another handle"),
        (|project| project.domain = Some(DomainSpec::polygon(Vec::new())), "domain.rings: expected at least one ring"),
    ];
    for (edit, message) in edits {
        let mut project = two_handles();
        edit(&mut project);
        let errors =
            [solve(&project, &picture).err(), solve_mesh(&project, &mesh).err(), solve_cloud(&project, &cloud).err()];
        for error in errors {
            let error = error.expect("an error");
            assert_eq!((error.code(), error.to_string().as_str()), ("project", message));
        }
    }
    let mut invalid = two_handles();
    invalid.domain = Some(DomainSpec::Alpha { threshold: f64::NAN });
    let rejected = distances(&invalid, &picture, DVec2::splat(9.0), &[]).map_err(|error| error.to_string());
    assert_eq!(rejected, Err("domain.threshold: expected a number above 0 and up to 1, found NaN".into()));
}

/// The example in the README of the crate is a doc test.
#[test]
fn both_readmes_have_the_same_example() {
    let example = |text: &'static str| {
        let (_, code) = text.split_once("```rust\n").expect("an example");
        code.split_once("```").expect("its end").0
    };
    assert_eq!(example(include_str!("../../../README.md")), example(include_str!("../../../wasm/core/README.md")),);
}

#[test]
fn order_of_posed_handles_does_not_matter() {
    let mut project = two_handles();
    project.handles.push(bar("bar", &[(100.0, 300.0), (200.0, 300.0)], &[(100.0, 310.0), (190.0, 330.0)]));
    for (handle, by) in project.handles.iter_mut().zip([(20.0, 5.0), (-10.0, 15.0)]) {
        let Shape::Point { posed, .. } = &mut handle.shape else { panic!("a point") };
        *posed += DVec2::from(by);
    }
    let solution = solved(&project).expect("a valid scene");
    let motions = |handles: &[Handle]| {
        let pose = solution.poser().pose(handles, Blend::Linear).expect("handles that were solved");
        pose.motions().to_vec()
    };
    let reversed: Vec<Handle> = project.handles.iter().rev().cloned().collect();
    assert_eq!(motions(&reversed), motions(&project.handles));
}

#[test]
fn pose_of_another_solution_is_rejected() {
    let project = two_handles();
    let [solution, other] =
        [100.0, 120.0].map(|first| solved(&two_handles_from(DVec2::splat(first))).expect("a valid scene"));
    let pose = |poser: &Poser| poser.pose(&project.handles, Blend::Linear).expect("handles that were solved");
    let again = Poser::from_bytes(&solution.poser().to_bytes()).expect("the bytes of a poser");
    assert!(solution.map(&pose(&again), DVec2::splat(200.0)).is_some());
    let longer = [solution.poser().to_bytes(), vec![0]].concat();
    assert_eq!(Poser::from_bytes(&longer).map(drop), Err(Error::PoserBytes));
    let foreign = pose(other.poser());
    let uses: [&dyn Fn(); 4] = [
        &|| assert!(solution.map(&foreign, DVec2::splat(200.0)).is_none()),
        &|| drop(solution.posed_vertices(&foreign)),
        &|| drop(solution.drawn_triangles(&foreign)),
        &|| drop(solution.report(&foreign)),
    ];
    for use_pose in uses {
        let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(use_pose)).expect_err("a pose of another");
        let message = panic.downcast_ref::<String>().expect("a message");
        assert_eq!(message, "the pose belongs to another solution: use the poser of this solution");
    }
}

#[test]
fn invalid_scale_picture_and_pose_are_rejected_by_warped() {
    let project = two_handles();
    let solution = solved(&project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, Blend::Linear).expect("finite");
    let rgba = vec![255; (SIZE * SIZE * 4) as usize];
    let rejected = |width: u32, height: u32, scale: f64| {
        let picture = Picture::new(width, height, &rgba).expect("a picture");
        solution
            .warped(&picture, &pose, ResampleOptions { scale, ..ResampleOptions::default() })
            .expect_err("an error")
            .code()
    };
    for scale in [0.0, f64::NAN, -1.0, 1e9] {
        assert_eq!(rejected(SIZE, SIZE, scale), "scale");
    }
    assert_eq!(rejected(2 * SIZE, SIZE / 2, 1.0), "picture-mismatch");
    let moved = two_handles_from(DVec2::splat(120.0));
    let foreign = solved(&moved).expect("a valid scene").poser().pose(&moved.handles, Blend::Linear).expect("finite");
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
    assert_eq!(solution.warped(&picture, &foreign, ResampleOptions::default()), Err(Error::PoseOfAnotherSolution));
    let warped = solution
        .warped(&picture, &pose, ResampleOptions { scale: 0.5, ..ResampleOptions::default() })
        .expect("half the size");
    assert_eq!((warped.width, warped.height, warped.rgba.len() as u32), (SIZE / 2, SIZE / 2, SIZE * SIZE));
}

#[test]
fn invalid_handle_scale_is_rejected_by_key() {
    let project = two_handles();
    let solution = solved(&project).expect("a valid scene");
    let mut handles = project.handles;
    handles[1].scale = 0.0;
    let rejected = solution.poser().pose(&handles, Blend::Linear).map(|_| ());
    assert!(matches!(rejected, Err(Error::Project(_))), "{rejected:?}");
    assert_eq!(
        rejected.map_err(|error| error.to_string()),
        Err("handles[1].scale: expected a number above 0, found 0".into())
    );
}

#[test]
fn solve_domain_agrees_with_the_domain_of_a_project() {
    let (project, rings) = (two_handles(), [RING.map(DVec2::from).to_vec()]);
    let with = solved(&project).expect("a valid scene");
    // The picture and the project's own domain are ignored.
    let mut other = project.clone();
    (other.domain, other.image.width) = (None, 1);
    let without = solve_domain(&other, &Domain::from_rings(&rings).expect("a square")).expect("a valid scene");
    assert_eq!(without.weights(), with.weights());
    assert_eq!((without.vertices(), without.triangles()), (with.vertices(), with.triangles()));
    let points = [DVec2::splat(150.0), DVec2::splat(10.0), DVec2::new(200.0, 100.0)];
    assert_eq!(without.weights_of(&points), with.weights_of(&points));
    for (row, &p) in points.iter().enumerate() {
        let expected = with.weights_at(p).unwrap_or_default();
        assert_eq!(without.weights_of(&points).row(row).collect::<Vec<_>>(), expected);
    }
}
