//! Projects that are made in code rather than read: the same rules hold for them, whatever solves them.

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

/// A change of a project and why it is then none.
type Refused = (fn(&mut Project), &'static str);

/// A square with two handles.
fn made() -> Project {
    made_with(DVec2::splat(100.0))
}

fn made_with(first: DVec2) -> Project {
    project(&[RING.map(DVec2::from).to_vec()], &[first, DVec2::splat(300.0)], Support::Paper)
}

#[test]
fn what_cannot_be_solved_is_refused_by_its_key_before_anything_is_begun() {
    let rgba = vec![255; (SIZE * SIZE * 4) as usize];
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
    let corners: Vec<DVec2> = RING.map(DVec2::from).to_vec();
    let mesh = InputMesh::new(corners.clone(), vec![[0, 1, 2], [0, 2, 3]]).expect("a square");
    let grid = (0..400).map(|i| DVec2::new(f64::from(i % 20), f64::from(i / 20)) * 20.0).collect();
    let cloud = PointCloud::new(grid, 8).expect("a grid");
    let changes: [Refused; 7] = [
        // Any of these took all memory, did not end, or panicked.
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
        (|project| project.handles[1].id = "h0".into(), "handles[1].id: \"h0\" is the name of another handle"),
        (
            |project| project.domain = Some(DomainSpec::Polygon { rings: Vec::new() }),
            "domain.rings: expected at least one ring",
        ),
    ];
    for (change, refusal) in changes {
        let mut project = made();
        change(&mut project);
        let refusals =
            [solve(&project, &picture).err(), solve_mesh(&project, &mesh).err(), solve_cloud(&project, &cloud).err()];
        for error in refusals {
            let error = error.expect("a project that is none");
            assert_eq!((error.code(), error.to_string().as_str()), ("project", refusal));
        }
    }
    let mut nowhere = made();
    nowhere.domain = Some(DomainSpec::Alpha { threshold: f64::NAN });
    let refused = distances(&nowhere, &picture, DVec2::splat(9.0), &[]).map_err(|error| error.to_string());
    assert_eq!(refused, Err("domain.threshold: expected a number above 0 and up to 1, found NaN".into()));
}

/// The crate's own README is compiled and run with its documentation.
#[test]
fn the_readme_shows_the_example_that_is_tested() {
    let example = |text: &'static str| {
        let (_, code) = text.split_once("```rust\n").expect("an example");
        code.split_once("```").expect("its end").0
    };
    assert_eq!(example(include_str!("../../../README.md")), example(include_str!("../../../wasm/core/README.md")),);
}

#[test]
fn the_order_in_which_handles_are_posed_means_nothing() {
    let mut project = made();
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
fn a_pose_is_of_its_own_solution_alone() {
    let project = made();
    let [solution, other] = [100.0, 120.0].map(|first| solved(&made_with(DVec2::splat(first))).expect("a valid scene"));
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
    for used in uses {
        let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(used)).expect_err("a pose of another");
        let message = panic.downcast_ref::<String>().expect("a message");
        assert_eq!(message, "the pose is of another solution: make it by the poser of this one");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let project = made();
    let solution = solved(&project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, Blend::Linear).expect("finite");
    let rgba = vec![255; (SIZE * SIZE * 4) as usize];
    let refused = |width: u32, height: u32, scale: f64| {
        let picture = Picture::new(width, height, &rgba).expect("a picture");
        solution
            .warped(&picture, &pose, ResampleOptions { scale, ..ResampleOptions::default() })
            .expect_err("no picture")
            .code()
    };
    for scale in [0.0, f64::NAN, -1.0, 1e9] {
        assert_eq!(refused(SIZE, SIZE, scale), "scale");
    }
    assert_eq!(refused(2 * SIZE, SIZE / 2, 1.0), "picture-mismatch");
    let moved = made_with(DVec2::splat(120.0));
    let foreign = solved(&moved).expect("a valid scene").poser().pose(&moved.handles, Blend::Linear).expect("finite");
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
    assert_eq!(solution.warped(&picture, &foreign, ResampleOptions::default()), Err(Error::PoseOfAnother));
    let warped = solution
        .warped(&picture, &pose, ResampleOptions { scale: 0.5, ..ResampleOptions::default() })
        .expect("half the size");
    assert_eq!((warped.width, warped.height, warped.rgba.len() as u32), (SIZE / 2, SIZE / 2, SIZE * SIZE));
}

#[test]
fn what_cannot_be_posed_is_refused_by_its_key() {
    let project = made();
    let solution = solved(&project).expect("a valid scene");
    let mut handles = project.handles;
    handles[1].scale = 0.0;
    let refused = solution.poser().pose(&handles, Blend::Linear).map(|_| ());
    assert!(matches!(refused, Err(Error::Project(_))), "{refused:?}");
    assert_eq!(
        refused.map_err(|error| error.to_string()),
        Err("handles[1].scale: expected a number above 0, found 0".into())
    );
}

#[test]
fn a_domain_without_a_picture_is_solved_as_that_of_a_project_is() {
    let (project, rings) = (made(), [RING.map(DVec2::from).to_vec()]);
    let with = solved(&project).expect("a valid scene");
    // The picture and the project's own domain play no part.
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
