//! Ω: the closed region that is warped, as rings in image pixels (section III-A).
//!
//! A domain consists of islands, each an outer ring with holes. Rings never cross or touch. They come from the picture's
//! rectangle, from its alpha (`contour`, then `simplify`), or from the project (`polygon`).

mod contour;
mod islands;
mod polygon;
mod simplify;

use glam::DVec2;

use crate::{
    error::Error,
    limits::{MAX_COORDINATE, MAX_CORNERS},
    picture::Picture,
    project::DomainSpec,
    segment::segment_distance,
};

/// A closed chain of at least three points, the first not repeated.
///
/// In a [`Domain`], outer rings have a positive signed area, holes a negative one: walking along a ring in the y-down image, the
/// domain lies on the right hand. A ring that a caller gives may run either way.
pub type Ring = Vec<DVec2>;

/// The region to warp, in image pixels. See the [module](self) for its invariants.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    rings: Vec<Ring>,
    islands: usize,
    specks: usize,
}

impl Domain {
    /// The domain that a project specifies: by default the opaque part of a picture with transparency and the whole rectangle
    /// of any other.
    ///
    /// # Errors
    /// Those of [`Domain::from_alpha`] and [`Domain::from_rings`], and [`Error::RingOutsidePicture`].
    pub fn new(spec: Option<&DomainSpec>, picture: &Picture) -> Result<Self, Error> {
        match spec {
            Some(DomainSpec::Image) => Ok(Self::rectangle(picture.width(), picture.height())),
            Some(DomainSpec::Alpha { threshold }) => Self::from_alpha(picture, *threshold),
            Some(DomainSpec::Polygon { rings }) => Self::from_polygon(rings, picture.width(), picture.height()),
            None if picture.has_transparency() => Self::from_alpha(picture, DomainSpec::THRESHOLD),
            None => Ok(Self::rectangle(picture.width(), picture.height())),
        }
    }

    /// The whole picture.
    pub(crate) fn rectangle(width: u32, height: u32) -> Self {
        let (w, h) = (f64::from(width), f64::from(height));
        let ring = vec![DVec2::ZERO, DVec2::new(w, 0.0), DVec2::new(w, h), DVec2::new(0.0, h)];
        Self::of_oriented(vec![ring], 0)
    }

    /// The region where the picture's alpha reaches `threshold` (in (0, 1]), bounded by sub-pixel contours.
    ///
    /// # Errors
    /// [`Error::NothingOpaque`], [`Error::OnlySpecks`], [`Error::OutlineTooFine`]; [`Error::Project`] for what is no threshold.
    pub fn from_alpha(picture: &Picture, threshold: f64) -> Result<Self, Error> {
        DomainSpec::check_threshold(threshold)?;
        let area = f64::from(picture.width()) * f64::from(picture.height());
        let kept = islands::without_specks(contour::alpha_contours(picture, threshold), area);
        if kept.rings.is_empty() {
            return Err(match kept.specks {
                0 => Error::NothingOpaque { threshold },
                specks => Error::OnlySpecks { threshold, specks },
            });
        }
        // Simplification keeps at least three corners of each ring.
        let check = |corners| if corners > MAX_CORNERS { Err(Error::OutlineTooFine { corners }) } else { Ok(()) };
        check(3 * kept.rings.len())?;
        let rings = simplify::simplified(&kept.rings);
        check(corners(&rings))?;
        Ok(Self::of_oriented(rings, kept.specks))
    }

    /// The inside of the project's rings by the even-odd rule, within a picture of the given size.
    ///
    /// # Errors
    /// As [`from_rings`](Self::from_rings), but [`Error::RingOutsidePicture`] for a point outside the picture.
    pub(crate) fn from_polygon(rings: &[Ring], width: u32, height: u32) -> Result<Self, Error> {
        DomainSpec::check_rings(rings)?;
        check_fineness(rings)?;
        polygon::check(rings, width, height)?;
        Ok(Self::of_oriented(islands::oriented(rings), 0))
    }

