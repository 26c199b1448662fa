//! Animated pictures from frames: GIF, APNG, WebP, and sprite sheets.
//!
//! Frames are added one after another, as straight RGBA of the film's size; bytes are written as they become available.
//! The crate does not depend on warps, clips or files, so it also runs in a browser. Memory: one frame, except for a
//! sheet.

mod apng;
mod film;
mod gif;
mod gif_colours;
mod palette;
mod png_error;
mod sheet;
mod webp;

pub use self::apng::Apng;
pub use self::film::{Encoder, Film, Plays};
pub use self::gif::{Gif, MOST_GIF_RATE};
pub use self::gif_colours::GifColours;
pub use self::sheet::{MOST_SHEET_SIDE, Sheet};
pub use self::webp::WebP;
