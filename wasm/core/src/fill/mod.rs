//! The picture behind a domain of rings, filled from its surroundings.
//!
//! PatchMatch finds a similar patch for each patch over the hole (Barnes et al. 2009). All patches over a texel vote
//! for its colour (Wexler et al. 2007), from a small copy of the picture to larger ones (Newson et al. 2014). Pixels
//! are then copied from the sources of their texels. A Poisson equation hides seams (Pérez et al. 2003).
//!
//! The hole is the domain and a narrow band around it, so that antialiased rims lie in it. Colours are premultiplied.
//! Opacity is filled like a colour, so transparent surroundings continue.
//!
//! Cost: bounded by 250,000 texels of hole and surroundings, about 100 bytes each, plus linear in the pixels of the
//! hole. Known limits: objects are not recognised, so parts of objects may be copied. If the surroundings are smaller
//! than the hole, the same patches repeat.

mod carried;
mod filler;
mod level;
mod matches;
mod membrane;
mod peeling;
mod random;
mod region;
mod spread;
mod votes;

pub(crate) use self::filler::Filler;

use crate::{
    domain::{Domain, Mask},
    error::Error,
    picture::Picture,
    project::FillSpec,
};

/// Fills a domain of a picture from its surroundings, in one call.
///
/// # Errors
/// [`Error::NothingToFillFrom`] if the domain covers the whole picture.
pub fn fill(picture: &Picture<'_>, domain: &Domain, spec: &FillSpec) -> Result<Fill, Error> {
    let mut filler = Filler::new(picture, Mask::new(domain.rings(), picture.size()), spec)?;
    loop {
        if let Some(fill) = filler.advance(picture) {
            return Ok(fill);
        }
    }
}

/// A box of a picture whose hole is filled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fill {
    origin: [u32; 2],
    width: u32,
    height: u32,
    rgba: Vec<u8>,
}

/// The box of a mask with the pixels of the picture, and with those of `filled` in the hole.
fn patch(picture: &Picture<'_>, mask: &Mask, filled: impl Fn(u32, u32) -> [u8; 4]) -> Fill {
    let [left, top] = mask.origin;
    let mut rgba = Vec::with_capacity(mask.width as usize * mask.height as usize * 4);
    for (y, x) in (top..top + mask.height).flat_map(|y| (left..left + mask.width).map(move |x| (y, x))) {
        rgba.extend(if mask.has(x, y) { filled(x, y) } else { picture.pixel(x as usize, y as usize) });
    }
    Fill { origin: mask.origin, width: mask.width, height: mask.height, rgba }
}

impl Fill {
    /// All pixels of the picture, including the filled ones.
    #[must_use]
    pub fn over(&self, picture: &Picture<'_>) -> Vec<u8> {
        let mut rgba = picture.rgba().to_vec();
        let stride = picture.width() as usize * 4;
        let first = self.origin[1] as usize * stride + self.origin[0] as usize * 4;
        for (row, filled) in self.rgba.chunks_exact(self.width as usize * 4).enumerate() {
            rgba[first + row * stride..][..filled.len()].copy_from_slice(filled);
        }
        rgba
    }

    /// The box's upper left corner in the picture, in pixels.
    #[must_use]
    pub fn origin(&self) -> [u32; 2] {
        self.origin
    }

    /// Width of the box in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height of the box in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The pixels of the box, straight RGBA.
    #[must_use]
    pub fn rgba(&self) -> &[u8] {
        &self.rgba
    }
}
