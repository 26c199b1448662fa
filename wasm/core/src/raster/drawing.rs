//! A warped picture that is drawn in bands of rows, so that callers can show progress, stop, and keep few rows in
//! memory.

use std::ops::Range;

use glam::DVec2;

use super::band::Band;
use super::covered::covered;
use super::edges::Edges;
use super::extent::Extent;
use super::facet::{Facet, mesh_facets};
use super::fade::Fades;
use super::frame::{Area, Frame};
use super::layers::{Behind, Textures};
use super::options::{Canvas, Filter, ResampleOptions};
use super::sources::{Source, SourceRows};
use super::texture::{MipLevel, Texture, mip_levels};
use super::warped::Warped;
use super::{BAND_ROWS, MeshLayer, check_range, facets_by_band, warped_size};
use crate::{deform::Bounds, error::Error, picture::Picture};

/// A warped picture, ready to be drawn.
///
/// It holds about 110 bytes per triangle, and the mip levels. Over a [fill](crate::fill) it also copies the picture.
/// The picture is passed to each call.
///
/// ```
/// use c2warp::{Drawing, ResampleOptions, Picture, glam::DVec2, raster::warp};
///
/// let rgba: Vec<u8> = (0..16 * 40).flat_map(|i| [i as u8, 0, 0, 255]).collect();
/// let picture = Picture::new(16, 40, &rgba)?;
/// let rest = [(0.0, 0.0), (16.0, 0.0), (16.0, 40.0), (0.0, 40.0)].map(DVec2::from);
/// let posed = rest.map(|corner| corner * 0.9);
/// let (triangles, options) = ([[0, 1, 2], [0, 2, 3]], ResampleOptions::default());
/// let drawing = Drawing::new(&picture, &rest, &posed, &triangles, options)?;
/// let bands = [0..16, 16..32, 32..40].map(|rows| drawing.rows(&picture, rows));
/// assert_eq!(bands.concat(), warp(&picture, &rest, &posed, &triangles, options)?.rgba);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug)]
pub struct Drawing {
    frame: Frame,
    scale: f64,
    filter: Filter,
    /// Facets in drawing order, relative to the frame.
    facets: Vec<Facet>,
    /// The facets that fade out.
    fades: Fades,
    /// Indices of the facets in each band of [`BAND_ROWS`].
    bins: Vec<Vec<u32>>,
    mip_levels: Vec<MipLevel>,
    behind: Option<Behind>,
    edges: Option<Edges>,
}

impl Drawing {
    /// Bands start at multiples of this number of rows.
    pub const BAND_ROWS: u32 = BAND_ROWS as u32;

    /// Prepares to warp a picture by a mesh: see [`warp`](super::warp), which draws all rows at once.
    ///
    /// # Errors
    /// - [`Error::Scale`] as for [`warped_size`].
    /// - [`Error::Canvas`] if the canvas exceeds the largest size of a picture.
    /// - [`Error::NothingDrawn`] if the canvas would be empty.
    ///
    /// # Panics
    /// If `rest` and `posed` differ in length, or a triangle refers to a vertex that does not exist.
    pub fn new(
        picture: &Picture<'_>,
        rest: &[DVec2],
        posed: &[DVec2],
        triangles: &[[u32; 3]],
        options: ResampleOptions,
    ) -> Result<Self, Error> {
        Self::over(picture, None, &[MeshLayer { rest, posed, triangles, levels: None }], options)
    }

    /// The same for several meshes, over a static picture of the same size behind them. Its pixels are `behind`. At
    /// most one mesh may fade out.
    pub(crate) fn over(
        picture: &Picture<'_>,
        behind: Option<Vec<u8>>,
        layers: &[MeshLayer<'_>],
        ResampleOptions { scale, canvas, filter, edges: _ }: ResampleOptions,
    ) -> Result<Self, Error> {
        let picture_size = warped_size(picture.width(), picture.height(), scale)?;
        let (behind, mut facets) = match behind {
            Some(rgba) => {
                let (behind, facets) = Behind::new(picture, rgba, filter, scale);
                (Some(behind), facets)
            }
            None => (None, Vec::new()),
        };
        let (first, mut fades) = (facets.len(), Fades::default());
        for layer in layers {
            facets.extend(match layer.levels {
                Some(levels) => {
                    let faded;
                    (fades, faded) = Fades::new(layer, levels, scale, facets.len());
                    faded
                }
                None => mesh_facets(layer.rest, layer.posed, layer.triangles, scale),
            });
        }
        let mip_levels = mip_levels(*picture, filter, &facets[first..]);
        let own = Frame::of_picture(picture_size);
        let known = match canvas {
            Canvas::Picture => Some(own),
            Canvas::Fixed(extent) => Some(Frame::of_extent(extent)?),
            Canvas::Grown | Canvas::Covered => None,
        };
        if let Some(frame) = known {
            move_by(&mut facets, frame.origin);
            let bins = facets_by_band(&facets, frame.size[1]);
            return Ok(Self { frame, scale, filter, facets, fades, bins, mip_levels, behind, edges: None });
        }
        layers.iter().try_for_each(|layer| check_range(layer.posed, layer.triangles, scale))?;
        let around = own.around(&facets)?;
        move_by(&mut facets, around.origin);
        let bins = facets_by_band(&facets, around.size[1]);
        let known = if canvas == Canvas::Grown { around.area_of_picture(picture_size) } else { Area::EMPTY };
        let textures = Textures::new(Texture::new(*picture, filter, &mip_levels), behind.as_ref(), picture, filter);
        let area = covered(known, around, (&facets, &fades), &bins, &textures);
        if area.is_empty() {
            return Err(Error::NothingDrawn);
        }
        let frame = around.of_area(&area);
        move_by(&mut facets, [0, 1].map(|axis| frame.origin[axis] - around.origin[axis]));
        let bins = facets_by_band(&facets, frame.size[1]);
        Ok(Self { frame, scale, filter, facets, fades, bins, mip_levels, behind, edges: None })
    }

    /// Prepares to draw a whole picture at rest, at a scale. The canvas is that of the picture.
    ///
    /// # Errors
    /// [`Error::Scale`] as for [`warped_size`].
    pub fn at_rest(picture: &Picture<'_>, options: ResampleOptions) -> Result<Self, Error> {
        Self::whole(picture, ResampleOptions { canvas: Canvas::Picture, ..options })
    }

    /// The same on any canvas.
    pub(crate) fn whole(picture: &Picture<'_>, options: ResampleOptions) -> Result<Self, Error> {
        let size = DVec2::new(picture.width().into(), picture.height().into());
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner * size);
        Self::new(picture, &corners, &corners, &[[0, 1, 2], [0, 2, 3]], options)
    }

