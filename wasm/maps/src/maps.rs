//! The maps of a warp, a few rows at a time.
//!
//! Positions are u to the right and v upwards, from 0 to 1 across a picture, as in ST maps. The centre of a picture's
//! lower left pixel is half a pixel from both axes.
//!
//! Cost: the inverse map is linear in the pixels. The forward map evaluates eq. 1 at each pixel of the domain: about
//! two microseconds. Memory: the rows of a band, besides the file.

use std::ops::Range;

use c2warp::{
    Canvas, Drawing, Picture, ResampleOptions, Solution,
    deform::Pose,
    glam::{DVec2, Vec4},
};

use crate::{MapError, about::about, float_file, png_file};

/// A quantity with a value at each pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Map {
    /// For each pixel of the warped picture, the position in the picture that it shows. Compositors use this ST map to
    /// bend pictures.
    Inverse,
    /// For each pixel of the picture, its position in the warped picture. Compositors use this ST map to undo the warp.
    Forward,
    /// How areas and lengths grow, at each pixel of the warped picture.
    Stretch,
    /// Whether the warp uncovers or covers each pixel of the warped picture.
    Disocclusion,
}

/// The format of a map's file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapFormat {
    /// OpenEXR with 32-bit floats.
    Exr,
    /// PNG with 16 bits per channel. Values outside 0 to 1 do not fit.
    Png,
}

impl MapFormat {
    /// The format of a file by its name.
    #[must_use]
    pub fn of_file(name: &str) -> Option<Self> {
        let extension = name.rsplit_once('.')?.1.to_ascii_lowercase();
        match extension.as_str() {
            "exr" => Some(Self::Exr),
            "png" => Some(Self::Png),
            _ => None,
        }
    }
}

/// A solved picture in a pose, with its drawing.
#[derive(Debug, Clone, Copy)]
pub struct Maps<'a> {
    /// The solution.
    pub solution: &'a Solution,
    /// The pose.
    pub pose: &'a Pose,
    /// The picture.
    pub picture: Picture<'a>,
    /// The drawing of the pose: its rectangle and scale are those of the warped picture.
    pub drawing: &'a Drawing,
    /// The name of the picture's file, for the header.
    pub name: &'a str,
}

