//! Tests of the falloff between point handles and a held boundary.

use std::f64::consts::{FRAC_PI_2, TAU};

use c2warp::{
    Solution,
    deform::Pose,
    project::{Handle, PoseMode, Support},
};
use glam::DVec2;

use super::{map_point, solve_and_pose};
use crate::scenes::project;

const CENTRE: DVec2 = DVec2::splat(200.0);
/// Part of the way to the outline that the handle is pulled.
const PULLED: f64 = 0.6;
/// The default of projects. The rigid mode measures distortion at some of them, so its poses depend on their number.
const SAMPLES: u32 = 10_000;
/// Step of the second differences, in pixels.
const STEP: f64 = 4.0;
/// Greatest second difference towards a held boundary, over that between handles.
fn as_smooth(mode: PoseMode) -> f64 {
    // A held boundary cannot slide aside, and the energy of what is squeezed against it has no bound.
    if mode == PoseMode::Rigid { 2.0 } else { 1.5 }
}

/// A disc of 360 px and a lock of hair, rounded and 200 by 360 px.
fn outlines() -> [Vec<DVec2>; 2] {
    let turn = |k: i32| DVec2::from_angle(f64::from(k) / 96.0 * TAU);
    let rounded = |x: f64| x.signum() * x.abs().sqrt();
    [
        (0..96).map(|k| CENTRE + 180.0 * turn(k)).collect(),
        (0..96).map(|k| CENTRE + DVec2::new(100.0 * rounded(turn(k).x), 180.0 * rounded(turn(k).y))).collect(),
    ]
}

/// The outline's point in a direction from the centre, a pixel inside.
fn rim(outline: &[DVec2], direction: DVec2) -> DVec2 {
    let crossing = |(&a, &b): (&DVec2, &DVec2)| {
        let (from, edge) = (a - CENTRE, b - a);
        let cross = direction.perp_dot(edge);
        let (far, along) = (from.perp_dot(edge) / cross, from.perp_dot(direction) / cross);
        (far > 0.0 && (0.0..=1.0).contains(&along)).then_some(far)
    };
    let far = outline.iter().zip(outline.iter().cycle().skip(1)).filter_map(crossing).fold(f64::INFINITY, f64::min);
    CENTRE + (far - 1.0) * direction
}

/// The greatest second difference of the displacement on lines through the pulled handle, along the pull and across.
fn greatest_second_difference(solution: &Solution, pose: &Pose, at: DVec2, direction: DVec2) -> f64 {
    let displacement = |p: DVec2| solution.map(pose, p).map(|mapped| mapped.posed - p);
    let lines = [direction, direction.perp()];
    let points = lines.iter().flat_map(|&line| (-100..=100).map(move |k| (line, at + f64::from(k) * STEP * line)));
    let second = |(line, p): (DVec2, DVec2)| {
        let [before, here, after] = [p - STEP * line, p, p + STEP * line].map(displacement);
        Some((before? - 2.0 * here? + after?).length())
    };
    points.filter_map(second).fold(0.0, f64::max)
}

#[test]
fn pull_towards_held_boundary_is_as_smooth_as_between_handles() {
    for (outline, mode) in
        outlines().iter().flat_map(|outline| [(outline, PoseMode::Rigid), (outline, PoseMode::Harmonic)])
    {
        for (start, turn) in [(0.0, 0.0), (0.0, 0.6), (0.5, 0.0), (0.5, FRAC_PI_2)] {
            let direction = DVec2::from_angle(turn);
            let end = rim(outline, direction);
            let rest = CENTRE.lerp(end, start);
            let pulled = Handle::point("pulled", rest).posed_at([rest.lerp(end, PULLED)]);
            let pins = (0..4).map(|k| {
                let direction = DVec2::from_angle(turn + f64::from(k) * FRAC_PI_2);
                Handle::point(format!("pin {k}"), rim(outline, direction))
            });
            let with_pins: Vec<Handle> = std::iter::once(pulled.clone()).chain(pins).collect();
            let [held, between] = [(vec![pulled], true), (with_pins, false)].map(|(handles, is_held)| {
                let mut project = project(std::slice::from_ref(outline), &[], Support::Smooth);
                project = project.with_handles(handles).with_editor_settings();
                (project.fix_boundary, project.pose.mode) = (is_held, mode);
                project.samples = SAMPLES;
                let (solution, pose) = solve_and_pose(&project);
                greatest_second_difference(&solution, &pose, rest, direction)
            });
            assert!(held <= as_smooth(mode) * between, "{mode:?}, {start}, {turn}: {held}, {between} between handles");
        }
    }
}

#[test]
fn close_handles_and_handles_near_a_held_boundary_are_reached() {
    let outline = &outlines()[0];
    let places = [(200.0, 200.0), (212.0, 200.0), (200.0, 250.0), (374.0, 200.0)].map(DVec2::from);
    let handle = |(k, rest): (u32, DVec2)| {
        let by = 4.0 * DVec2::from_angle(f64::from(k));
        Handle::point(format!("{k}"), rest).posed_at([rest + by]).turned(10.0 * f64::from(k))
    };
    let mut project = project(std::slice::from_ref(outline), &[], Support::Smooth);
    project = project.with_handles((0..).zip(places).map(handle));
    (project.fix_boundary, project.pose.density) = (true, 60);
    let (solution, pose) = solve_and_pose(&project);
    for (k, rest) in (0..).zip(places) {
        let expected = rest + 4.0 * DVec2::from_angle(f64::from(k));
        assert!(map_point(&solution, &pose, rest).distance(expected) < 1e-9, "{rest}");
    }
    for &corner in outline {
        assert!(map_point(&solution, &pose, corner).distance(corner) < 1e-9, "{corner}");
    }
}

#[test]
fn gradients_around_handles_in_a_held_boundary_are_those_of_the_weights() {
    let mut project = project(&outlines()[..1], &[], Support::Smooth);
    project = project.with_handles([(200.0, 200.0), (270.0, 200.0)].map(|at| Handle::point(format!("{}", at.0), at)));
    (project.fix_boundary, project.pose.density) = (true, 60);
    let (solution, _) = solve_and_pose(&project);
    let step = 1e-4;
    for k in 0..200 {
        let p = CENTRE + DVec2::new(35.0, 0.0) + 0.5 * f64::from(k) * DVec2::from_angle(2.4 * f64::from(k));
        let weights = |p: DVec2| solution.influences_at(p).expect("inside");
        let here = weights(p);
        let total: f64 = here.iter().map(|one| one.weight).sum();
        assert!((total - 1.0).abs() < 1e-12 && here.iter().all(|one| one.weight >= 0.0), "{p}");
        let at = |p: DVec2, site: usize| weights(p).iter().find(|one| one.site == site).map_or(0.0, |one| one.weight);
        for one in &here {
            let slope = |axis: DVec2| (at(p + step * axis, one.site) - at(p - step * axis, one.site)) / (2.0 * step);
            let gradient = DVec2::new(slope(DVec2::X), slope(DVec2::Y));
            assert!(gradient.distance(one.gradient) < 1e-6, "{p}: {gradient}, {}", one.gradient);
        }
    }
}
