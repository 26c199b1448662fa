//! Tests that symmetric scenes have symmetric results, and that a flipped scene has the flipped result.
//!
//! The random scenes contain everything on the axis that chance might decide.

use c2warp::{
    Error, Picture, Solution,
    deform::Pose,
    project::{DomainSpec, Handle, PoseMode, Project, Rotation, Shape, Support},
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;
use proptest::prelude::*;

use crate::{
    alpha_shapes::{coverage, stroke},
    handles::{bar, polygon},
    scenes::{SIZE, cases, is_inside, project, solved, spread, symmetric_within},
};

/// Tolerance in pixels, for rounding and its amplification by poses.
const SYMMETRIC: f64 = 1e-6;

/// Mirrors a point left to right.
fn mirrored(p: DVec2) -> DVec2 {
    DVec2::new(400.0 - p.x, p.y)
}

/// Flips a point upside down.
fn flipped(p: DVec2) -> DVec2 {
    DVec2::new(p.x, 400.0 - p.y)
}

/// Returns a handle whose rotation is left to the solver.
fn handle(id: usize, shape: Shape) -> Handle {
    Handle::new(format!("h{id}"), shape).turned(Rotation::Auto)
}

/// Returns the shape with every point transformed.
fn transformed(shape: &Shape, transform: impl Fn(DVec2) -> DVec2) -> Shape {
    let all = |points: &[DVec2]| points.iter().map(|&p| transform(p)).collect();
    match shape {
        Shape::Point { rest, posed } => Shape::Point { rest: transform(*rest), posed: transform(*posed) },
        Shape::Bar { rest, posed } => Shape::Bar { rest: all(rest), posed: all(posed) },
        Shape::Polygon { rest, posed } => Shape::Polygon { rest: all(rest), posed: all(posed) },
    }
}

/// Symmetric rings: an outline with a random width at several heights, and holes in pairs or on the axis.
fn symmetric_rings() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let outline = proptest::collection::vec((0.1..0.9_f64, 15.0..185.0_f64), 3..12);
    let holes = proptest::collection::vec((any::<bool>(), 0.0..150.0_f64, 40.0..360.0_f64, 4.0..25.0_f64), 0..3);
    (outline, holes).prop_map(|(outline, holes)| {
        let levels = outline.len() as f64;
        let corner = |(at, &(fraction, width)): (usize, &(f64, f64))| {
            DVec2::new(200.0 + width, 20.0 + 360.0 * (at as f64 + fraction) / levels)
        };
        let right: Vec<DVec2> = outline.iter().enumerate().map(corner).collect();
        let left = right.iter().rev().map(|&p| mirrored(p));
        let mut rings = vec![right.iter().copied().chain(left).collect()];
        for (is_on_axis, x, y, size) in holes {
            let ring = |at: DVec2, shape: &[(f64, f64)]| -> Vec<DVec2> {
                shape.iter().map(|&corner| at + size * DVec2::from(corner)).collect()
            };
            if is_on_axis {
                rings.push(ring(DVec2::new(200.0, y), &[(0.0, -1.0), (1.0, 0.3), (0.0, 1.0), (-1.0, 0.3)]));
            } else if x > size + 3.0 {
                let hole = ring(DVec2::new(200.0 + x, y), &[(0.0, -1.0), (1.0, 0.2), (-0.5, 1.0)]);
                rings.push(hole.iter().map(|&p| mirrored(p)).collect());
                rings.push(hole);
            }
        }
        rings
    })
}

/// Handles in pairs and on the axis. Some may be outside the domain.
fn symmetric_handles() -> impl Strategy<Value = Vec<Handle>> {
    let by = || (-20.0..20.0_f64, -20.0..20.0_f64).prop_map(DVec2::from);
    let pairs = proptest::collection::vec(((3.0..180.0_f64, 20.0..380.0_f64), by()), 0..4);
    let middle = proptest::collection::vec((20.0..380.0_f64, -20.0..20.0_f64), 0..3);
    let bar = ((8.0..150.0_f64, 20.0..380.0_f64), (-5.0..60.0_f64, -40.0..40.0_f64), by());
    (pairs, middle, proptest::option::weighted(0.3, bar)).prop_map(|(pairs, middle, bar)| {
        let mut shapes = Vec::new();
        for ((x, y), by) in pairs {
            let rest = DVec2::new(200.0 + x, y);
            shapes.push(Shape::Point { rest, posed: rest + by });
        }
        if let Some(((x, y), along, by)) = bar {
            let rest = vec![DVec2::new(200.0 + x, y), DVec2::new(200.0 + x, y) + DVec2::from(along)];
            shapes.push(Shape::Bar { posed: vec![rest[0], rest[1] + by], rest });
        }
        let others: Vec<Shape> = shapes.iter().map(|shape| transformed(shape, mirrored)).collect();
        shapes.extend(others);
        shapes.extend(middle.into_iter().map(|(y, by)| {
            let rest = DVec2::new(200.0, y);
            Shape::Point { rest, posed: rest + DVec2::new(0.0, by) }
        }));
        shapes.into_iter().enumerate().map(|(id, shape)| handle(id, shape)).collect()
    })
}

