//! Penumbrae: lengthen paths beside the rays at which they begin to bend, so that distances are C² across these rays.
//!
//! A path from pseudo-source s bends at corner c. Let l = |c − s| and r = |p − c|. Let θ be the angle of p at c off the
//! ray from s through c, on the lit side. A lit point is at distance F(θ) from s, a point in the shadow at F(0):
//!
//! ```text
//! F(θ) = √((l + r)² − 4 l r h²),  h = sin(θ / 2).
//! ```
//!
//! Across the ray the second derivative jumps. A penumbra is the wedge 0 < θ < w on the lit side. There
//!
//! ```text
//! H = h (1 − (1 − h / sin(w / 2))³)
//! ```
//!
//! replaces h. As H is of second order at the ray, F has three continuous derivatives there. At the other side of the
//! wedge H meets h with two.
//!
//! A smooth distance is the exact one plus F(H) − F(h) over all penumbrae at the point. Each summand only has the jump
//! at its own ray. So the sum is also C² where penumbrae overlap, as along a round outline.
//!
//! Another corner that hides a part of the wedge would cut the summand off there. So w is at most the angle of the
//! first such corner.
//!
//! Guarantees: never shorter than the exact distance. Longer by at most 0.03 w² of the length of the path, and equal
//! outside the penumbrae.
//!
//! Cost: for each corner at which paths bend, the triangles of its wedge.
//!
//! Limits: at a corner itself, all rays of its penumbra meet. Gradients differ between directions there, as those of
//! the exact distance do. Second derivatives grow with 1 / r towards it.

use std::ops::Range;

use glam::DVec2;

use super::{
    navigation::{NavTriangle, Navigation},
    propagate::{Bend, Propagation},
    wedge::{ALIGNED, Wedge},
};
use crate::rank::sort_by_rank;

/// w: the greatest angle of a penumbra, in radians. Supports keep a margin of 1.25 % over their cells. At this angle,
/// paths are lengthened by less than half of that.
const WIDEST: f64 = 0.4;
/// Narrower penumbrae would be lost in rounding.
const NARROWEST: f64 = 1e-7;
/// Paths up to this multiple of the support radius are lengthened. A path is at most w²/8 longer than the shortest path
/// of its kind, which is 2 %. A path around the other side of a hole is 10 % longer: see `unique`.
const REACH: f64 = 1.04;

/// The penumbrae of one distance field.
#[derive(Debug, Clone, Default)]
pub(crate) struct Penumbrae {
    penumbrae: Vec<Penumbra>,
    /// Triangles with penumbrae, ascending, each with the index of its first entry in `members`.
    triangles: Vec<(u32, u32)>,
    /// Indices of penumbrae.
    members: Vec<u32>,
}

/// A wedge beside a ray at which paths begin to bend.
#[derive(Debug, Clone, Copy)]
struct Penumbra {
    corner: DVec2,
    /// Unit direction of the ray.
    ahead: DVec2,
    /// Unit normal of the ray, towards the lit side.
    lit: DVec2,
    /// l.
    before: f64,
    /// Length of the path to the pseudo-source.
    offset: f64,
    /// sin(w / 2).
    width: f64,
    /// Maximum length of paths that are lengthened.
    reach: f64,
}

impl Propagation {
    /// The penumbrae of the most recent field, for a support of radius `radius`.
    ///
    /// The field must reach beyond the radius by [`Penumbrae::field_bound`].
    pub(crate) fn penumbrae(&self, navigation: &Navigation, radius: f64) -> Penumbrae {
        let reach = Penumbrae::field_bound(radius);
        let mut penumbrae = Vec::new();
        let mut members: Vec<(u32, u32)> = Vec::new();
        let mut wedge = Wedge::new(navigation);
        for (at, bend) in self.bends().iter().enumerate() {
            let bend = grazed_before(navigation, &self.bends()[..at], *bend);
            let corner = navigation.mesh.vertices[bend.corner as usize];
            let ahead = (corner - bend.before).normalize();
            let side = if bend.is_shadow_positive { -1.0 } else { 1.0 };
            let (lit, before) = (side * ahead.perp(), corner.distance(bend.before));
            let (sin, cos) = libm::sincos(WIDEST);
            let widest = cos * ahead + sin * lit;
            let narrowed = wedge.spread(&bend, (ahead, lit, widest), reach);
            let (sine, cosine) = (narrowed.dot(lit), narrowed.dot(ahead));
            if sine < NARROWEST {
                continue;
            }
            let width = half_angle_sine(sine, cosine);
            let index = penumbrae.len() as u32;
            penumbrae.push(Penumbra { corner, ahead, lit, before, offset: bend.offset, width, reach });
            members.extend(wedge.triangles(ahead, lit, narrowed).map(|triangle| (triangle, index)));
        }
        sort_by_rank(&mut members, |&(triangle, penumbra)| [triangle.into(), penumbra.into()]);
        members.dedup();
        let mut triangles = Vec::new();
        for (at, pair) in members.iter().enumerate() {
            if at == 0 || members[at - 1].0 != pair.0 {
                triangles.push((pair.0, at as u32));
            }
        }
        Penumbrae { penumbrae, triangles, members: members.into_iter().map(|(_, index)| index).collect() }
    }
}

