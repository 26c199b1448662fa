//! The part of a drawing that is not empty, found before drawing.
//!
//! Cost: a fraction of a drawing. Rows are drawn from the top and from the bottom, up to the first row with opacity.
//! Elsewhere, only facets outside the columns found so far are drawn.

use std::ops::Range;

use super::BAND_ROWS;
use super::band::Band;
use super::facet::Facet;
use super::fade::Fades;
use super::frame::{Area, Frame};
use super::layers::Textures;

/// Returns `known`, grown to hold every pixel with opacity.
///
/// `facets` are relative to the frame, and `bins` holds those of each band.
pub(super) fn covered(
    known: Area,
    frame: Frame,
    (facets, fades): (&[Facet], &Fades),
    bins: &[Vec<u32>],
    textures: &Textures<'_>,
) -> Area {
    let [width, height] = frame.size;
    let mut search =
        Search { area: known, facets, fades, textures, band: Band::new(width, BAND_ROWS, frame.origin), frame };
    for (index, bin) in bins.iter().enumerate() {
        if !search.area.is_empty() && search.area.rows.start <= index * BAND_ROWS {
            break;
        }
        search.visit(index, bin, |_| true);
    }
    for (index, bin) in bins.iter().enumerate().rev() {
        if !search.area.is_empty() && search.area.rows.end >= height.min((index + 1) * BAND_ROWS) {
            break;
        }
        search.visit(index, bin, |_| true);
    }
    for (index, bin) in bins.iter().enumerate() {
        let Range { start, end } = search.area.columns;
        search.visit(index, bin, |facet| {
            let columns = facet.columns(width);
            columns.start < start || columns.end > end
        });
    }
    search.area
}

struct Search<'a> {
    area: Area,
    frame: Frame,
    facets: &'a [Facet],
    fades: &'a Fades,
    textures: &'a Textures<'a>,
    band: Band,
}

impl Search<'_> {
    /// Draws some facets of a band and includes the pixels with opacity. All facets of a pixel outside the known
    /// columns must be among them.
    fn visit(&mut self, index: usize, bin: &[u32], is_drawn: impl Fn(&Facet) -> bool) {
        let [width, height] = self.frame.size;
        let drawn = || bin.iter().filter(|&&facet| is_drawn(&self.facets[facet as usize]));
        if drawn().next().is_none() {
            return;
        }
        self.band.clear(index * BAND_ROWS);
        for &facet in drawn() {
            self.band.draw(&self.facets[facet as usize], self.textures.of(facet), self.fades.of(facet));
        }
        for row in index * BAND_ROWS..height.min((index + 1) * BAND_ROWS) {
            let has_opacity = |x: &usize| self.band.has_opacity(*x, row);
            if let Some(first) = (0..width).find(has_opacity) {
                let last = (first..width).rev().find(has_opacity).unwrap_or(first);
                self.area.include(first..last + 1, row);
            }
        }
    }
}
