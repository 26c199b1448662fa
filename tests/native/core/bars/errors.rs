//! Tests that invalid bars and poses are rejected.

use c2warp::project::{Blend, Handle, Shape, Support};
use glam::DVec2;

use super::{solve_and_pose, square};
use crate::handles::{bar, point_handle};
use crate::scenes::solved;

#[test]
fn invalid_bars_are_rejected_by_name() {
    let rejected = |handles: Vec<Handle>, fix_boundary: bool| {
        let mut project = square(Support::Paper, handles);
        project.fix_boundary = fix_boundary;
        let error = solved(&project).expect_err("refused");
        (error.code(), error.handles().into_iter().map(String::from).collect::<Vec<_>>(), error.to_string())
    };
    let at_rest = |id: &str, corners: &[(f64, f64)]| bar(id, corners, corners);
    let point = |x: f64, y: f64| point_handle(7, (x, y).into(), (x, y).into(), 0.0);
    for (handles, fix_boundary, code, names) in [
        (vec![at_rest("dot", &[(50.0, 50.0), (50.0, 50.001)])], false, "bar-too-short", &["dot"][..]),
        (vec![at_rest("fold", &[(50.0, 50.0), (90.0, 50.0), (60.0, 50.0)])], false, "bars-overlap", &["fold"]),
        (
            vec![at_rest("one", &[(50.0, 50.0), (90.0, 50.0)]), at_rest("two", &[(70.0, 50.0), (120.0, 50.0)])],
            false,
            "bars-overlap",
            &["one", "two"],
        ),
        (
            vec![at_rest("bar", &[(50.0, 50.0), (90.0, 50.0)]), point(70.0, 50.005)],
            false,
            "handles-too-close",
            &["h7", "bar"],
        ),
        (vec![at_rest("far", &[(5.0, 5.0), (15.0, 15.0)])], false, "handle-outside", &["far"]),
        // Too many segments to compare each pair.
        (
            vec![at_rest("few", &[(50.0, 50.0), (90.0, 50.0)]), at_rest("long", &winding(200_000))],
            false,
            "too-many-corners",
            &["long"],
        ),
        (vec![at_rest("edge", &[(20.5, 50.0), (20.5, 90.0)])], true, "on-held-boundary", &["edge"]),
        (vec![point(20.5, 90.0)], true, "on-held-boundary", &["h7"]),
    ] {
        let (found, named, message) = rejected(handles, fix_boundary);
        assert_eq!(found, code, "{message}");
        assert_eq!(named, names, "{message}");
        assert!(names.iter().all(|name| message.contains(&format!("“{name}”"))), "{message}");
    }
}

/// Returns corners on an inward spiral.
fn winding(corners: u32) -> Vec<(f64, f64)> {
    let at = |i: u32| {
        let t = f64::from(i) / f64::from(corners);
        DVec2::splat(200.0) + (100.0 - 80.0 * t) * DVec2::from_angle(20.0 * t)
    };
    (0..corners).map(|i| at(i).into()).collect()
}

#[test]
fn pose_of_other_handles_is_rejected_by_name() {
    let at_rest = |id: &str, corners: &[(f64, f64)]| bar(id, corners, corners);
    let point = |x: f64, y: f64| point_handle(1, DVec2::new(x, y), DVec2::new(x, y), 0.0);
    let corners = [(50.0, 50.0), (90.0, 50.0), (90.0, 90.0)];
    let (solution, _) = solve_and_pose(&square(Support::Paper, vec![at_rest("bar", &corners), point(150.0, 150.0)]));
    let rejected = |handles: &[Handle]| match solution.poser().pose(handles, Blend::Linear) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("a pose was made for other handles: {handles:?}"),
    };
    let dot = point(150.0, 150.0);
    assert_eq!(
        rejected(std::slice::from_ref(&dot)),
        "the pose has 1 handles, but the solution has 2: pass every handle of the solution"
    );
    assert_eq!(
        rejected(&[at_rest("bar", &corners[..2]), dot.clone()]),
        "handle “bar” is posed as a bar of 2 corners, but was solved as a bar of 3 corners"
    );
    assert_eq!(
        rejected(&[dot.clone(), at_rest("barre", &corners)]),
        "the pose lacks handle “bar” of the solution: pass every handle of the solution"
    );
    let mut uneven = at_rest("bar", &corners);
    let Shape::Bar { posed, .. } = &mut uneven.shape else { unreachable!("a bar") };
    posed.push(DVec2::splat(100.0));
    assert_eq!(
        rejected(&[uneven, dot.clone()]),
        "handle “bar” is posed as a bar of 4 corners, but was solved as a bar of 3 corners"
    );
    let mut closed = at_rest("bar", &corners);
    closed.shape = Shape::Polygon { rest: corners.map(DVec2::from).to_vec(), posed: corners.map(DVec2::from).to_vec() };
    assert_eq!(
        rejected(&[closed, dot.clone()]),
        "handle “bar” is posed as a polygon of 3 corners, but was solved as a bar of 3 corners"
    );
    assert_eq!(
        rejected(&[at_rest("bar", &corners), at_rest("h1", &corners)]),
        "handle “h1” is posed as a bar of 3 corners, but was solved as a point"
    );
}