/// The bend with the last pseudo-source on its ray. If a ray grazes several corners, each of them begins a shadow, and
/// the pseudo-source of the next is the one before it.
fn grazed_before(navigation: &Navigation, earlier: &[Bend], bend: Bend) -> Bend {
    let at = |corner: u32| navigation.mesh.vertices[corner as usize];
    let ahead = at(bend.corner) - bend.before;
    let grazes = |other: &&Bend| {
        let to = at(other.corner) - bend.before;
        other.before == bend.before
            && other.is_shadow_positive == bend.is_shadow_positive
            && ahead.perp_dot(to).abs() <= ALIGNED * ahead.length() * to.length()
            && ahead.dot(to) > 0.0
            && to.length_squared() < ahead.length_squared()
    };
    let last = earlier.iter().filter(grazes).map(|other| at(other.corner));
    let farther = |one: DVec2, other: DVec2| {
        if other.distance_squared(bend.before) > one.distance_squared(bend.before) { other } else { one }
    };
    last.reduce(farther).map_or(bend, |corner| {
        let offset = bend.offset + corner.distance(bend.before);
        Bend { before: corner, offset, ..bend }
    })
}

/// sin(θ / 2) of an angle with positive sine.
fn half_angle_sine(sine: f64, cosine: f64) -> f64 {
    // More exact than √((1 − cos θ) / 2) for small angles.
    if cosine > 0.0 { sine / (2.0 * (1.0 + cosine)).sqrt() } else { ((1.0 - cosine) / 2.0).sqrt() }
}

impl Penumbrae {
    /// The bound of a field that finds all penumbrae of a support.
    pub(crate) fn field_bound(radius: f64) -> f64 {
        REACH * radius
    }

    /// The range of the penumbrae in a triangle.
    pub(crate) fn range_in(&self, triangle: NavTriangle) -> Range<u32> {
        match self.triangles.binary_search_by_key(&triangle.0, |&(triangle, _)| triangle) {
            Ok(at) => {
                let end = self.triangles.get(at + 1).map_or(self.members.len() as u32, |&(_, start)| start);
                self.triangles[at].1..end
            }
            Err(_) => 0..0,
        }
    }

    /// The penumbrae of a range of [`range_in`](Self::range_in).
    fn within(&self, range: Range<u32>) -> impl Iterator<Item = &Penumbra> {
        self.members[range.start as usize..range.end as usize].iter().map(|&at| &self.penumbrae[at as usize])
    }

    /// Adds the lengthening by the penumbrae of a range to the distances of points.
    pub(crate) fn lengthen(&self, range: Range<u32>, (x, y): (&[f64], &[f64]), distances: &mut [f64]) {
        for penumbra in self.within(range) {
            for (distance, (&x, &y)) in distances.iter_mut().zip(x.iter().zip(y)) {
                *distance += penumbra.lengthening(DVec2::new(x, y));
            }
        }
    }

    /// The lengthening of a point's distance by the penumbrae of a range, with its gradient.
    pub(crate) fn lengthening_and_gradient(&self, range: Range<u32>, p: DVec2) -> (f64, DVec2) {
        let added = self.within(range).map(|penumbra| (penumbra.lengthening(p), penumbra.gradient(p)));
        added.fold((0.0, DVec2::ZERO), |sum, one| (sum.0 + one.0, sum.1 + one.1))
    }
}

