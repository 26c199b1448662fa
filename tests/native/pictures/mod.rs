//! The pictures of the scenes.

mod figures;
mod paint;
mod small;

use image::RgbaImage;

use self::paint::painted;

/// The picture of a name, as the scenes refer to it.
///
/// # Panics
/// Where no scene has a picture of this name.
#[must_use]
pub fn drawn(name: &str) -> RgbaImage {
    enlarged(name, 1)
}

/// The same picture drawn at so many times its size.
///
/// # Panics
/// As [`drawn`]; and for a picture that has one size only.
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
