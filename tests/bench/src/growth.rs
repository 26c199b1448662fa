//! Scenes that grow: handles, holes, corners, islands and bars by powers of ten, and the worst known scenes.

use std::f64::consts::{SQRT_2, TAU};

use c2warp::{
    limits::MAX_OUTLINE_LENGTH,
    project::{Continuity, DomainSpec, Handle, Project},
};
use glam::DVec2;

use crate::cases::{handle, spread};

/// Width and height of the pictures, in pixels.
pub const SIDE: f64 = 1000.0;

/// A series of scenes.
#[derive(Debug, Clone, Copy)]
pub struct Series {
    /// The things that are counted.
    pub name: &'static str,
    /// Returns the scene with this number of things.
    pub scene: fn(usize) -> Project,
    /// The numbers of the table.
    pub counts: &'static [usize],
}

const POWERS: &[usize] = &[100, 1_000, 10_000, 100_000];

/// The scenes with 10² to 10⁵ things of one kind.
pub const GROWTH: &[Series] = &[
    Series { name: "handles", scene: handles, counts: POWERS },
    Series { name: "holes", scene: holes, counts: POWERS },
    Series { name: "corners", scene: gear, counts: POWERS },
    Series { name: "islands", scene: islands, counts: POWERS },
    Series { name: "bars", scene: bars, counts: POWERS },
];

/// The worst known scenes, by the number of things that makes them so.
pub const WORST: &[Series] = &[
    Series { name: "handles in a line, 1/50 px apart", scene: line, counts: &[50, 51] },
    Series { name: "handles in a line, 3 px apart", scene: wide_line, counts: &[100, 300] },
    Series { name: "bars among a thousand holes", scene: bars_among_holes, counts: &[2, 10, 100, 500] },
    Series { name: "long rays of a star", scene: star, counts: &[100, 300, 1_000] },
    Series { name: "handles in a star of 300 rays", scene: handles_in_star, counts: &[10, 50, 100] },
    Series { name: "handles around a wide hub", scene: handles_around_hub, counts: &[300, 600, 1_000] },
    Series { name: "handles among a thousand holes", scene: handles_among_holes, counts: &[10, 100, 1_000] },
    Series { name: "turns of a spiral", scene: spiral, counts: &[10, 50, 100] },
    Series { name: "held rays of a star with 100 handles", scene: held_star, counts: &[100, 300, 499] },
    Series { name: "px across the base of a held needle", scene: held_needle, counts: &[100, 10, 2, 1] },
    Series { name: "small triangular holes, C²", scene: smooth_holes, counts: &[100, 400, 1_000, 2_000] },
];

fn project() -> Project {
    Project::for_picture(SIDE as u32, SIDE as u32).with_editor_settings()
}

fn handles(count: usize) -> Project {
    let points = spread(DVec2::splat(SIDE)).take(count);
    project().with_handles(points.enumerate().map(|(id, at)| handle(id, at)))
}

fn line(count: usize) -> Project {
    line_of(count, 1.0 / 50.0)
}

fn wide_line(count: usize) -> Project {
    line_of(count, 3.0)
}

fn line_of(count: usize, gap: f64) -> Project {
    let at = |id: usize| DVec2::new((SIDE - count as f64 * gap) / 2.0 + id as f64 * gap, SIDE / 2.0);
    project().with_handles((0..count).map(|id| handle(id, at(id))))
}

fn bars(count: usize) -> Project {
    let room = DVec2::splat(SIDE - 20.0);
    let step = SIDE / (count as f64).sqrt();
    let bar = |(id, at): (usize, DVec2)| {
        let from = at + DVec2::splat(10.0);
        Handle::bar(format!("b{id}"), [from, from + DVec2::from_angle(id as f64) * (step / 4.0).min(9.0)])
    };
    project().with_handles(grid(count).map(|at| at * room).enumerate().map(bar))
}

fn holes(count: usize) -> Project {
    with_six_handles(among_holes(count))
}

/// Handles along the left edge.
fn with_six_handles(project: Project) -> Project {
    project.with_handles((0..6).map(|id| handle(id, DVec2::new(1.0, 1.0 + id as f64 * SIDE / 6.0))))
}

fn bars_among_holes(count: usize) -> Project {
    let bar = |id: usize| {
        let y = (id as f64 + 0.5) / count as f64 * SIDE;
        Handle::bar(format!("b{id}"), [DVec2::new(1.0, y), DVec2::new(SIDE - 1.0, y)])
    };
    let mut project = among_holes(1_000);
    project.handles = (0..count).map(bar).collect();
    project
}

fn handles_among_holes(count: usize) -> Project {
    let mut project = among_holes(1_000);
    let (columns, step) = pitch(1_000);
    let between = |id: usize| DVec2::new((id % columns) as f64, (id / columns) as f64) * step + step * 0.05;
    project.handles = (0..count).map(|id| handle(id, between(id))).collect();
    project
}

fn among_holes(count: usize) -> Project {
    with_holes(count, |at, step| square(at + step / 4.0, step / 2.0))
}

/// A picture with a hole in each square of a grid, by the corner and the side of the square.
fn with_holes(count: usize, hole: impl Fn(DVec2, f64) -> Vec<DVec2>) -> Project {
    let (_, step) = pitch(count);
    rings(std::iter::once(square(DVec2::ZERO, SIDE)).chain(squares(count).map(|at| hole(at, step))))
}

