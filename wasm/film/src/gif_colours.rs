//! The colours of a GIF: the palette of a picture, and the treatment of translucent pixels.

use crate::palette::Dithering;

/// Least alpha of an opaque pixel, without a matte and on one. On a matte, soft edges blend with it.
const LEAST_ALPHA: [u8; 2] = [128, 16];

/// The colours of a GIF, known before its first frame.
///
/// A warp moves the colours of one picture, so its pixels determine the palette of all frames, including colours that
/// some frames hide. On clips of three samples, palettes of eight frames or of all frames were no better.
#[derive(Debug)]
pub struct GifColours {
    matte: Option<[u8; 3]>,
    dithering: Dithering,
}

impl GifColours {
    /// The index of transparent pixels.
    pub(crate) const TRANSPARENT: u8 = 255;

    /// The colours of a picture, as straight RGBA. It may have any size; at the size of the frames, it contains their
    /// fine mixtures. Soft edges blend with the colour `matte`, or else are cut at half their alpha.
    #[must_use]
    pub fn new(picture: &[u8], matte: Option<[u8; 3]>) -> Self {
        Self { matte, dithering: Dithering::new(shown(picture, matte)) }
    }

    /// Red, green and blue of 256 colours.
    pub(crate) fn palette(&self) -> &[u8] {
        self.dithering.palette()
    }

    /// The indices of a frame's pixels.
    pub(crate) fn indices(&mut self, rgba: &[u8], width: usize) -> Vec<u8> {
        let index = |(at, pixel): (usize, Option<[u8; 3]>)| {
            pixel.map_or(Self::TRANSPARENT, |colour| self.dithering.index(colour, [at % width, at / width]))
        };
        shown(rgba, self.matte).enumerate().map(index).collect()
    }
}

/// The pixels that are shown: opaque ones on the matte, `None` for transparent ones.
fn shown(rgba: &[u8], matte: Option<[u8; 3]>) -> impl Iterator<Item = Option<[u8; 3]>> + Clone {
    let least = LEAST_ALPHA[usize::from(matte.is_some())];
    rgba.as_chunks::<4>().0.iter().map(move |&[r, g, b, alpha]| {
        let blend = |colour: u8, matte: u8| {
            let (colour, matte, alpha) = (u32::from(colour), u32::from(matte), u32::from(alpha));
            ((colour * alpha + matte * (255 - alpha) + 127) / 255) as u8
        };
        let colour = [r, g, b];
        (alpha >= least).then(|| match matte {
            Some(matte) => std::array::from_fn(|k| blend(colour[k], matte[k])),
            None => colour,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::GifColours;

    /// The colours of a picture's pixels in a GIF.
    fn colours(picture: &[u8], matte: Option<[u8; 3]>, frame: &[u8]) -> Vec<Option<[u8; 3]>> {
        let mut colours = GifColours::new(picture, matte);
        let indices = colours.indices(frame, 2);
        let colour = |index: u8| colours.palette().as_chunks::<3>().0[usize::from(index)];
        indices.into_iter().map(|index| (index != GifColours::TRANSPARENT).then(|| colour(index))).collect()
    }

    #[test]
    fn translucent_pixels_are_cut_or_blended() {
        let picture = [[200, 0, 0, 255], [0, 100, 0, 127], [0, 0, 80, 128], [9, 9, 9, 15]].concat();
        let cut = [Some([200, 0, 0]), None, Some([0, 0, 80]), None];
        assert_eq!(colours(&picture, None, &picture), cut);
        let blended = [Some([200, 0, 0]), Some([128, 178, 128]), Some([127, 127, 167]), None];
        assert_eq!(colours(&picture, Some([255; 3]), &picture), blended);
    }

    #[test]
    fn every_frame_finds_the_colours_of_the_picture() {
        let picture = [[200, 0, 0, 255], [0, 0, 200, 255], [0, 200, 0, 255], [90, 90, 90, 255]].concat();
        for part in picture.chunks(8) {
            let wanted: Vec<_> = part.as_chunks::<4>().0.iter().map(|&[r, g, b, _]| Some([r, g, b])).collect();
            assert_eq!(colours(&picture, None, part), wanted);
        }
    }
}
