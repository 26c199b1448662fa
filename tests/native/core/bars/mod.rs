//! Tests of bars and polygons, and the scenes that they share.

mod errors;
mod held_boundary;
mod held_falloff;
mod interpolation;
mod joints;
mod outline;
mod polygons;
mod random;
mod rigid_mode;
mod site_counts;

use c2warp::{
    Solution,
    deform::Pose,
    project::{Handle, Project, Shape, Support},
};
use glam::DVec2;

use crate::handles::{bar, point_handle, points, polygon};
use crate::scenes::{project, solved};

/// Tolerance for points on a bar, in pixels.
const ON_BAR: f64 = 1e-6;

/// Returns a project whose domain is a square of 360 px.
fn square(support: Support, handles: Vec<Handle>) -> Project {
    let ring = points(&[(20.0, 20.0), (380.0, 20.0), (380.0, 380.0), (20.0, 380.0)]);
    let mut project = project(&[ring], &[], support);
    project.handles = handles;
    project
}

/// Solves a project and poses it.
fn solve_and_pose(project: &Project) -> (Solution, Pose) {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    (solution, pose)
}

/// Returns the posed position of `p`.
fn map_point(solution: &Solution, pose: &Pose, p: DVec2) -> DVec2 {
    solution.map(pose, p).expect("inside").posed
}

/// Parameters along a segment, some of them close to its ends.
fn parameters() -> impl Iterator<Item = f64> {
    (0..=100).map(|i| f64::from(i) / 100.0).chain([1e-9, 1e-4, 1.0 - 1e-4])
}

/// Asserts that the warp maps each segment of `rest` linearly to the same segment of `posed`.
fn check_on_line(solution: &Solution, pose: &Pose, rest: &[DVec2], posed: &[DVec2], closed: bool) {
    let n = rest.len();
    for i in 0..if closed { n } else { n - 1 } {
        let j = (i + 1) % n;
        for t in parameters() {
            let (at, expected) = (map_point(solution, pose, rest[i].lerp(rest[j], t)), posed[i].lerp(posed[j], t));
            assert!(at.distance(expected) <= ON_BAR, "{t} of segment {i}: {at}, not {expected}");
        }
    }
}

/// Asserts that the warp interpolates all handles.
fn check_lines(project: &Project, solution: &Solution, pose: &Pose) {
    for handle in &project.handles {
        match &handle.shape {
            Shape::Point { rest, posed } => assert!(map_point(solution, pose, *rest).distance(*posed) <= ON_BAR),
            Shape::Bar { rest, posed } => check_on_line(solution, pose, rest, posed, false),
            Shape::Polygon { rest, posed } => check_on_line(solution, pose, rest, posed, true),
        }
    }
}

/// Returns two bars, a polygon and three points.
fn all_kinds() -> Vec<Handle> {
    vec![
        bar("straight", &[(60.0, 80.0), (200.0, 100.0)], &[(60.0, 60.0), (230.0, 120.0)]),
        bar(
            "bent",
            &[(60.0, 330.0), (120.0, 300.0), (140.0, 340.0), (230.0, 345.0)],
            &[(50.0, 320.0), (125.0, 310.0), (140.0, 360.0), (220.0, 330.0)],
        ),
        polygon(
            "eye",
            &[(260.0, 200.0), (320.0, 190.0), (330.0, 240.0), (280.0, 260.0)],
            &[(250.0, 200.0), (320.0, 180.0), (335.0, 240.0), (285.0, 265.0)],
        ),
        point_handle(3, (120.0, 200.0).into(), (135.0, 190.0).into(), 30.0),
        point_handle(4, (296.0, 222.0).into(), (290.0, 220.0).into(), 0.0),
        point_handle(5, (130.0, 95.0).into(), (140.0, 100.0).into(), 0.0),
    ]
}