    /// The inside of rings by the even-odd rule, without a picture: places in pixels, each coordinate from −1,000,000 to 1,000,000.
    ///
    /// Tolerances are in pixels, as for an [`InputMesh`](crate::InputMesh): scale up rings in units of 0 to 1 to some hundreds of pixels.
    ///
    /// ```
    /// use c2warp::{domain::Domain, glam::DVec2};
    ///
    /// let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec();
    /// let domain = Domain::from_rings(&[square(-50.0, 50.0), square(-20.0, 20.0)])?;
    /// assert_eq!((domain.islands(), domain.holes(), domain.area()), (1, 1, 8400.0));
    /// # Ok::<(), c2warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// One of the `Ring…` errors, naming ring and point; [`Error::RingsTooFine`]; [`Error::Project`] for no ring at all, and for one of
    /// less than three points or with one that is not finite.
    pub fn from_rings(rings: &[Ring]) -> Result<Self, Error> {
        DomainSpec::check_rings(rings)?;
        for (ring, points) in rings.iter().enumerate() {
            if let Some(point) = points.iter().position(|p| p.abs().max_element() > MAX_COORDINATE) {
                return Err(Error::RingPoint { ring, point });
            }
        }
        check_fineness(rings)?;
        polygon::check_rings(rings)?;
        Ok(Self::of_oriented(islands::oriented(rings), 0))
    }

    /// The region to the right of rings of finite points.
    ///
    /// # Errors
    /// [`Error::RingsTooFine`], [`Error::RingDuplicate`], [`Error::RingsCross`]; [`Error::RingFlat`] for a ring that is an
    /// island within an island, or a hole outside of all.
    pub(crate) fn from_oriented(rings: Vec<Ring>) -> Result<Self, Error> {
        check_fineness(&rings)?;
        polygon::check_simple(&rings)?;
        let turned = rings.iter().zip(islands::oriented(&rings)).position(|(ring, oriented)| *ring != oriented);
        turned.map_or_else(|| Ok(Self::of_oriented(rings, 0)), |ring| Err(Error::RingFlat { ring }))
    }

    /// From checked rings, each with the domain to its right.
    fn of_oriented(rings: Vec<Ring>, specks: usize) -> Self {
        let islands = rings.iter().filter(|ring| signed_area(ring) > 0.0).count();
        Self { rings, islands, specks }
    }

    /// Outer rings and holes, in image pixels.
    #[must_use]
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }

    /// Number of connected parts.
    #[must_use]
    pub fn islands(&self) -> usize {
        self.islands
    }

    /// Number of holes.
    #[must_use]
    pub fn holes(&self) -> usize {
        self.rings.len() - self.islands
    }

    /// Number of opaque or transparent regions that were too small to keep.
    #[must_use]
    pub fn specks(&self) -> usize {
        self.specks
    }

    /// Area in square pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.rings.iter().map(|ring| signed_area(ring)).sum()
    }

    /// Least and greatest coordinates, in pixels.
    #[must_use]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        let points = self.rings.iter().flatten();
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)))
    }
}

fn corners(rings: &[Ring]) -> usize {
    rings.iter().map(Vec::len).sum()
}

/// # Errors
/// [`Error::RingsTooFine`].
fn check_fineness(rings: &[Ring]) -> Result<(), Error> {
    let corners = corners(rings);
    if corners > MAX_CORNERS { Err(Error::RingsTooFine { corners }) } else { Ok(()) }
}

/// Signed area of a ring: positive for an outer ring, negative for a hole.
pub(crate) fn signed_area(ring: &[DVec2]) -> f64 {
    let Some(&origin) = ring.first() else { return 0.0 };
    edges(ring).map(|(a, b)| (a - origin).perp_dot(b - origin)).sum::<f64>() / 2.0
}

/// The edges of a ring, the closing one last.
pub(crate) fn edges(ring: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(&a, &b)| (a, b))
}

impl Domain {
    /// The edges of the outline.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        self.rings.iter().flat_map(|ring| edges(ring))
    }

    /// Straight distance of a point to the outline. For a point of the domain also the intrinsic distance: nothing lies
    /// between.
    pub(crate) fn distance_to_outline(&self, p: DVec2) -> f64 {
        self.edges().map(|(a, b)| segment_distance(p, a, b)).fold(f64::INFINITY, f64::min)
    }
}

/// Whether a point lies inside a ring, by the even-odd rule.
pub(crate) fn contains(ring: &[DVec2], p: DVec2) -> bool {
    edges(ring).fold(false, |inside, (a, b)| {
        let crosses = (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        inside != crosses
    })
}
