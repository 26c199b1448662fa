//! Sheets: pictures of a pose by several methods, side by side.

use std::convert::Infallible;

use c2warp::{Picture, ResampleOptions, raster};
use embedded_graphics::{
    Drawable, Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    mono_font::{MonoTextStyle, ascii::FONT_10X20},
    pixelcolor::BinaryColor,
    text::Text,
};
use glam::DVec2;
use image::{Rgba, RgbaImage, imageops};

use crate::{
    measure::{energy, jacobians, stretches},
    methods::{Comparison, Method, Outcome},
};

/// The longer side of a panel in pixels.
const PANEL: f64 = 360.0;
/// Height of the labels in pixels.
pub(crate) const LABEL: u32 = 28;
/// Number of grid lines along the longer side.
const LINES: u32 = 40;

/// The contents of a row of panels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Row {
    /// A grid with the sites. Flipped triangles are red.
    Grid,
    /// The picture.
    Picture,
    /// The energy, from blue through green to red.
    Energy,
}

impl Row {
    /// All rows in the order of sheets.
    pub const ALL: [Self; 3] = [Self::Grid, Self::Picture, Self::Energy];
}

/// Draws the sheet of a pose, with a column for each method that succeeded.
#[must_use]
pub fn sheet(comparison: &Comparison, methods: &[Method], rows: &[Row]) -> RgbaImage {
    let view = View::around(comparison);
    let (width, height) = (view.width, view.height);
    let shown: Vec<&Outcome> = methods.iter().filter_map(|&method| comparison.outcome_of(method)).collect();
    let size = (shown.len() as u32 * (width + 8), rows.len() as u32 * (height + 8) + LABEL);
    let mut sheet = RgbaImage::from_pixel(size.0, size.1, Rgba([255; 4]));
    let grid = grid(comparison);
    for (column, outcome) in (0_u32..).zip(shown) {
        let x = column * (width + 8) + 4;
        let label = format!("{}  E {:.3}", outcome.method.name().replace(", rigid", " +"), outcome.distortion.energy);
        write(&mut sheet, &label, x, 20);
        for (row, contents) in (0_u32..).zip(rows) {
            let panel = match contents {
                Row::Grid => view.warped(comparison, outcome, &grid, true),
                Row::Picture => view.warped(comparison, outcome, &comparison.scene.picture, false),
                Row::Energy => view.energies(comparison, outcome),
            };
            imageops::overlay(&mut sheet, &panel, x.into(), (LABEL + row * (height + 8)).into());
        }
    }
    sheet
}

/// The view of a panel.
struct View {
    width: u32,
    height: u32,
    low: DVec2,
    scale: f64,
}

impl View {
    /// Returns the view that holds the result of every method.
    fn around(comparison: &Comparison) -> Self {
        let points = comparison.outcomes.iter().flat_map(|outcome| &outcome.posed);
        let first = comparison.mesh.vertices[0];
        let (low, high) = points.fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
        let margin = 0.03 * (high - low).max_element();
        let (low, high) = (low - margin, high + margin);
        let scale = PANEL / (high - low).max_element();
        let size = (scale * (high - low)).ceil();
        Self { width: size.x as u32, height: size.y as u32, low, scale }
    }

    fn at(&self, p: DVec2) -> DVec2 {
        self.scale * (p - self.low)
    }

    fn warped(&self, comparison: &Comparison, outcome: &Outcome, texture: &RgbaImage, marked: bool) -> RgbaImage {
        let mesh = &comparison.mesh;
        let posed: Vec<DVec2> = outcome.posed.iter().map(|&p| self.at(p)).collect();
        let (width, height) = texture.dimensions();
        let picture =
            Picture::new(width, height, texture.as_raw()).expect("the pose's own picture, or one of its size");
        // The result has the shape of the picture. Make it large enough for the panel, and crop it.
        let side = f64::from(self.width).max(f64::from(self.height));
        let scale = side / f64::from(width.min(height));
        let to_picture: Vec<DVec2> = posed.iter().map(|&p| p / scale).collect();
        let warped = raster::warp(
            &picture,
            &mesh.vertices,
            &to_picture,
            &mesh.triangles,
            ResampleOptions { scale, ..ResampleOptions::default() },
        )
        .expect("a fair size");
        let whole = RgbaImage::from_raw(warped.width, warped.height, warped.rgba).expect("as many bytes as pixels");
        let mut panel = RgbaImage::from_pixel(self.width, self.height, Rgba([244, 244, 240, 255]));
        imageops::overlay(&mut panel, &whole, 0, 0);
        if marked {
            let all = jacobians_of(comparison, outcome);
            for t in (0..all.len()).filter(|&t| stretches(all[t])[1] < 0.0) {
                fill(&mut panel, mesh.corners(t, &posed), Rgba([230, 0, 0, 255]));
            }
            for &(_, posed) in &outcome.sites {
                dot(&mut panel, self.at(posed), 1.5, Rgba([0, 60, 220, 255]));
            }
            for (_, to) in comparison.constraints.check_points() {
                dot(&mut panel, self.at(to), 2.0, Rgba([255, 150, 0, 255]));
            }
            for &(_, to) in &comparison.constraints.points {
                dot(&mut panel, self.at(to), 5.0, Rgba([0, 0, 0, 255]));
                dot(&mut panel, self.at(to), 3.5, Rgba([255, 200, 0, 255]));
            }
        }
        panel
    }