impl Maps<'_> {
    /// The bytes of a map's file. `on_progress` receives the completed fraction.
    ///
    /// # Errors
    /// [`MapError`] if the file cannot be encoded.
    ///
    /// # Panics
    /// If the parts do not belong together.
    pub fn file(&self, map: Map, format: MapFormat, on_progress: &mut dyn FnMut(f64)) -> Result<Vec<u8>, MapError> {
        let size = self.size(map);
        let about = about(self, map, format);
        let [_, height] = size;
        let at_rest = (map == Map::Disocclusion).then(|| self.at_rest());
        match format {
            MapFormat::Exr => {
                float_file::encode(size, &about, |rows| self.rows(map, at_rest.as_ref(), rows), on_progress)
            }
            MapFormat::Png => png_file::encode(size, &about, |rows| {
                on_progress(f64::from(rows.start) / f64::from(height));
                let values = self.rows(map, at_rest.as_ref(), rows);
                values.into_iter().map(|value| levels(map, value)).collect()
            }),
        }
    }

    /// Width and height of a map in pixels.
    #[must_use]
    pub fn size(&self, map: Map) -> [u32; 2] {
        match map {
            Map::Forward => [self.picture.width(), self.picture.height()],
            Map::Inverse | Map::Stretch | Map::Disocclusion => [self.drawing.width(), self.drawing.height()],
        }
    }

    /// The values of some rows. The first one is a multiple of [`Drawing::BAND_ROWS`].
    fn rows(&self, map: Map, at_rest: Option<&Drawing>, rows: Range<u32>) -> Vec<[f32; 4]> {
        match map {
            Map::Inverse => self.inverse(rows),
            Map::Forward => self.forward(rows),
            Map::Stretch => self.stretch(rows),
            Map::Disocclusion => self.disocclusion(at_rest, rows),
        }
    }

    fn inverse(&self, rows: Range<u32>) -> Vec<[f32; 4]> {
        let sides = [self.picture.width(), self.picture.height()].map(f64::from);
        let sources = self.drawing.sources(&self.picture, rows);
        let value = |source: c2warp::Source| {
            if source.coverage == 0.0 {
                return [0.0; 4];
            }
            let [u, v] = uv(DVec2::from(source.rest.map(f64::from)), sides);
            [u, v, source.det, source.coverage]
        };
        sources.into_iter().map(value).collect()
    }

    fn forward(&self, rows: Range<u32>) -> Vec<[f32; 4]> {
        let extent = self.drawing.extent();
        let origin = DVec2::from(extent.origin.map(f64::from));
        let sides = [extent.width, extent.height].map(f64::from);
        let centre = |x: u32, y: u32| DVec2::new(f64::from(x), f64::from(y)) + 0.5;
        let centres: Vec<DVec2> = rows.flat_map(|y| (0..self.picture.width()).map(move |x| centre(x, y))).collect();
        let posed = self.solution.posed_points(self.pose, &centres);
        let value = |posed: Option<DVec2>| match posed {
            Some(posed) => {
                let [u, v] = uv(posed * self.drawing.scale() + origin, sides);
                [u, v, 0.0, 1.0]
            }
            None => [0.0; 4],
        };
        posed.into_iter().map(value).collect()
    }

    fn stretch(&self, rows: Range<u32>) -> Vec<[f32; 4]> {
        let value = |source: c2warp::Source| {
            let [greatest, least] = source.stretch;
            [source.det, greatest, least, source.coverage]
        };
        self.drawing.sources(&self.picture, rows).into_iter().map(value).collect()
    }

    fn disocclusion(&self, at_rest: Option<&Drawing>, rows: Range<u32>) -> Vec<[f32; 4]> {
        let after = self.drawing.rows(&self.picture, rows.clone());
        let before = at_rest.map_or_else(|| vec![0; after.len()], |at_rest| at_rest.rows(&self.picture, rows));
        let opacities = |rgba: &[u8]| rgba.chunks_exact(4).map(|pixel| f32::from(pixel[3])).collect::<Vec<_>>();
        let both = opacities(&before).into_iter().zip(opacities(&after));
        both.map(|(before, after)| [(before - after).max(0.0) / 255.0, (after - before).max(0.0) / 255.0, 0.0, 1.0])
            .collect()
    }

    /// The picture at rest in the rectangle of the drawing.
    fn at_rest(&self) -> Drawing {
        let size = DVec2::new(self.picture.width().into(), self.picture.height().into());
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| corner * size);
        let canvas = Canvas::Fixed(self.drawing.extent());
        let options = ResampleOptions { scale: self.drawing.scale(), canvas, ..ResampleOptions::default() };
        Drawing::new(&self.picture, &corners, &corners, &[[0, 1, 2], [0, 2, 3]], options)
            .expect("the drawing of the pose has the same scale and rectangle")
    }
}

/// A position in a picture as u and v.
fn uv(place: DVec2, [width, height]: [f64; 2]) -> [f32; 2] {
    [(place.x / width) as f32, (1.0 - place.y / height) as f32]
}

/// Octaves that the levels of a stretch map span: from 1/16 to 16.
const OCTAVES: f64 = 8.0;

/// The levels of a PNG, from 0 to 1.
fn levels(map: Map, value: [f32; 4]) -> [f32; 4] {
    let [.., alpha] = value;
    match map {
        // Half is 1, and an octave is an eighth. What is turned over is 0.
        Map::Stretch if alpha > 0.0 => {
            let level = |stretch: f32| if stretch > 0.0 { 0.5 + libm::log2(stretch.into()) / OCTAVES } else { 0.0 };
            let [area, greatest, least] = [0, 1, 2].map(|channel| level(value[channel]).clamp(0.0, 1.0) as f32);
            [area, greatest, least, alpha]
        }
        // A place outside the picture has no level, and the growth of areas does not fit.
        Map::Inverse | Map::Forward => {
            let [u, v, ..] = value;
            let fits = [u, v].iter().all(|place| (0.0..=1.0).contains(place));
            if fits { [u, v, 0.0, alpha] } else { [0.0; 4] }
        }
        Map::Stretch | Map::Disocclusion => Vec4::from(value).clamp(Vec4::ZERO, Vec4::ONE).to_array(),
    }
}