/// Symmetric scenes of every kind. Some of them are invalid.
fn symmetric_scenes() -> impl Strategy<Value = Project> {
    let support = prop_oneof![Just(Support::Paper), Just(Support::Smooth)];
    let mode = prop_oneof![Just(PoseMode::Harmonic), Just(PoseMode::Rigid)];
    let numbers = (prop_oneof![Just(500_u32), Just(2000)], prop_oneof![Just(0_u32), Just(10), Just(40), Just(100)]);
    let scene = (symmetric_rings(), symmetric_handles());
    (scene, support, mode, numbers, prop::bool::weighted(0.15)).prop_map(
        |((rings, handles), support, mode, (samples, density), fix_boundary)| {
            let mut project = project(&rings, &[], support);
            let is_kept =
                |handle: &Handle| !matches!(handle.shape, Shape::Point { rest, .. } if !is_inside(&rings, rest));
            project.handles = handles.into_iter().filter(is_kept).collect();
            (project.pose.mode, project.pose.density) = (mode, density);
            (project.samples, project.fix_boundary) = (samples, fix_boundary);
            project
        },
    )
}

/// Solves and poses a scene, with its tolerance in pixels. Returns `None` if it is invalid, if it is nearly folded, or
/// if anything rotates by about 180°.
///
/// On the axis of symmetry, such a rotation has no preferred direction.
fn posed(project: &Project) -> Option<(Solution, Pose, f64)> {
    posed_as(project, solved(project))
}

fn posed_as(project: &Project, solved: Result<Solution, Error>) -> Option<(Solution, Pose, f64)> {
    let solution = solved.ok().filter(|_| !project.handles.is_empty())?;
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    let within = symmetric_within(project.pose.mode, &solution, &pose)?;
    pose.motions().iter().all(|motion| motion.angle.abs() < 3.0).then_some((solution, pose, within))
}

/// Checks that two scenes have the same sites and posed points, up to a transform.
fn check_same(
    (here, pose): (&Solution, &Pose),
    (there, other): (&Solution, &Pose),
    within: f64,
    transform: impl Fn(DVec2) -> DVec2,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(here.sites().len(), there.sites().len());
    for site in here.sites() {
        let error =
            there.sites().iter().map(|other| transform(site.rest).distance(other.rest)).fold(f64::INFINITY, f64::min);
        prop_assert!(error <= SYMMETRIC, "the site at {} is {error} px off", site.rest);
    }
    for p in spread(1000) {
        if let (Some(one), Some(two)) = (here.map(pose, p), there.map(other, transform(p))) {
            let error = transform(one.posed).distance(two.posed);
            prop_assert!(error <= within, "{p} is mapped to {}, {error} px off", one.posed);
        }
    }
    Ok(())
}

/// A joint, or a sample on a bone, may belong to several bones. The choice must not depend on chance.
#[test]
fn crossing_touching_and_clipped_bars_are_mirrored() {
    let crossing = bar("crossing", &[(80.0, 80.0), (320.0, 300.0)], &[(100.0, 60.0), (340.0, 320.0)]);
    let crossed = bar("crossed", &[(300.0, 100.0), (120.0, 340.0)], &[(280.0, 120.0), (80.0, 300.0)]);
    let long = bar("long", &[(40.0, 200.0), (360.0, 220.0)], &[(40.0, 180.0), (360.0, 240.0)]);
    let touching = bar("touching", &[(200.0, 40.0), (200.0, 210.0)], &[(220.0, 60.0), (200.0, 210.0)]);
    let simple = [(80.0, 100.0), (300.0, 80.0), (260.0, 320.0), (140.0, 240.0)];
    let twisted = [(80.0, 100.0), (300.0, 300.0), (280.0, 80.0), (100.0, 320.0)];
    let clipped = [(120.0, 120.0), (480.0, 100.0), (460.0, 280.0), (140.0, 300.0)];
    let sheared = |rest: &[(f64, f64)]| {
        let posed: Vec<(f64, f64)> =
            rest.iter().map(|&(x, y)| (0.9 * x + 0.1 * y + 14.0, 1.1 * y - 0.05 * x + 6.0)).collect();
        polygon("polygon", rest, &posed)
    };
    for handles in [
        vec![crossing, crossed],
        vec![long, touching],
        vec![sheared(&simple)],
        vec![sheared(&twisted)],
        vec![sheared(&clipped)],
    ] {
        for density in [0, 60] {
            let mut project = project(&[], &[], Support::Smooth);
            (project.domain, project.samples, project.handles) = (None, 300, handles.clone());
            (project.pose.mode, project.pose.density) = (PoseMode::Rigid, density);
            let (solution, pose, within) = posed(&project).expect("a valid scene");
            for transform in [mirrored, flipped] {
                let mut other = project.clone();
                for handle in &mut other.handles {
                    handle.shape = transformed(&handle.shape, transform);
                }
                let (there, other, _) = posed(&other).expect("the transformed scene is valid as well");
                check_same((&solution, &pose), (&there, &other), within, transform).expect("the same");
            }
        }
    }
}

