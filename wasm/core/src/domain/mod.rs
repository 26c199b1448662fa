//! Ω: the closed region to warp, as rings in image pixels (section III-A).
//!
//! A domain consists of islands, each an outer ring with holes. Rings never cross or touch. They come from the
//! picture's rectangle, from its alpha (`outline`), or from the project (`polygon`).

mod cells_inside;
mod contour;
mod islands;
mod mask;
mod nearness;
mod outline;
mod polygon;
mod ring;
mod simplify;
mod visible;

use glam::DVec2;

use self::outline::{Bounds, FREE, HELD, Outline};
use crate::{
    error::Error,
    limits::{MAX_COORDINATE, MAX_CORNERS},
    picture::Picture,
    project::DomainSpec,
    segment::segment_distance,
};

pub(crate) use cells_inside::cells_inside;
pub(crate) use mask::Mask;
pub use outline::OutlineDetail;
pub use ring::Ring;
pub(crate) use ring::{contains, corners_between, edges, signed_area};
pub(crate) use visible::VisiblePixels;

/// The region to warp, in image pixels. See the [module](self) for its invariants.
#[derive(Debug, Clone, PartialEq)]
pub struct Domain {
    rings: Vec<Ring>,
    islands: usize,
    specks: usize,
    detail: OutlineDetail,
    gap: f64,
}

impl Domain {
    /// The domain that a project specifies. The default is the opaque part of a picture with transparency, and the
    /// whole rectangle of other pictures.
    ///
    /// # Errors
    /// The errors of [`Domain::from_alpha`] and [`Domain::from_rings`], and [`Error::RingOutsidePicture`].
    pub fn new(spec: Option<&DomainSpec>, picture: &Picture) -> Result<Self, Error> {
        Self::bounded(spec, picture, false)
    }

    /// The default domain of a project: the opaque part of a picture with transparency, or the whole of other pictures.
    #[must_use]
    pub fn default_spec(picture: &Picture<'_>) -> DomainSpec {
        let threshold = DomainSpec::THRESHOLD;
        if picture.has_transparency() { DomainSpec::Alpha { threshold } } else { DomainSpec::Image }
    }

    /// The same domain. If its boundary is `held`, it has fewer corners along the picture's alpha.
    ///
    /// # Errors
    /// The errors of [`Domain::new`].
    pub(crate) fn bounded(spec: Option<&DomainSpec>, picture: &Picture, held: bool) -> Result<Self, Error> {
        let bounds = if held { &HELD } else { &FREE };
        match spec {
            Some(DomainSpec::Image) => Ok(Self::rectangle(picture.width(), picture.height())),
            Some(DomainSpec::Alpha { threshold }) => Self::of_alpha(picture, *threshold, bounds),
            Some(DomainSpec::Polygon { rings, .. }) => Self::from_polygon(rings, picture.width(), picture.height()),
            None if picture.has_transparency() => Self::of_alpha(picture, DomainSpec::THRESHOLD, bounds),
            None => Ok(Self::rectangle(picture.width(), picture.height())),
        }
    }

    /// The whole picture.
    pub(crate) fn rectangle(width: u32, height: u32) -> Self {
        let (w, h) = (f64::from(width), f64::from(height));
        let ring = vec![DVec2::ZERO, DVec2::new(w, 0.0), DVec2::new(w, h), DVec2::new(0.0, h)];
        Self::from_checked(vec![ring], 0)
    }

    /// The region where the picture's alpha reaches `threshold` (in (0, 1]), bounded by sub-pixel contours.
    ///
    /// An outline with more than [`MAX_CORNERS`] corners is simplified, and includes gaps if necessary: see
    /// [`detail`](Self::detail).
    ///
    /// # Errors
    /// - [`Error::Project`] for a threshold out of range.
    /// - [`Error::NothingOpaque`] or [`Error::OnlySpecks`] if no region is large enough.
    pub fn from_alpha(picture: &Picture, threshold: f64) -> Result<Self, Error> {
        Self::of_alpha(picture, threshold, &FREE)
    }

    fn of_alpha(picture: &Picture, threshold: f64, bounds: &Bounds) -> Result<Self, Error> {
        DomainSpec::check_threshold(threshold)?;
        let Outline { rings, detail, gap, specks } = Outline::new(picture, threshold, bounds)?;
        let domain = match detail {
            OutlineDetail::Picture => Self::rectangle(picture.width(), picture.height()),
            _ => Self::from_checked(rings, specks),
        };
        Ok(Self { detail, gap, ..domain })
    }

