//! Pictures drawn by a formula: round, tapering limbs, antialiased, in white on nothing.

use glam::DVec2;

/// A stroke from one point to another, round at both ends.
#[derive(Debug, Clone, Copy)]
pub struct Limb {
    from: DVec2,
    to: DVec2,
    from_radius: f64,
    to_radius: f64,
}

/// A limb between two points, with its radius at each.
#[must_use]
pub fn limb(from: (f64, f64), from_radius: f64, to: (f64, f64), to_radius: f64) -> Limb {
    Limb { from: from.into(), to: to.into(), from_radius, to_radius }
}

/// A round spot.
#[must_use]
pub fn spot(at: (f64, f64), radius: f64) -> Limb {
    limb(at, radius, at, radius)
}

impl Limb {
    /// How far outside a point lies; negative inside.
    fn outside(&self, p: DVec2) -> f64 {
        let along = self.to - self.from;
        let length_squared = along.length_squared();
        let t = if length_squared > 0.0 { ((p - self.from).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
        p.distance(self.from + along * t) - (self.from_radius + (self.to_radius - self.from_radius) * t)
    }
}

/// RGBA of a picture of limbs, less some others.
#[must_use]
pub fn drawn(width: u32, height: u32, limbs: &[Limb], holes: &[Limb]) -> Vec<u8> {
    let mut rgba = vec![u8::MAX; width as usize * height as usize * 4];
    for (at, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let p = DVec2::new((at % width as usize) as f64 + 0.5, (at / width as usize) as f64 + 0.5);
        let least = |limbs: &[Limb]| limbs.iter().map(|limb| limb.outside(p)).fold(f64::INFINITY, f64::min);
        let outside = least(limbs).max(-least(holes));
        pixel[3] = (255.0 * (0.5 - outside).clamp(0.0, 1.0)) as u8;
    }
    rgba
}
