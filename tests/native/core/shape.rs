//! Tests of shapes that drags have left: a project with a shape opens as it was.

use c2warp::{
    Solution,
    deform::Pose,
    project::{Blend, Handle, PoseMode, Project, Rotation, ShapeSample, Support},
};
use glam::{DMat2, DVec2};

use crate::{
    following::{drag, farthest, figure, folds, posed},
    scenes::{project, solved},
};

/// Accuracy of a pose that is opened again, in pixels.
const NEAR: f64 = 0.25;

/// Drags the head of the figure around an arm and below it. Returns the project with its shape, its solution, and the
/// pose at rest.
fn dragged() -> (Project, Solution, Pose) {
    let (mut project, solution) = figure();
    let mut pose = solution.pose(&project).expect("a valid scene");
    for to in [(300.0, 60.0), (330.0, 250.0), (200.0, 300.0)].map(DVec2::from) {
        pose = drag(&solution, &mut project.handles, 0, to, 60, pose).1;
    }
    let pose = solution.poser().settle(&pose, &project.handles).expect("a valid scene");
    project.shape = solution.poser().shape_of(&pose).expect("a valid scene");
    (project, solution, pose)
}

fn without_shape(project: &Project) -> Project {
    let mut project = project.clone();
    project.shape.clear();
    project
}

#[test]
fn a_project_opens_in_the_shape_that_a_drag_left() {
    let (project, solution, pose) = dragged();
    let shown = posed(&solution, &pose);
    let plain = posed(&solution, &solution.pose(&without_shape(&project)).expect("a valid scene"));
    assert!(farthest(&shown, &plain) > 20.0, "the drag ends in the pose from rest");
    let text = project.to_json();
    assert!(text.len() - without_shape(&project).to_json().len() < 4096);
    let read = Project::from_json(&text).expect("a valid scene");
    let opened = posed(&solution, &solution.pose(&read).expect("a valid scene"));
    assert!(farthest(&shown, &opened) <= NEAR, "{}", farthest(&shown, &opened));
}

/// Returns a strip whose right end is pushed over its left end, in the pose without a shape. It is as good bent to the
/// other side.
fn strip() -> Project {
    let ring = [(50.0, 180.0), (350.0, 180.0), (350.0, 220.0), (50.0, 220.0)].map(DVec2::from).to_vec();
    let mut project = project(&[ring], &[(70.0, 200.0), (330.0, 200.0)].map(DVec2::from), Support::Smooth);
    (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
    project.handles.iter_mut().for_each(|handle| handle.rotation = Rotation::Auto);
    project.handles[1].shape.posed_mut()[0].x = 170.0;
    project
}

/// The posed places of points along the middle of the strip.
fn middle(project: &Project) -> Vec<DVec2> {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.pose(project).expect("a valid scene");
    (6..35).map(|k| solution.map(&pose, DVec2::new(f64::from(10 * k), 200.0)).expect("a valid scene").posed).collect()
}

#[test]
fn a_shape_outlives_another_density_and_an_added_handle() {
    let mut project = strip();
    let solution = solved(&project).expect("a valid scene");
    let pose = solution.pose(&project).expect("a valid scene");
    let flip = DMat2::from_diagonal([1.0, -1.0].into());
    let flipped = |place: DVec2| flip * place + DVec2::new(0.0, 400.0);
    let plain = middle(&project);
    let other: Vec<DVec2> = plain.iter().copied().map(flipped).collect();
    assert!(farthest(&plain, &other) > 100.0, "the strip is not bent");
    let shape = solution.poser().shape_of(&pose).expect("a valid scene");
    let mirrored = |sample: ShapeSample| {
        ShapeSample::new(flipped(sample.rest), flipped(sample.posed), flip * sample.linear * flip)
    };
    let shapes = [(shape.clone(), plain), (shape.into_iter().map(mirrored).collect(), other)];
    for (shape, expected) in shapes {
        project.shape = shape;
        assert!(farthest(&middle(&project), &expected) < NEAR);
        for density in [60, 150, 220] {
            let mut changed = project.clone();
            changed.pose.density = density;
            let found = middle(&changed);
            assert!(farthest(&found, &expected) < 5.0, "{density}: {}", farthest(&found, &expected));
        }
        let mut pinned = project.clone();
        let handle = Handle::point("middle", [200.0, 200.0]).posed_at([expected[14]]);
        pinned.handles.push(handle.turned(Rotation::Auto));
        let found = middle(&pinned);
        assert!(farthest(&found, &expected) < 5.0, "pinned: {}", farthest(&found, &expected));
    }
}

#[test]
fn nonsense_in_a_shape_ends_in_the_pose_from_rest() {
    let (project, solution, _) = dragged();
    let plain = posed(&solution, &solution.pose(&without_shape(&project)).expect("a valid scene"));
    let edited = |edit: fn(&mut ShapeSample)| {
        let mut project = project.clone();
        project.shape.iter_mut().for_each(edit);
        project
    };
    for (name, project) in [
        ("far", edited(|sample| sample.posed *= 1e9)),
        ("mirrored", edited(|sample| sample.linear = DMat2::from_diagonal([-1.0, 1.0].into()))),
        ("one place", edited(|sample| sample.posed = [7.0, 7.0].into())),
        ("huge", edited(|sample| sample.linear = DMat2::IDENTITY * 1e12)),
        ("flat", edited(|sample| sample.linear = DMat2::ZERO)),
        ("outside", edited(|sample| sample.rest = DVec2::splat(-1e12))),
    ] {
        let pose = solution.pose(&project).expect("a valid scene");
        let opened = posed(&solution, &pose);
        assert_eq!(pose.motions(), solution.pose(&project).expect("a valid scene").motions(), "{name}");
        assert_eq!(folds(&solution, &opened), 0, "{name}");
        assert!(farthest(&opened, &plain) <= NEAR, "{name}: {}", farthest(&opened, &plain));
    }
}

#[test]
fn harmonic_mode_ignores_the_shape() {
    let (mut project, ..) = dragged();
    project.pose.mode = PoseMode::Harmonic;
    let solution = solved(&project).expect("a valid scene");
    let plain = solution.poser().pose(&project.handles, Blend::Linear).expect("a valid scene");
    assert_eq!(solution.pose(&project).expect("a valid scene").motions(), plain.motions());
}