fn islands(count: usize) -> Project {
    let (_, step) = pitch(count);
    let mut project = rings(squares(count).map(|at| square(at, step / 2.0)));
    let at = squares(count).map(|at| at + step / 4.0);
    project.handles = at.step_by(count.div_ceil(6)).enumerate().map(|(id, at)| handle(id, at)).collect();
    project
}

/// A disc with teeth, half of whose corners are reflex.
fn gear(count: usize) -> Project {
    let teeth = SIDE / count as f64;
    star_of(count, SIDE / 2.0 - teeth.min(SIDE / 4.0))
}

fn star(rays: usize) -> Project {
    star_of(2 * rays, 30.0)
}

fn handles_in_star(count: usize) -> Project {
    let rays = 300;
    let mut project = star(rays);
    let tip = |id: usize| on_circle(id as f64 * (rays / count) as f64 / rays as f64, SIDE * 0.45);
    project.handles = (0..count).map(|id| handle(id, tip(id))).collect();
    project
}

fn held_star(rays: usize) -> Project {
    let mut project = star_of(2 * rays, 0.3 * SIDE);
    project.fix_boundary = true;
    project.pose.density = 0;
    let places = spread(DVec2::splat(0.4 * SIDE)).take(100);
    project.handles = places.enumerate().map(|(id, at)| handle(id, at + 0.3 * SIDE)).collect();
    project
}

/// Each virtual site needs sites on both sides.
fn held_needle(width: usize) -> Project {
    let corners = [(0.0, 0.0), (SIDE, width as f64 / 2.0), (0.0, width as f64)].map(DVec2::from);
    let mut project = rings([corners.to_vec()]);
    project.fix_boundary = true;
    project.pose.density = 100;
    project
}

/// Paths around each hole are of two kinds, and no support may have both.
fn smooth_holes(count: usize) -> Project {
    let corner = |id: i32| DVec2::from_angle(0.1 + f64::from(id) * TAU / 3.0);
    let triangle = |at: DVec2, step: f64| (0..3).map(|id| at + step * (0.5 + 0.15 * corner(id))).collect();
    let mut project = with_six_handles(with_holes(count, triangle));
    project.weighting.continuity = Continuity::C2;
    project
}

/// Rays around a wide hub, as long as an outline may be, with a handle in each: all reach into the hub.
fn handles_around_hub(rays: usize) -> Project {
    let inner = SIDE / 2.0 - 0.99 * MAX_OUTLINE_LENGTH * SIDE * SQRT_2 / (2.0 * rays as f64);
    let mut project = star_of(2 * rays, inner);
    project.pose.density = 0;
    project.handles = (0..rays).map(|id| handle(id, on_circle(id as f64 / rays as f64, SIDE * 0.49))).collect();
    project
}

fn star_of(corners: usize, inner: f64) -> Project {
    let corner =
        |at: usize| on_circle(at as f64 / corners as f64, if at.is_multiple_of(2) { SIDE / 2.0 } else { inner });
    let mut project = rings([(0..corners).map(corner).collect()]);
    project.handles = (0..6).map(|id| handle(id, on_circle(id as f64 / 6.0, 25.0))).collect();
    project
}

/// A corridor in turns around the middle.
fn spiral(turns: usize) -> Project {
    let steps = turns * 24;
    let at = |step: f64, side: f64| {
        let turn = step / 24.0;
        on_circle(turn, (turn + side) / (turns as f64 + 1.0) * SIDE * 0.49)
    };
    let outer = (0..=steps).map(|step| at(step as f64, 0.6));
    let inner = (0..=steps).rev().map(|step| at(step as f64, 0.1));
    let mut project = rings([outer.chain(inner).collect()]);
    let middle = |id: usize| at((id * steps / 6) as f64 + 12.0, 0.35);
    project.handles = (0..6).map(|id| handle(id, middle(id))).collect();
    project
}

fn rings(rings: impl IntoIterator<Item = Vec<DVec2>>) -> Project {
    let mut project = project();
    project.domain = Some(DomainSpec::polygon(rings.into_iter().collect()));
    project
}

fn square(at: DVec2, side: f64) -> Vec<DVec2> {
    [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| at + corner * side).to_vec()
}

/// A point on a circle around the middle, by the fraction of a turn.
fn on_circle(turn: f64, radius: f64) -> DVec2 {
    DVec2::splat(SIDE / 2.0) + DVec2::from_angle(turn * TAU) * radius
}

/// The corners of squares that cover the picture.
fn squares(count: usize) -> impl Iterator<Item = DVec2> {
    grid(count).map(|at| at * SIDE)
}

fn grid(count: usize) -> impl Iterator<Item = DVec2> {
    let (columns, _) = pitch(count);
    (0..count).map(move |id| DVec2::new((id % columns) as f64, (id / columns) as f64) / columns as f64)
}

/// The columns of a square grid, and its step in pixels.
fn pitch(count: usize) -> (usize, f64) {
    let columns = (count as f64).sqrt().ceil() as usize;
    (columns, SIDE / columns as f64)
}