    /// The inside of the project's rings by the even-odd rule, within a picture of the given size.
    ///
    /// # Errors
    /// The errors of [`from_rings`](Self::from_rings), except that a point outside the picture gives
    /// [`Error::RingOutsidePicture`].
    pub(crate) fn from_polygon(rings: &[Ring], width: u32, height: u32) -> Result<Self, Error> {
        DomainSpec::check_rings(rings)?;
        check_corner_count(rings)?;
        polygon::check(rings, width, height)?;
        Ok(Self::from_checked(islands::oriented(rings), 0))
    }

    /// The inside of rings by the even-odd rule, without a picture.
    ///
    /// Points are in pixels, each coordinate from −1,000,000 to 1,000,000. Tolerances are in pixels, as for an
    /// [`InputMesh`](crate::InputMesh). Scale rings with coordinates from 0 to 1 up to hundreds of pixels.
    ///
    /// ```
    /// use c2warp::{domain::Domain, glam::DVec2};
    ///
    /// let square = |low: f64, high: f64| {
    ///     [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec()
    /// };
    /// let domain = Domain::from_rings(&[square(-50.0, 50.0), square(-20.0, 20.0)])?;
    /// assert_eq!((domain.islands(), domain.holes(), domain.area()), (1, 1, 8400.0));
    /// # Ok::<(), c2warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// - [`Error::Project`] for an empty list, a ring of fewer than three points, or a point that is not finite.
    /// - [`Error::RingPoint`], [`Error::RingDuplicate`], [`Error::RingFlat`] or [`Error::RingsCross`] with the ring
    ///   and point.
    /// - [`Error::RingsTooFine`] for too many points.
    pub fn from_rings(rings: &[Ring]) -> Result<Self, Error> {
        DomainSpec::check_rings(rings)?;
        for (ring, points) in rings.iter().enumerate() {
            if let Some(point) = points.iter().position(|p| p.abs().max_element() > MAX_COORDINATE) {
                return Err(Error::RingPoint { ring, point });
            }
        }
        check_corner_count(rings)?;
        polygon::check_rings(rings)?;
        Ok(Self::from_checked(islands::oriented(rings), 0))
    }

    /// The region to the right of rings. Points must be finite.
    ///
    /// # Errors
    /// - [`Error::RingsTooFine`], [`Error::RingDuplicate`], [`Error::RingsCross`].
    /// - [`Error::RingFlat`] for an island inside an island, or a hole outside all islands.
    pub(crate) fn from_oriented(rings: Vec<Ring>) -> Result<Self, Error> {
        check_corner_count(&rings)?;
        polygon::check_simple(&rings)?;
        let misplaced = rings.iter().zip(islands::oriented(&rings)).position(|(ring, oriented)| *ring != oriented);
        misplaced.map_or_else(|| Ok(Self::from_checked(rings, 0)), |ring| Err(Error::RingFlat { ring }))
    }

    /// A domain from checked rings, each with the domain to its right.
    fn from_checked(rings: Vec<Ring>, specks: usize) -> Self {
        let islands = rings.iter().filter(|ring| signed_area(ring) > 0.0).count();
        Self { rings, islands, specks, detail: OutlineDetail::Traced, gap: 0.0 }
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

    /// How closely the outline follows the picture.
    #[must_use]
    pub fn detail(&self) -> OutlineDetail {
        self.detail
    }

    /// Maximum width of a gap that the domain includes to reduce the corners of its outline, in pixels.
    #[must_use]
    pub fn bridged_gap(&self) -> f64 {
        self.gap
    }

    /// Area in square pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.rings.iter().map(|ring| signed_area(ring)).sum()
    }

    /// The length of all rings, in pixels.
    pub(crate) fn perimeter(&self) -> f64 {
        self.edges().map(|(a, b)| a.distance(b)).sum()
    }

    /// The bounding box: least and greatest coordinates, in pixels.
    #[must_use]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        let points = self.rings.iter().flatten();
        points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)))
    }
}

fn corners(rings: &[Ring]) -> usize {
    rings.iter().map(Vec::len).sum()
}

/// Rejects rings with more corners than [`MAX_CORNERS`].
fn check_corner_count(rings: &[Ring]) -> Result<(), Error> {
    let corners = corners(rings);
    if corners > MAX_CORNERS { Err(Error::RingsTooFine { corners }) } else { Ok(()) }
}

impl Domain {
    /// The edges of the outline.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        self.rings.iter().flat_map(|ring| edges(ring))
    }

    /// Straight distance of a point to the outline, in pixels.
    ///
    /// For a point of the domain this is also the intrinsic distance: nothing lies between.
    pub(crate) fn distance_to_outline(&self, p: DVec2) -> f64 {
        self.edges().map(|(a, b)| segment_distance(p, a, b)).fold(f64::INFINITY, f64::min)
    }
}
