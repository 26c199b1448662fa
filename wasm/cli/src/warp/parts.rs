//! A picture drawn in parts, on several cores.

use std::num::NonZero;
use std::sync::{Mutex, PoisonError};

use c2warp::{Drawing, Picture};

use crate::workers;

/// Bands of a part: enough to avoid waiting, and few enough that all cores finish at about the same time.
const BANDS: u32 = 4;

/// The RGBA of the whole result, drawn with up to `threads` threads. The bytes equal those of [`Drawing::warped`].
pub(super) fn rgba(drawing: &Drawing, picture: &Picture<'_>, threads: NonZero<usize>) -> Vec<u8> {
    let (width, height) = (drawing.width(), drawing.height());
    let rows = BANDS * Drawing::BAND_ROWS;
    let row_bytes = width as usize * 4;
    let mut rgba = vec![0; height as usize * row_bytes];
    let starts = (0..height).step_by(rows as usize);
    let part = |(start, bytes)| (start..height.min(start + rows), Mutex::new(bytes));
    let parts: Vec<_> = starts.zip(rgba.chunks_mut(rows as usize * row_bytes)).map(part).collect();
    workers::each(threads, &parts, |_, (rows, bytes)| {
        let mut bytes = bytes.lock().unwrap_or_else(PoisonError::into_inner);
        bytes.copy_from_slice(&drawing.rows(picture, rows.clone()));
    });
    rgba
}
