//! Poses that a rig is fitted to and measured in: the project's, those of its clips, and random ones.

use c2warp::project::{Handle, Project, Rotation};
use glam::DVec2;

/// Greatest move of a handle in a random pose, as a fraction of its distance to the nearest other handle.
const OF_NEAREST: f64 = 1.0 / 3.0;
/// The same as a fraction of the picture's diagonal.
const OF_DIAGONAL: f64 = 0.1;
/// Greatest turn of a handle in a random pose, in degrees in either direction.
const TURN: f64 = 20.0;

/// The handles of a project in a random pose, determined by the seed.
pub(crate) fn random_handles(project: &Project, seed: u64) -> Vec<Handle> {
    let diagonal = libm::hypot(f64::from(project.image.width), f64::from(project.image.height));
    let mut random = Random(seed);
    let handles = &project.handles;
    let one = |(at, handle): (usize, &Handle)| {
        let others = handles.iter().enumerate().filter(|&(other, _)| other != at).flat_map(|(_, h)| h.shape.rest());
        let distance = |q: &DVec2| handle.shape.rest().iter().map(|p| p.distance(*q)).fold(f64::INFINITY, f64::min);
        let nearest = others.map(distance).fold(f64::INFINITY, f64::min);
        let reach = (OF_NEAREST * nearest).min(OF_DIAGONAL * diagonal);
        let shift = reach * DVec2::new(random.next(), random.next());
        let degrees = TURN * random.next();
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let rest = handle.shape.rest();
        let middle = rest.iter().sum::<DVec2>() / rest.len() as f64;
        let posed: Vec<DVec2> =
            rest.iter().map(|p| middle + DVec2::new(cos, sin).rotate(*p - middle) + shift).collect();
        let mut handle = handle.clone();
        handle.shape.posed_mut().copy_from_slice(&posed);
        if let Rotation::Degrees(rotation) = &mut handle.rotation {
            *rotation = degrees;
        }
        handle
    };
    handles.iter().enumerate().map(one).collect()
}

/// Numbers from −1 to 1 by splitmix64 (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
