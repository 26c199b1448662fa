//! The weight of a handle over the picture at rest, in the colours of the editor's heat maps.
//!
//! Weights are interpolated between the vertices of the mesh, as in the editor.
//!
//! Cost: linear in the pixels, plus linear in the triangles for each band of rows.

use c2warp::{Picture, Solution, glam::DVec2};
use png::BitDepth;

use crate::{error::MapError, png_file, weights::Weights};

/// An sRGB colour, 0 to 255, and an opacity, 0 to 1.
pub type RampColour = [f64; 4];

/// The colours of 0, 0.2, … 1: from transparent through blue to yellow.
///
/// The OKLab lightness rises in equal steps from 0.42 to 0.93, so that the ramp is readable without hue. Nearly
/// everyone can distinguish blue from yellow.
pub const HEAT_RAMP: [RampColour; 6] = [
    [85.0, 40.0, 169.0, 0.0],
    [59.0, 98.0, 196.0, 0.55],
    [18.0, 149.0, 187.0, 0.65],
    [54.0, 191.0, 166.0, 0.7],
    [142.0, 223.0, 124.0, 0.74],
    [244.0, 240.0, 78.0, 0.78],
];

/// The bytes of a PNG with the picture under the colours of the weights. `on_progress` receives the completed fraction.
///
/// # Errors
/// [`MapError`] if the file cannot be encoded.
///
/// # Panics
/// If the weights belong to another solution.
pub fn heat_map(
    solution: &Solution,
    weights: &Weights<'_>,
    picture: Picture<'_>,
    on_progress: &mut dyn FnMut(f64),
) -> Result<Vec<u8>, MapError> {
    let at_vertices = weights.at_vertices();
    let about = "Heat map by c2warp: the weight of a handle over the picture at rest, from blue near 0 to yellow at 1.";
    let (width, height) = (picture.width(), picture.height());
    png_file::write([width, height], BitDepth::Eight, about, |rows| {
        on_progress(f64::from(rows.start) / f64::from(height));
        let centre = |x: u32, y: u32| DVec2::new(f64::from(x), f64::from(y)) + 0.5;
        let first = rows.start as usize * width as usize * 4;
        let centres: Vec<DVec2> = rows.flat_map(|y| (0..width).map(move |x| centre(x, y))).collect();
        let heats = solution.interpolated(&at_vertices, &centres);
        let pixels = picture.rgba()[first..].as_chunks::<4>().0;
        pixels.iter().zip(heats).flat_map(|(&pixel, heat)| heat.map_or(pixel, |heat| heated(pixel, heat))).collect()
    })
}

/// A pixel covered with the colour of a weight from 0 to 1.
fn heated([red, green, blue, alpha]: [u8; 4], heat: f64) -> [u8; 4] {
    let at = heat.clamp(0.0, 1.0) * 5.0;
    let below = (at as usize).min(4);
    let part = at - below as f64;
    let ramp = |channel: usize| {
        let [low, high] = [below, below + 1].map(|colour| HEAT_RAMP[colour][channel]);
        low + (high - low) * part
    };
    let opacity = ramp(3);
    let mixed = |own: u8, channel: usize| (f64::from(own) * (1.0 - opacity) + ramp(channel) * opacity + 0.5) as u8;
    [mixed(red, 0), mixed(green, 1), mixed(blue, 2), alpha]
}

#[cfg(test)]
mod tests {
    use super::heated;

    #[test]
    fn colours_range_from_the_picture_to_yellow() {
        assert_eq!(heated([10, 20, 30, 40], 0.0), [10, 20, 30, 40]);
        assert_eq!(heated([0, 0, 0, 255], 1.0), [190, 187, 61, 255]);
        assert_eq!(heated([0, 0, 0, 255], 7.0), heated([0, 0, 0, 255], 1.0));
    }
}
