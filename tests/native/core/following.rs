//! Tests of drags in the rigid mode: the picture follows the hand without jumps or folds, and comes to rest.

use c2warp::{
    Error, Solution,
    deform::Pose,
    project::{Blend, Handle, PoseMode, Project, Rotation, Support},
};
use c2warp_tests::outlines;
use glam::DVec2;

use crate::scenes::{project, solved};

/// No vertex may move farther than this many times the handle in a frame.
const FARTHEST: f64 = 3.0;

/// Returns a gingerbread figure whose hands, head and feet are handles.
pub(crate) fn figure() -> (Project, Solution) {
    let handles = [(200.0, 52.0), (68.0, 144.0), (332.0, 144.0), (124.0, 356.0), (276.0, 356.0)].map(DVec2::from);
    let smaller = |ring: Vec<DVec2>| ring.into_iter().map(|p| p * 0.4).collect();
    let rings: outlines::Rings = outlines::gingerbread().into_iter().map(smaller).collect();
    let mut project = project(&rings, &handles, Support::Smooth);
    (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 100);
    project.handles.iter_mut().for_each(|handle| handle.rotation = Rotation::Auto);
    let solution = solved(&project).expect("a valid scene");
    (project, solution)
}

pub(crate) fn posed(solution: &Solution, pose: &Pose) -> Vec<DVec2> {
    solution.posed_vertices(pose)[..solution.samples()].to_vec()
}

pub(crate) fn farthest(a: &[DVec2], b: &[DVec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

pub(crate) fn folds(solution: &Solution, posed: &[DVec2]) -> usize {
    let area = |places: &[DVec2], [a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|vertex| places[vertex as usize]);
        (b - a).perp_dot(c - a)
    };
    let drawn = solution.triangles().iter().filter(|all| all.iter().all(|&v| (v as usize) < posed.len()));
    drawn.filter(|&&triangle| area(posed, triangle) * area(solution.vertices(), triangle) < 0.0).count()
}

/// Drags a handle along a line. Returns the greatest ratio of a vertex to the handle, and the last pose.
pub(crate) fn drag(
    solution: &Solution,
    handles: &mut [Handle],
    index: usize,
    to: DVec2,
    frames: u32,
    from: Pose,
) -> (f64, Pose) {
    let start = handles[index].shape.posed()[0];
    let (mut pose, mut worst) = (from, 0.0_f64);
    let mut before = posed(solution, &pose);
    for frame in 1..=frames {
        handles[index].shape.posed_mut()[0] = start.lerp(to, f64::from(frame) / f64::from(frames));
        pose = solution.poser().follow(&pose, handles).expect("finite");
        let after = posed(solution, &pose);
        worst = worst.max(farthest(&before, &after) * f64::from(frames) / start.distance(to));
        before = after;
    }
    (worst, pose)
}

#[test]
fn no_drag_jumps_or_folds_and_handles_arrive() {
    let (project, solution) = figure();
    for index in 0..project.handles.len() {
        let mut handles = project.handles.clone();
        let from = handles[index].shape.rest()[0];
        let to = from.lerp(DVec2::new(200.0, 208.0), 1.5);
        let start = solution.poser().pose(&handles, Blend::Linear).unwrap();
        let (worst, pose) = drag(&solution, &mut handles, index, to, 60, start);
        assert!(worst <= FARTHEST, "handle {index}: {worst}");
        assert_eq!(folds(&solution, &posed(&solution, &pose)), 0, "handle {index}");
        assert!(solution.map(&pose, from).unwrap().posed.distance(to) < 1e-9, "handle {index}");
    }
}

#[test]
fn a_drag_out_and_back_ends_where_it_began() {
    let (project, solution) = figure();
    let mut handles = project.handles.clone();
    let start = solution.poser().pose(&handles, Blend::Linear).unwrap();
    let (rest, from) = (posed(&solution, &start), handles[2].shape.rest()[0]);
    let (_, out) = drag(&solution, &mut handles, 2, DVec2::new(224.0, 96.0), 40, start);
    let (_, back) = drag(&solution, &mut handles, 2, from, 40, out);
    let settled = solution.poser().settle(&back, &handles).unwrap();
    assert!(farthest(&posed(&solution, &settled), &rest) < 1e-6);
}

#[test]
fn at_rest_the_picture_stays_and_is_no_worse_than_without_history() {
    let (project, solution) = figure();
    let mut handles = project.handles.clone();
    let start = solution.poser().pose(&handles, Blend::Linear).unwrap();
    let (_, pose) = drag(&solution, &mut handles, 1, DVec2::new(256.0, 280.0), 50, start);
    let settled = solution.poser().settle(&pose, &handles).unwrap();
    let again = solution.poser().settle(&settled, &handles).unwrap();
    let moved = farthest(&posed(&solution, &settled), &posed(&solution, &again));
    assert!(moved < 0.05, "{moved}");
    assert_eq!(folds(&solution, &posed(&solution, &settled)), 0);
}

#[test]
fn a_frame_that_moves_nothing_changes_little_and_a_long_one_is_divided() {
    let (project, solution) = figure();
    let mut handles = project.handles.clone();
    let start = solution.poser().pose(&handles, Blend::Linear).unwrap();
    let same = solution.poser().follow(&start, &handles).unwrap();
    assert!(farthest(&posed(&solution, &start), &posed(&solution, &same)) < 1e-9);
    handles[2].shape.posed_mut()[0] = DVec2::new(224.0, 96.0);
    let leapt = solution.poser().follow(&start, &handles).unwrap();
    assert_eq!(folds(&solution, &posed(&solution, &leapt)), 0);
}

#[test]
fn a_pose_of_another_solution_is_refused() {
    let (project, solution) = figure();
    let mut sparse = project.clone();
    sparse.pose.density = 60;
    let other = solved(&sparse).unwrap();
    let pose = other.poser().pose(&project.handles, Blend::Linear).unwrap();
    assert_eq!(solution.poser().follow(&pose, &project.handles).unwrap_err(), Error::PoseOfAnotherSolution);
    assert_eq!(solution.poser().settle(&pose, &project.handles).unwrap_err(), Error::PoseOfAnotherSolution);
}