impl Penumbra {
    /// r, sin θ, cos θ and h of a point in the wedge; `None` outside it.
    #[inline]
    fn polar(&self, p: DVec2) -> Option<(f64, f64, f64, f64)> {
        let to = p - self.corner;
        let r = to.length();
        let (along, across) = (to.dot(self.ahead), to.dot(self.lit));
        if across <= 0.0 || along <= 0.0 {
            return None;
        }
        let (sine, cosine) = (across / r, along / r);
        let h = half_angle_sine(sine, cosine);
        (h < self.width).then_some((r, sine, cosine, h))
    }

    /// F(H) − F(h), 0 outside the wedge.
    #[inline]
    fn lengthening(&self, p: DVec2) -> f64 {
        let Some((r, _, _, h)) = self.polar(p) else { return 0.0 };
        let u = 1.0 - h / self.width;
        let cube = u * u * u;
        let (sum, product) = (self.before + r, 4.0 * self.before * r);
        let (square, blended) = (h * h, h * h * (1.0 - cube) * (1.0 - cube));
        let lit = (sum * sum - product * square).sqrt();
        if self.offset + lit > self.reach {
            return 0.0;
        }
        let smooth = (sum * sum - product * blended).sqrt();
        // The difference of the squares over the sum, without cancellation.
        product * square * cube * (2.0 - cube) / (lit + smooth)
    }