/// Pictures of limbs in pairs and one on the axis, with handles at their ends. The outline comes from alpha, with soft
/// or hard edges.
#[test]
fn symmetric_pictures_have_symmetric_results() {
    let size = f64::from(SIZE);
    let mut random = Random(5);
    let mut compared = 0;
    for case in 0..24 {
        let mut within = |low: f64, high: f64| low + (high - low) * random.unit();
        let middle = DVec2::new(size / 2.0, size / 2.0);
        let ends: Vec<DVec2> = (0..3).map(|_| DVec2::new(within(220.0, 380.0), within(20.0, 380.0))).collect();
        let limbs: Vec<(DVec2, f64)> = ends.iter().map(|&end| (end, within(14.0, 60.0))).collect();
        let moves: Vec<DVec2> = ends.iter().map(|_| DVec2::new(within(-25.0, 25.0), within(-25.0, 25.0))).collect();
        let limb = |p: DVec2| limbs.iter().map(|&(end, w)| stroke(middle, end, w)(p)).fold(f64::MIN, f64::max);
        let drawn = coverage(|p| limb(p).max(limb(mirrored(p))).max(stroke(middle, DVec2::new(200.0, 20.0), 33.0)(p)));
        let alpha = |x, y| if case % 2 == 0 { drawn(x, y) } else { 255 * u8::from(drawn(x, y) > 127) };
        let rgba: Vec<u8> = (0..SIZE * SIZE).flat_map(|i| [0, 0, 0, alpha(i % SIZE, i / SIZE)]).collect();
        let picture = Picture::new(SIZE, SIZE, &rgba).expect("a valid size");
        let mut shapes: Vec<Shape> =
            ends.iter().zip(&moves).map(|(&rest, &by)| Shape::Point { rest, posed: rest + by }).collect();
        shapes.extend(shapes.clone().iter().map(|shape| transformed(shape, mirrored)));
        shapes.push(Shape::Point { rest: DVec2::new(200.0, 24.0), posed: DVec2::new(200.0, 10.0) });
        let mut project = project(&[], &[], if case % 3 == 0 { Support::Paper } else { Support::Smooth });
        project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
        project.handles = shapes.into_iter().enumerate().map(|(id, shape)| handle(id, shape)).collect();
        for (mode, density) in [(PoseMode::Harmonic, 0), (PoseMode::Rigid, 60)] {
            (project.pose.mode, project.pose.density) = (mode, density);
            let Some((solution, pose, within)) = posed_as(&project, solve(&project, &picture)) else { continue };
            check_same((&solution, &pose), (&solution, &pose), within, mirrored).expect("symmetric");
            compared += 1;
        }
    }
    assert!(compared > 36, "{compared}");
}

proptest! {
    #![proptest_config(cases(96))]

    #[test]
    fn symmetric_scenes_have_symmetric_results(project in symmetric_scenes()) {
        let found = posed(&project);
        prop_assume!(found.is_some());
        let (solution, pose, within) = found.expect("as assumed");
        check_same((&solution, &pose), (&solution, &pose), within, mirrored)?;
    }

    #[test]
    fn flipped_scenes_have_flipped_results(project in symmetric_scenes(), removed in 0..8_usize) {
        // Removing a handle usually breaks the left-right symmetry.
        let mut project = project;
        if removed < project.handles.len() {
            project.handles.swap_remove(removed);
        }
        let found = posed(&project);
        prop_assume!(found.is_some());
        let (solution, pose, within) = found.expect("as assumed");
        let mut other = project.clone();
        other.domain = Some(DomainSpec::polygon(
            solution.domain().rings().iter().map(|ring| ring.iter().rev().map(|&p| flipped(p)).collect()).collect(),
        ));
        for handle in &mut other.handles {
            handle.shape = transformed(&handle.shape, flipped);
        }
        // Rounding decides whether a scene next to a bound is left out.
        let Some((there, other, _)) = posed(&other) else { return Ok(()) };
        check_same((&solution, &pose), (&there, &other), within, flipped)?;
    }
}
