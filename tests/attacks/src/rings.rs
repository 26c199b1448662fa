//! Outlines of a caller: rings of points.

use arbitrary::{Result, Unstructured};
use c2warp::distance::Navigation;
use c2warp::domain::Domain;
use c2warp::glam::DVec2;
use c2warp::limits::MIN_SEPARATION;
use c2warp::project::{Handle, Project};
use c2warp::solve_domain;

use crate::promises::{accepted, check};
use crate::shapes::{SIDE, places};

const MOST_RINGS: usize = 5;
const MOST_CORNERS: usize = 24;
/// Relative to the size of the domain: paths bend at rounded places.
const TOLERANCE: f64 = 1e-6;

/// Makes a domain of rings, measures distances between places in it, and solves it with handles there.
///
/// A distance is symmetric, and not shorter than the straight line. In rings with a part that is narrower than sites
/// may be, a path may be found in one direction only.
///
/// # Panics
/// If a promise is broken.
pub fn attack(bytes: &[u8]) {
    if let Ok((rings, positions)) = scene(&mut Unstructured::new(bytes)) {
        run(&rings, &positions);
    }
}

fn scene(u: &mut Unstructured<'_>) -> Result<(Vec<Vec<DVec2>>, Vec<DVec2>)> {
    let positions = places(u, 1..=3)?;
    let count = u.int_in_range(1..=MOST_RINGS)?;
    let rings = (0..count).map(|_| places(u, 3..=MOST_CORNERS)).collect::<Result<_>>()?;
    Ok((rings, positions))
}

fn run(rings: &[Vec<DVec2>], positions: &[DVec2]) {
    let Some(domain) = accepted(Domain::from_rings(rings)) else { return };
    assert!(domain.area() > 0.0 && domain.islands() > 0);
    let (low, high) = domain.bounds();
    let tolerance = TOLERANCE * (high - low).length();
    let navigation = Navigation::new(&domain);
    let inside: Vec<DVec2> =
        positions.iter().chain(rings.iter().flatten()).copied().filter(|&p| navigation.located(p).is_some()).collect();
    let inside = &inside[..inside.len().min(6)];
    let is_coarse = is_coarse(rings);
    let fields: Vec<_> = inside.iter().filter_map(|&p| accepted(navigation.distances_from(p))).collect();
    assert_eq!(fields.len(), inside.len());
    for (a, from_a) in inside.iter().zip(&fields) {
        for (b, from_b) in inside.iter().zip(&fields) {
            let (there, back) = (from_a.to(*b), from_b.to(*a));
            assert!(!is_coarse || there.is_some() == back.is_some(), "a path between {a} and {b}");
            let (Some(there), Some(back)) = (there, back) else { continue };
            assert!((there - back).abs() <= tolerance, "{there} from {a} to {b}, and {back} back");
            assert!(there >= a.distance(*b) - tolerance, "{there} from {a} to {b}");
        }
    }
    let handles = positions.iter().enumerate().map(|(id, &p)| Handle::point(id.to_string(), p));
    let mut project = Project::for_picture(SIDE, SIDE).with_handles(handles);
    project.samples = 100;
    if let Some(solution) = accepted(solve_domain(&project, &domain)) {
        check(&solution, &project);
    }
}

/// Whether all corners are as far apart as sites must be.
fn is_coarse(rings: &[Vec<DVec2>]) -> bool {
    let corners: Vec<DVec2> = rings.iter().flatten().copied().collect();
    (1..corners.len()).all(|k| corners[..k].iter().all(|corner| corner.distance(corners[k]) >= MIN_SEPARATION))
}
