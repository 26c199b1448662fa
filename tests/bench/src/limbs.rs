//! Generated pictures: antialiased white limbs on a transparent background.

use glam::DVec2;

/// A tapering stroke between two points, with round ends.
#[derive(Debug, Clone, Copy)]
pub struct Limb {
    from: DVec2,
    to: DVec2,
    from_radius: f64,
    to_radius: f64,
}

/// Returns a limb between two points, with a radius at each.
#[must_use]
pub fn limb(from: (f64, f64), from_radius: f64, to: (f64, f64), to_radius: f64) -> Limb {
    Limb { from: from.into(), to: to.into(), from_radius, to_radius }
}

/// Returns a disc.
#[must_use]
pub fn disc(at: (f64, f64), radius: f64) -> Limb {
    limb(at, radius, at, radius)
}

impl Limb {
    /// Returns the distance of `p` from the limb. It is negative inside.
    fn distance(&self, p: DVec2) -> f64 {
        let along = self.to - self.from;
        let length_squared = along.length_squared();
        let t = if length_squared > 0.0 { ((p - self.from).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
        p.distance(self.from + along * t) - (self.from_radius + (self.to_radius - self.from_radius) * t)
    }
}

/// Returns the RGBA pixels of `limbs` without `holes`.
#[must_use]
pub fn draw(width: u32, height: u32, limbs: &[Limb], holes: &[Limb]) -> Vec<u8> {
    let mut rgba = vec![u8::MAX; width as usize * height as usize * 4];
    for (at, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let p = DVec2::new((at % width as usize) as f64 + 0.5, (at / width as usize) as f64 + 0.5);
        let nearest = |limbs: &[Limb]| limbs.iter().map(|limb| limb.distance(p)).fold(f64::INFINITY, f64::min);
        let distance = nearest(limbs).max(-nearest(holes));
        pixel[3] = (255.0 * (0.5 - distance).clamp(0.0, 1.0)) as u8;
    }
    rgba
}