    /// The same drawing with edges where parts cross, except behind a soft rim. `around` bounds all crossings, in
    /// pixels of the picture, and `scale` is that of [`new`](Self::new).
    pub(crate) fn with_edges(self, picture: &Picture<'_>, scale: f64, around: Bounds) -> Self {
        let behind = self.behind.as_ref().map_or(0, |behind| behind.facets);
        let first = behind.max(self.fades.facets().end) as usize;
        let edges = Edges::new(picture, self.frame, &self.facets[first..], scale, around);
        Self { edges, ..self }
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.frame.size[0] as u32
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.frame.size[1] as u32
    }

    /// Pixels of the result per pixel of the picture.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The rectangle of the result.
    #[must_use]
    pub fn extent(&self) -> Extent {
        self.frame.extent()
    }

    /// Draws rows of the result, in straight (not premultiplied) RGBA. `picture` is the one of [`new`](Self::new).
    ///
    /// # Panics
    /// If the rows do not start at a multiple of [`BAND_ROWS`](Self::BAND_ROWS), or do not lie in the result.
    #[must_use]
    pub fn rows(&self, picture: &Picture<'_>, rows: Range<u32>) -> Vec<u8> {
        let width = self.frame.size[0];
        let Range { start, end } = self.whole_bands(rows);
        let textures = self.textures(picture);
        let mut rgba = vec![0; (end - start) * width * 4];
        let mut band = Band::new(width, BAND_ROWS, self.frame.origin);
        let bins = self.bins.iter().enumerate().skip(start / BAND_ROWS);
        for (bytes, (index, bin)) in rgba.chunks_mut(width * BAND_ROWS * 4).zip(bins) {
            if bin.is_empty() {
                continue;
            }
            band.clear(index * BAND_ROWS);
            for &facet in bin {
                band.draw(&self.facets[facet as usize], textures.of(facet), self.fades.of(facet));
            }
            band.resolve(bytes);
        }
        if let Some(edges) = &self.edges {
            edges.darken(picture, &mut rgba, start);
        }
        rgba
    }

    fn textures<'a>(&'a self, picture: &Picture<'a>) -> Textures<'a> {
        let texture = Texture::new(*picture, self.filter, &self.mip_levels);
        Textures::new(texture, self.behind.as_ref(), picture, self.filter)
    }

    /// The same rows as indices, if they belong to this result and begin with a band.
    fn whole_bands(&self, rows: Range<u32>) -> Range<usize> {
        let (start, end, height) = (rows.start as usize, rows.end as usize, self.frame.size[1]);
        assert!(start % BAND_ROWS == 0 && start <= end && end <= height, "rows {rows:?} of {height}");
        start..end
    }

    /// The source of each pixel of the given rows. Soft rims have no source, because pixels there show two points at
    /// once. `picture` is the one of [`new`](Self::new).
    ///
    /// # Panics
    /// Like [`rows`](Self::rows).
    #[must_use]
    pub fn sources(&self, picture: &Picture<'_>, rows: Range<u32>) -> Vec<Source> {
        let width = self.frame.size[0];
        let Range { start, end } = self.whole_bands(rows);
        let textures = self.textures(picture);
        let mut sources = vec![Source::default(); (end - start) * width];
        let bins = self.bins.iter().enumerate().skip(start / BAND_ROWS);
        for (sources, (index, bin)) in sources.chunks_mut(width * BAND_ROWS).zip(bins) {
            let first = index * BAND_ROWS;
            let band = SourceRows {
                rows: first..first + sources.len() / width,
                width,
                origin: DVec2::from(self.frame.origin.map(|side| side as f64)),
                scale: self.scale,
                picture: DVec2::new(picture.width().into(), picture.height().into()),
            };
            let whole = bin.iter().filter(|facet| !self.fades.facets().contains(facet));
            let drawn = whole.map(|&facet| (&self.facets[facet as usize], textures.of(facet)));
            band.fill(drawn, sources);
        }
        sources
    }

    /// Draws the whole result.
    #[must_use]
    pub fn warped(&self, picture: &Picture<'_>) -> Warped {
        let Extent { origin, width, height } = self.extent();
        Warped { width, height, origin, rgba: self.rows(picture, 0..height) }
    }
}

fn move_by(facets: &mut [Facet], by: [i64; 2]) {
    facets.iter_mut().for_each(|facet| facet.move_by(by));
}
