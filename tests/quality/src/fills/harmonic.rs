//! Harmonic diffusion: each pixel of the hole is the mean of its neighbours.

use image::RgbaImage;

const SWEEPS: usize = 2000;
const RELAXATION: f32 = 1.9;

/// Fills the hole of a picture.
pub(super) fn filled(picture: &RgbaImage, hole: &[bool]) -> RgbaImage {
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let mut colours: Vec<[f32; 3]> =
        picture.pixels().map(|pixel| [0, 1, 2].map(|part| f32::from(pixel.0[part]))).collect();
    let unknown: Vec<usize> = (0..hole.len()).filter(|&at| hole[at]).collect();
    for &at in &unknown {
        colours[at] = [128.0; 3];
    }
    for _ in 0..SWEEPS {
        for &at in &unknown {
            let (x, y) = (at % width, at / width);
            let beside =
                [(x > 0, -1), (x + 1 < width, 1), (y > 0, -(width as isize)), (y + 1 < height, width as isize)];
            let (mut sum, mut count) = ([0.0; 3], 0.0);
            for (_, step) in beside.into_iter().filter(|(exists, _)| *exists) {
                let other = colours[at.wrapping_add_signed(step)];
                sum.iter_mut().zip(other).for_each(|(sum, part)| *sum += part);
                count += 1.0;
            }
            colours[at].iter_mut().zip(sum).for_each(|(part, sum)| *part += RELAXATION * (sum / count - *part));
        }
    }
    let mut result = picture.clone();
    for at in unknown {
        let [r, g, b] = colours[at].map(|part| part.round() as u8);
        result.put_pixel((at % width) as u32, (at / width) as u32, image::Rgba([r, g, b, 255]));
    }
    result
}
