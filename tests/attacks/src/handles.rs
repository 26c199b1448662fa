//! Handles of any shape and pose, with any settings.

use arbitrary::{Result, Unstructured};
use c2warp::glam::DVec2;
use c2warp::project::{
    Blend, Continuity, DomainSpec, Filling, Handle, LooseParts, PoseMode, Project, Rotation, Shape, Support,
};
use c2warp::{Picture, solve};

use crate::promises::{accepted, check};
use crate::shapes::{SIDE, place, places};

const MOST_HANDLES: u8 = 6;
const MOST_CORNERS: usize = 6;
const MOST_DENSITY: u32 = 40;
const LAST_DOMAIN: u8 = 5;

/// Solves handles in one of some domains, and poses them.
///
/// # Panics
/// If a promise is broken.
pub fn attack(bytes: &[u8]) {
    let Ok(project) = project(&mut Unstructured::new(bytes)) else { return };
    let rgba = vec![255; (SIDE * SIDE * 4) as usize];
    let picture = Picture::new(SIDE, SIDE, &rgba).expect("a picture of fair size");
    if let Some(solution) = accepted(solve(&project, &picture)) {
        check(&solution, &project);
    }
}

fn project(u: &mut Unstructured<'_>) -> Result<Project> {
    let mut project = Project::for_picture(SIDE, SIDE);
    let kind = u.int_in_range(0..=LAST_DOMAIN)?;
    project.domain = domain(kind);
    project.samples = u.int_in_range(100..=300)?;
    project.fix_boundary = u.ratio(1, 4)?;
    project.loose_parts = if u.arbitrary()? { LooseParts::Follow } else { LooseParts::Stay };
    let weighting = &mut project.weighting;
    weighting.shape_factor = f64::from(u.int_in_range(0..=4_u8)?) / 4.0;
    weighting.degree = u.int_in_range(5..=32)?;
    weighting.filling = if u.arbitrary()? { Filling::Half } else { Filling::Line };
    weighting.support = if u.arbitrary()? { Support::Smooth } else { Support::Paper };
    weighting.continuity = if u.ratio(1, 4)? { Continuity::C2 } else { Continuity::Exact };
    project.pose.mode = if u.arbitrary()? { PoseMode::Rigid } else { PoseMode::Harmonic };
    project.pose.blend = if u.arbitrary()? { Blend::Rigid } else { Blend::Linear };
    project.pose.density = u.int_in_range(0..=MOST_DENSITY)?;
    for id in 0..u.int_in_range(0..=MOST_HANDLES)? {
        project.handles.push(handle(u, id.to_string())?);
    }
    Ok(project)
}

fn handle(u: &mut Unstructured<'_>, id: String) -> Result<Handle> {
    let mut handle = match u.int_in_range(0..=3_u8)? {
        0 | 1 => Handle::point(id, places(u, 1..=1)?[0]),
        2 => Handle::bar(id, places(u, 2..=MOST_CORNERS)?),
        _ => Handle::polygon(id, places(u, 3..=MOST_CORNERS)?),
    };
    for posed in handle.shape.posed_mut() {
        if u.arbitrary()? {
            *posed = place(u, *posed)?;
        }
    }
    handle.rotation = match u.int_in_range(0..=3_u8)? {
        0 => Rotation::Auto,
        1 => Rotation::Degrees(u.arbitrary()?),
        _ => Rotation::Degrees(f64::from(u.arbitrary::<i16>()?) / 32.0),
    };
    if u.ratio(1, 4)? {
        handle.scale = u.arbitrary()?;
    }
    if u.ratio(1, 4)? {
        handle.depth = u.arbitrary::<i8>()?.into();
    }
    if matches!(handle.shape, Shape::Polygon { .. }) && u.arbitrary()? {
        handle.stiffness = f64::from(u.arbitrary::<u8>()?) / 255.0;
    }
    Ok(handle)
}

/// The whole picture, a comb, a ring with a hole, two islands, and a needle.
fn domain(kind: u8) -> Option<DomainSpec> {
    let ring = |corners: &[(f64, f64)]| corners.iter().map(|&corner| DVec2::from(corner)).collect::<Vec<_>>();
    let square = |low: f64, high: f64| ring(&[(low, low), (high, low), (high, high), (low, high)]);
    let comb = ring(&[
        (4.0, 4.0),
        (60.0, 4.0),
        (60.0, 60.0),
        (50.0, 60.0),
        (50.0, 16.0),
        (38.0, 16.0),
        (38.0, 60.0),
        (26.0, 60.0),
        (26.0, 16.0),
        (14.0, 16.0),
        (14.0, 60.0),
        (4.0, 60.0),
    ]);
    let rings = match kind {
        0 => return None,
        1 => return Some(DomainSpec::Image),
        2 => vec![comb],
        3 => vec![square(2.0, 62.0), square(20.0, 44.0)],
        4 => vec![square(2.0, 30.0), square(34.0, 62.0)],
        _ => vec![ring(&[(1.0, 30.0), (63.0, 32.0), (1.0, 32.5)])],
    };
    Some(DomainSpec::polygon(rings).feathered(f64::from(kind)))
}
