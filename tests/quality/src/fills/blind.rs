//! Blind sheets: the same holes by the three methods under letters, so that nobody knows whose is whose.

use image::{Rgba, RgbaImage, imageops};

use super::{Filled, holes};
use crate::sheet::{LABEL, write};

/// The side of a square that shows one hole.
const SIDE: u32 = 260;
const GAP: u32 = 6;
const LETTERS: [&str; 3] = ["A", "B", "C"];

impl Filled {
    /// A row for each hole, a column for each method in the order of [`Filled::blind_order`].
    #[must_use]
    pub fn blind_sheet(&self) -> RgbaImage {
        let (width, height) = self.pasted.dimensions();
        let holes: Vec<_> = holes(width, height).collect();
        let step = SIDE + GAP;
        let mut sheet = RgbaImage::from_pixel(3 * step, holes.len() as u32 * (step + LABEL), Rgba([255; 4]));
        for (row, (middle, half)) in (0_u32..).zip(holes) {
            for (column, method) in (0_u32..).zip(self.blind_order(row)) {
                let (x, y) = (column * step, row * (step + LABEL));
                write(&mut sheet, &format!("{}{}", row + 1, LETTERS[column as usize]), x, y + LABEL - 6);
                let [left, top] = (middle - half).max(glam::DVec2::ZERO).floor().to_array().map(|side| side as u32);
                let side = (2.0 * half) as u32;
                let part = imageops::crop_imm(&self.results[method], left, top, side, side).to_image();
                let large = imageops::resize(&part, SIDE, SIDE, imageops::FilterType::Triangle);
                imageops::replace(&mut sheet, &large, i64::from(x), i64::from(y + LABEL));
            }
        }
        sheet
    }

    /// The methods of the columns of a row: shuffled, and the same in every run.
    #[must_use]
    pub fn blind_order(&self, row: u32) -> [usize; 3] {
        // FNV-1a over the name and the row.
        let bytes = self.name.bytes().chain(row.to_le_bytes());
        let hash =
            bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
        let mut order = [0, 1, 2];
        order.swap(0, (hash >> 40) as usize % 3);
        order.swap(1, 1 + (hash >> 50) as usize % 2);
        order
    }

    /// The lines of the key: whose is which.
    #[must_use]
    pub fn blind_key(&self) -> String {
        let rows = 0..holes(1, 1).count() as u32;
        rows.map(|row| {
            let [a, b, c] = self.blind_order(row).map(|method| self.methods[method]);
            format!("{} {}: A {a}, B {b}, C {c}\n", self.name, row + 1)
        })
        .collect()
    }
}