    fn energies(&self, comparison: &Comparison, outcome: &Outcome) -> RgbaImage {
        let mut panel = RgbaImage::from_pixel(self.width, self.height, Rgba([244, 244, 240, 255]));
        let posed: Vec<DVec2> = outcome.posed.iter().map(|&p| self.at(p)).collect();
        for (t, j) in jacobians_of(comparison, outcome).into_iter().enumerate() {
            fill(&mut panel, comparison.mesh.corners(t, &posed), heat(energy(stretches(j))));
        }
        panel
    }
}

fn jacobians_of(comparison: &Comparison, outcome: &Outcome) -> Vec<glam::DMat2> {
    jacobians(&comparison.mesh, &outcome.posed)
}

/// Returns a colour for the logarithm of the energy, from 0.001 (blue) to 10 (red).
fn heat(energy: f64) -> Rgba<u8> {
    let t = ((energy.max(1e-9).log10() + 3.0) / 4.0).clamp(0.0, 1.0);
    let peak = |at: f64| (255.0 * (1.5 - 4.0 * (t - at).abs()).clamp(0.0, 1.0)) as u8;
    Rgba([peak(0.8), peak(0.5), peak(0.2), 255])
}

/// Draws lines over pale tiles, at the size of the picture.
fn grid(comparison: &Comparison) -> RgbaImage {
    let (width, height) = comparison.scene.picture.dimensions();
    let step = width.max(height) / LINES;
    let thin = (step / 7).max(1);
    RgbaImage::from_fn(width, height, |x, y| {
        let thick = if x % (5 * step) < 2 * thin || y % (5 * step) < 2 * thin { 0 } else { 90 };
        if x % step < thin || y % step < thin || thick == 0 {
            Rgba([thick, thick, thick, 255])
        } else {
            let tint = (160 * x / width) as u8;
            Rgba([95 + tint, 235, 255 - tint, 255])
        }
    })
}

/// Fills a triangle.
pub(crate) fn fill(panel: &mut RgbaImage, corners: [DVec2; 3], colour: Rgba<u8>) {
    let [a, b, c] = corners;
    let twice = (b - a).perp_dot(c - a);
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let limit = DVec2::new(panel.width().into(), panel.height().into());
    let (from, to) = (low.floor().max(DVec2::ZERO), (high.ceil() + 1.0).min(limit));
    for y in from.y as u32..to.y.max(0.0) as u32 {
        for x in from.x as u32..to.x.max(0.0) as u32 {
            let p = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let inside = [(a, b), (b, c), (c, a)].iter().all(|&(s, e)| (e - s).perp_dot(p - s) * twice >= 0.0);
            if inside {
                panel.put_pixel(x, y, colour);
            }
        }
    }
}

/// Draws a disc.
pub(crate) fn dot(panel: &mut RgbaImage, centre: DVec2, radius: f64, colour: Rgba<u8>) {
    let (from, to) = ((centre - radius).floor().max(DVec2::ZERO), centre + radius);
    for y in from.y as u32..=(to.y.max(0.0) as u32).min(panel.height() - 1) {
        for x in from.x as u32..=(to.x.max(0.0) as u32).min(panel.width() - 1) {
            if DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5).distance(centre) <= radius {
                panel.put_pixel(x, y, colour);
            }
        }
    }
}

pub(crate) fn write(sheet: &mut RgbaImage, text: &str, x: u32, baseline: u32) {
    let style = MonoTextStyle::new(&FONT_10X20, BinaryColor::On);
    let at = Point::new(x as i32, baseline as i32);
    let Ok(_) = Text::new(text, at, style).draw(&mut Ink(sheet));
}

/// Draws in black.
struct Ink<'a>(&'a mut RgbaImage);

impl OriginDimensions for Ink<'_> {
    fn size(&self) -> Size {
        Size::new(self.0.width(), self.0.height())
    }
}

impl DrawTarget for Ink<'_> {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, colour) in pixels {
            if colour == BinaryColor::On
                && let Some(pixel) = self.0.get_pixel_mut_checked(at.x as u32, at.y as u32)
            {
                *pixel = Rgba([0, 0, 0, 255]);
            }
        }
        Ok(())
    }
}
