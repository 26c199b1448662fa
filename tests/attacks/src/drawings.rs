//! The text of a drawing, as the command and the editor read it.

use c2warp_vector::Drawing;

use crate::promises::expect_sentence;

/// Pixels of a side. Drawings grow by this, so radii and regions are large in it.
const SIDE: u32 = 256;

/// Reads a drawing, and draws it if that is known to take little time.
///
/// # Panics
/// If the reader panics, or an error or a remark has several lines.
pub fn attack(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let drawing = match Drawing::read(text) {
        Ok(drawing) => drawing,
        Err(error) => return expect_sentence(&error.to_string()),
    };
    drawing.remarks().iter().for_each(|remark| expect_sentence(&remark.to_string()));
    match drawing.cost(SIDE, SIDE) {
        Ok(cost) if cost.is_light() => {
            let pixels = drawing.pixels(SIDE, SIDE).expect("its cost is known");
            assert_eq!(pixels.len(), 4 * (SIDE * SIDE) as usize);
        }
        Ok(_) => {}
        Err(error) => expect_sentence(&error.to_string()),
    }
}
