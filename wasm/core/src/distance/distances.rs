//! Distances from one point of a domain to any other.

use glam::DVec2;

use super::{DistanceField, NavTriangle, Navigation, Propagation};
use crate::error::Error;

/// A point of a domain with its triangle.
///
/// Locating a point takes half the time of a distance query. Locate a point once for distances from many sources.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Located {
    triangle: NavTriangle,
    point: DVec2,
}

impl Located {
    /// The point, in pixels. Rounding may have moved it onto the outline.
    #[must_use]
    pub fn point(&self) -> DVec2 {
        self.point
    }
}

/// Exact intrinsic distances from one point of a domain.
///
/// [`Navigation::distances_from`] and [`Navigation::distances_within`] compute them.
///
/// Memory: 64 bytes for each pair of pseudo-source and triangle of the navigation mesh in which the pseudo-source may
/// be the nearest.
#[derive(Debug, Clone)]
pub struct Distances<'a> {
    navigation: &'a Navigation,
    field: DistanceField,
}

impl Distances<'_> {
    /// The distance field.
    pub(crate) fn field(&self) -> &DistanceField {
        &self.field
    }

    /// The source of the distances, in pixels.
    #[must_use]
    pub fn source(&self) -> DVec2 {
        self.field.source
    }

    /// The distance to a point, in pixels.
    ///
    /// Returns `None` outside the domain, beyond the requested radius, and if no path to the point exists.
    #[must_use]
    pub fn to(&self, p: DVec2) -> Option<f64> {
        self.to_located(self.navigation.located(p)?)
    }

    /// Returns the same as [`to`](Self::to) for a point that the same navigation mesh has located.
    #[must_use]
    #[inline]
    pub fn to_located(&self, p: Located) -> Option<f64> {
        let distance = self.field.distance(p.triangle, p.point);
        distance.is_finite().then_some(distance)
    }

    /// The vertices of the shortest path from the source to a point, including both. Returns `None` as [`to`](Self::to)
    /// does.
    #[must_use]
    pub fn path_to(&self, p: DVec2) -> Option<Vec<DVec2>> {
        let Located { triangle, point } = self.navigation.located(p)?;
        self.field.path(self.navigation, triangle, point)
    }

    /// The distance to a point, in pixels, and its gradient there. Returns `None` as [`to`](Self::to) does.
    ///
    /// The gradient has length 1 and points away from the source along the shortest path. If several paths are
    /// equally short, it is the mean of their gradients. It is 0 at the source.
    #[must_use]
    pub fn distance_and_gradient(&self, p: DVec2) -> Option<(f64, DVec2)> {
        let Located { triangle, point } = self.navigation.located(p)?;
        self.field.distance_and_gradient(triangle, point)
    }
}

impl Navigation {
    /// A point with its triangle, or `None` outside the domain. Up to a millionth of a pixel outside the outline
    /// counts as rounding.
    #[must_use]
    pub fn located(&self, p: DVec2) -> Option<Located> {
        self.locate(p).map(|(triangle, point)| Located { triangle, point })
    }

    /// Computes exact distances from a point of the domain.
    ///
    /// Cost: about ten windows for each corner of the outline, some 50 ns each.
    ///
    /// # Errors
    /// [`Error::PointOutside`] if `source` is outside the domain.
    pub fn distances_from(&self, source: DVec2) -> Result<Distances<'_>, Error> {
        self.distances_within(source, f64::INFINITY)
    }

    /// Computes exact distances from a point of the domain, up to a radius in pixels.
    ///
    /// Cost: as for [`distances_from`](Self::distances_from), but only for the corners within the radius.
    ///
    /// # Errors
    /// [`Error::PointOutside`] if `source` is outside the domain.
    pub fn distances_within(&self, source: DVec2, radius: f64) -> Result<Distances<'_>, Error> {
        let outside = Error::PointOutside { x: source.x, y: source.y };
        let Located { triangle, point } = self.located(source).ok_or(outside)?;
        let field = Propagation::default().field(self, triangle, point, radius);
        Ok(Distances { navigation: self, field })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;

    /// A square of 100 px with a square hole of 40 px in its middle.
    fn frame() -> Navigation {
        let square =
            |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec();
        Navigation::new(&Domain::from_rings(&[square(0.0, 100.0), square(30.0, 70.0)]).unwrap())
    }

    #[test]
    fn shortest_path_and_its_gradient_lead_around_a_hole() {
        let frame = frame();
        let distances = frame.distances_from(DVec2::new(10.0, 30.0)).unwrap();
        let (distance, gradient) = distances.distance_and_gradient(DVec2::new(80.0, 40.0)).unwrap();
        let beyond = DVec2::new(10.0, 10.0);
        assert!((distance - (60.0 + beyond.length())).abs() < 1e-12, "{distance}");
        assert!(gradient.distance(beyond.normalize()) < 1e-12, "{gradient}");
        assert_eq!(distances.to(DVec2::new(80.0, 40.0)), Some(distance));
        assert_eq!(distances.to(DVec2::new(50.0, 50.0)), None);
        assert_eq!((distances.source(), distances.to(distances.source())), (DVec2::new(10.0, 30.0), Some(0.0)));
    }

    #[test]
    fn path_bends_at_the_corners_of_a_hole_and_is_as_long_as_the_distance() {
        let frame = frame();
        let distances = frame.distances_from(DVec2::new(50.0, 20.0)).unwrap();
        let path = distances.path_to(DVec2::new(50.0, 81.0)).unwrap();
        assert!(path.len() == 4 && path[0] == distances.source() && path[3] == DVec2::new(50.0, 81.0), "{path:?}");
        let length: f64 = path.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
        assert!((length - distances.to(path[3]).unwrap()).abs() < 1e-12);
        assert_eq!(distances.path_to(DVec2::new(60.0, 25.0)).unwrap().len(), 2);
        assert_eq!(distances.path_to(DVec2::new(50.0, 50.0)), None);
    }

    #[test]
    fn no_distance_beyond_the_radius() {
        let frame = frame();
        let distances = frame.distances_within(DVec2::new(10.0, 10.0), 50.0).unwrap();
        assert_eq!(distances.to(DVec2::new(60.0, 10.0)), Some(50.0));
        assert_eq!(distances.to(DVec2::new(61.0, 10.0)), None);
        assert_eq!(distances.distance_and_gradient(DVec2::new(61.0, 10.0)), None);
        assert!(frame.distances_within(DVec2::ZERO, f64::NAN).unwrap().to(DVec2::ONE).is_none());
    }

    #[test]
    fn sources_outside_the_domain_are_refused() {
        let frame = frame();
        for p in [DVec2::new(50.0, 50.0), DVec2::new(-1.0, 0.0), DVec2::INFINITY, DVec2::splat(1e300)] {
            assert_eq!(frame.distances_from(p).err(), Some(Error::PointOutside { x: p.x, y: p.y }));
        }
        assert!(frame.distances_from(DVec2::NAN).is_err() && frame.located(DVec2::NAN).is_none());
    }
}