    /// The gradient of [`lengthening`](Self::lengthening).
    fn gradient(&self, p: DVec2) -> DVec2 {
        let Some((r, sine, cosine, h)) = self.polar(p) else { return DVec2::ZERO };
        let u = 1.0 - h / self.width;
        let kept = 1.0 - u * u * u;
        let blended = h * kept;
        let blended_slope = kept + 3.0 * h * u * u / self.width;
        let outwards = cosine * self.ahead + sine * self.lit;
        let turning = (cosine * self.lit - sine * self.ahead) / r;
        // h is half a chord of the unit circle.
        let h_gradient = 0.5 * (1.0 - h * h).sqrt() * turning;
        let (l, sum) = (self.before, self.before + r);
        let of = |height: f64, slope: f64| {
            let length = (sum * sum - 4.0 * l * r * height * height).sqrt();
            let gradient = (sum - 2.0 * l * height * height) * outwards - 4.0 * l * r * height * slope * h_gradient;
            (length, gradient / length)
        };
        let (lit, lit_gradient) = of(h, 1.0);
        if self.offset + lit > self.reach {
            return DVec2::ZERO;
        }
        of(blended, blended_slope).1 - lit_gradient
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{distance::DistanceField, domain::Domain};

    /// A room of 400 px without its lower left quarter.
    fn room() -> Navigation {
        let corners = [(0.0, 0.0), (400.0, 0.0), (400.0, 400.0), (200.0, 400.0), (200.0, 200.0), (0.0, 200.0)];
        Navigation::new(&Domain::from_rings(&[corners.map(DVec2::from).to_vec()]).unwrap())
    }

    fn of(navigation: &Navigation, source: (f64, f64)) -> (DistanceField, Penumbrae) {
        let (triangle, source) = navigation.locate(source.into()).unwrap();
        let mut propagation = Propagation::default();
        let field = propagation.field(navigation, triangle, source, 1000.0);
        (field, propagation.penumbrae(navigation, 1000.0 / REACH))
    }

    /// The smooth distance and its gradient.
    fn at(navigation: &Navigation, (field, penumbrae): &(DistanceField, Penumbrae), p: DVec2) -> (f64, DVec2) {
        let (triangle, p) = navigation.locate(p).unwrap();
        let (distance, gradient) = field.distance_and_gradient(triangle, p).unwrap();
        let (longer, turned) = penumbrae.lengthening_and_gradient(penumbrae.range_in(triangle), p);
        (distance + longer, gradient + turned)
    }

    #[test]
    fn distances_differ_from_exact_ones_only_in_the_wedge_and_slightly() {
        let navigation = room();
        let smooth = of(&navigation, (60.0, 120.0));
        let (source, corner) = (DVec2::new(60.0, 120.0), DVec2::splat(200.0));
        let ahead = (corner - source).normalize();
        let mut within = 0;
        for p in
            (0..40).flat_map(|i| (0..40).map(move |j| DVec2::new(5.0 + 10.0 * f64::from(i), 5.0 + 10.0 * f64::from(j))))
        {
            let Some((triangle, _)) = navigation.locate(p) else { continue };
            let (exact, longer) = (smooth.0.distance(triangle, p), at(&navigation, &smooth, p).0);
            let to = (p - corner).normalize();
            let angle = libm::atan2(to.perp_dot(ahead), to.dot(ahead));
            if (0.01..WIDEST - 0.01).contains(&angle) {
                assert!(longer > exact && longer < exact * (1.0 + 0.03 * WIDEST * WIDEST), "{p}: {longer} for {exact}");
                within += 1;
            } else if !(0.0..WIDEST).contains(&angle) {
                assert_eq!(longer.to_bits(), exact.to_bits(), "{p}");
            }
        }
        assert!(within > 50, "{within} points");
    }

    #[test]
    fn gradients_are_those_of_the_smooth_distance() {
        let navigation = room();
        for source in [(60.0, 120.0), (20.0, 199.0), (60.0, 200.0)] {
            let smooth = of(&navigation, source);
            for p in [(300.0, 210.0), (300.0, 240.0), (300.0, 270.0), (260.0, 300.0), (215.0, 210.0), (390.0, 202.0)] {
                let p = DVec2::from(p);
                let (step, gradient) = (1e-5, at(&navigation, &smooth, p).1);
                let slope = |axis: DVec2| {
                    let [before, after] = [-step, step].map(|step| at(&navigation, &smooth, p + step * axis).0);
                    (after - before) / (2.0 * step)
                };
                let expected = DVec2::new(slope(DVec2::X), slope(DVec2::Y));
                assert!(gradient.distance(expected) < 1e-8, "{source:?} {p}: {gradient} for {expected}");
            }
        }
    }

    /// From 0.1 px to 0.001 px, a jump of second derivatives would stay. A continuous one shrinks with the step.
    #[test]
    fn second_derivatives_are_continuous_across_both_sides_of_a_penumbra() {
        let navigation = room();
        let smooth = of(&navigation, (60.0, 120.0));
        let corner = DVec2::splat(200.0);
        let ahead = (corner - DVec2::new(60.0, 120.0)).normalize();
        let (sin, cos) = libm::sincos(-WIDEST);
        for (ray, r) in [(ahead, 150.0), (ahead, 20.0), (DVec2::new(cos, sin).rotate(ahead), 150.0)] {
            let jump = |step: f64| {
                let slope = |off: f64| at(&navigation, &smooth, corner + r * ray + off * step * ray.perp()).1;
                ((slope(2.0) - slope(1.0)) - (slope(-1.0) - slope(-2.0))).length() / step
            };
            assert!(jump(1e-3) < 0.03 * jump(0.1), "{ray} {r}: {} and {}", jump(1e-3), jump(0.1));
        }
    }

    /// Two corners of a gate hide parts of each other's wedges.
    #[test]
    fn penumbrae_are_as_narrow_as_the_view_past_other_corners() {
        let gate = [
            (0.0, 0.0),
            (190.0, 0.0),
            (190.0, 180.0),
            (200.0, 180.0),
            (200.0, 0.0),
            (400.0, 0.0),
            (400.0, 400.0),
            (240.0, 400.0),
            (240.0, 200.0),
            (230.0, 200.0),
            (230.0, 400.0),
            (0.0, 400.0),
        ];
        let navigation = Navigation::new(&Domain::from_rings(&[gate.map(DVec2::from).to_vec()]).unwrap());
        let smooth = of(&navigation, (20.0, 170.0));
        // Distances are continuous along a circle around each corner.
        for corner in [(200.0, 180.0), (230.0, 200.0), (240.0, 200.0)].map(DVec2::from) {
            let on_circle = |k: u32| {
                let (sin, cos) = libm::sincos(f64::from(k) * 1e-3);
                let p = corner + 55.0 * DVec2::new(cos, sin);
                navigation.locate(p).map(|_| at(&navigation, &smooth, p).0)
            };
            for (one, other) in (0..6283).filter_map(|k| on_circle(k).zip(on_circle(k + 1))) {
                assert!((one - other).abs() < 0.06, "{corner}: {one} and {other}");
            }
        }
    }
}
