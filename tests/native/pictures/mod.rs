//! The generated pictures of the scenes.

mod figures;
mod paint;
mod small;

use image::RgbaImage;

use self::paint::painted;

/// Returns the picture with this file name.
///
/// # Panics
/// If no scene has such a picture.
#[must_use]
pub fn drawn(name: &str) -> RgbaImage {
    enlarged(name, 1)
}

/// Returns the picture drawn at `times` its size.
///
/// # Panics
/// As [`drawn`], and if the picture has one size only.
#[must_use]
pub fn enlarged(name: &str, times: u32) -> RgbaImage {
    let figure = |width, height, paint| painted(width, height, times, paint);
    match name {
        "gingerbread.png" => figure(180, 220, figures::gingerbread),
        "tower.png" => figure(200, 260, figures::tower),
        "portrait.png" => figure(200, 260, figures::portrait),
        "moth.png" => figure(220, 180, figures::moth),
        "road.png" => figure(260, 180, figures::road),
        "tiles.png" => figure(160, 120, figures::tiles),
        _ if times == 1 => small::drawn(name),
        _ => panic!("{name} has one size only"),
    }
}
