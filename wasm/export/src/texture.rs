//! The picture of a rig, with the colours of its edges in the transparent pixels around them.
//!
//! Engines scale textures and blend neighbouring pixels with straight alpha. So the colour of transparent pixels shows
//! at the edges of the picture, often as a dark line. Each ring of pixels around the visible ones takes the mean
//! colours of the previous ring. These pixels remain transparent.
//!
//! Cost: linear in the pixels.

use c2warp::Picture;

/// How far colours extend, in pixels. A texture drawn at an eighth of its size blends pixels this far apart.
const REACH_PX: usize = 8;
/// The weight of a filled pixel in the mean, equal to that of an opaque pixel.
const OPAQUE: u32 = 255;

/// The pixels of a picture for a texture: straight RGBA, rows from top to bottom.
#[must_use]
pub fn texture(picture: &Picture) -> Vec<u8> {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let mut rgba = picture.rgba().to_vec();
    // The weight of a pixel's colour: 0 while it has no colour.
    let mut weights: Vec<u32> = rgba.chunks_exact(4).map(|pixel| u32::from(pixel[3])).collect();
    let around = |at: usize| {
        let (x, y) = (at % width, at / width);
        let rows = y.saturating_sub(1)..=(y + 1).min(height - 1);
        rows.flat_map(move |row| (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(move |column| row * width + column))
    };
    let mut ring: Vec<usize> =
        (0..weights.len()).filter(|&at| weights[at] == 0 && around(at).any(|other| weights[other] > 0)).collect();
    for _ in 0..REACH_PX {
        let mean = |&at: &usize| {
            let (mut sums, mut all) = ([0_u32; 3], 0);
            for other in around(at) {
                let weight = weights[other];
                (0..3).for_each(|channel| sums[channel] += weight * u32::from(rgba[4 * other + channel]));
                all += weight;
            }
            sums.map(|sum| ((sum + all / 2) / all) as u8)
        };
        let colours: Vec<[u8; 3]> = ring.iter().map(mean).collect();
        for (&at, colour) in ring.iter().zip(colours) {
            rgba[4 * at..4 * at + 3].copy_from_slice(&colour);
            weights[at] = OPAQUE;
        }
        let mut next: Vec<usize> = ring.iter().flat_map(|&at| around(at)).filter(|&at| weights[at] == 0).collect();
        next.sort_unstable();
        next.dedup();
        ring = next;
    }
    rgba
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transparent_pixels_near_an_edge_take_its_colour() {
        let (width, height) = (24, 3);
        let colour = |x: usize| match x {
            0 | 1 => [200, 10, 30, 255],
            2 => [100, 10, 30, 128],
            _ => [7, 7, 7, 0],
        };
        let rgba: Vec<u8> = (0..width * height).flat_map(|at| colour(at % width)).collect();
        let found = texture(&Picture::new(width as u32, height as u32, &rgba).unwrap());
        for (at, (before, after)) in rgba.chunks_exact(4).zip(found.chunks_exact(4)).enumerate() {
            let x = at % width;
            let expected = if (3..3 + REACH_PX).contains(&x) { [100, 10, 30, 0] } else { colour(x) };
            assert_eq!(after, expected, "at {x}");
            assert_eq!(after[3], before[3]);
        }
    }

    #[test]
    fn pictures_without_an_edge_stay_as_they_are() {
        for alpha in [0, 255] {
            let rgba: Vec<u8> = (0..5 * 5).flat_map(|at| [at, 2 * at, 9, alpha]).collect();
            assert_eq!(texture(&Picture::new(5, 5, &rgba).unwrap()), rgba);
        }
    }
}
