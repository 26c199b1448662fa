//! `c2warp warp`.

use std::collections::HashSet;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageDecoder, ImageEncoder, ImageReader, RgbImage, Rgba};

use crate::command::{command, refuse, succeed};
use crate::workplace::Workplace;

const WARP: &str = "warp scene.c2warp.json -o out.png";

#[test]
fn a_scene_at_rest_is_the_picture_to_the_byte() {
    let place = Workplace::with("strip").at_rest();
    succeed(place.folder(), WARP);
    assert!(place.picture("out.png") == place.picture("strip.png"));
}

#[test]
fn a_scene_without_handles_is_the_picture_to_the_byte() {
    let place = Workplace::with("untouched");
    succeed(place.folder(), WARP);
    assert!(place.picture("out.png") == place.picture("strip.png"));
}

#[test]
fn without_handles_what_is_no_part_of_the_domain_stays_too() {
    let place = Workplace::with("ring").changed(|project| {
        project["handles"] = serde_json::json!([]);
        project["domain"] = serde_json::json!({ "kind": "alpha", "threshold": 1 });
    });
    let mut soft = place.picture("ring.png");
    // A shadow, and a speck.
    soft.enumerate_pixels_mut().for_each(|(x, _, pixel)| pixel[3] = pixel[3].max((x % 100) as u8));
    soft.put_pixel(1, 1, Rgba([200, 10, 10, 255]));
    soft.pixels_mut().filter(|pixel| pixel[3] == 0).for_each(|pixel| pixel.0 = [0; 4]);
    soft.save(place.file("ring.png")).unwrap();
    succeed(place.folder(), WARP);
    assert!(place.picture("out.png") == soft);
}

#[test]
fn a_ring_at_rest_keeps_its_inside_and_its_rim() {
    let place = Workplace::with("ring").at_rest();
    succeed(place.folder(), WARP);
    let (before, after) = (place.picture("ring.png"), place.picture("out.png"));
    for (x, y, &Rgba([r, g, b, a])) in before.enumerate_pixels() {
        let warped = after.get_pixel(x, y).0;
        if a == 255 {
            assert_eq!(warped, [r, g, b, a], "at {x}, {y}");
        }
        assert!(warped[3].abs_diff(a) <= 4, "at {x}, {y}: {} was {a}", warped[3]);
    }
}

#[test]
fn one_handle_alone_moves_its_island_and_no_other() {
    let place = Workplace::with("islands");
    succeed(place.folder(), WARP);
    let (before, after) = (place.picture("islands.png"), place.picture("out.png"));
    for (x, y, pixel) in before.enumerate_pixels().filter(|(_, _, pixel)| pixel[3] == 255) {
        let (x, y) = if x < 60 { (x + 5, y - 3) } else { (x, y) };
        assert_eq!(after.get_pixel(x, y), pixel, "at {x}, {y}");
    }
}

#[test]
fn a_handle_takes_the_picture_with_it() {
    let place = Workplace::with("strip");
    succeed(place.folder(), WARP);
    let after = place.picture("out.png");
    // The square of the checkerboard under the handle `middle`, from (48, 24) to (50, 18).
    let difference = |a: Rgba<u8>, b: Rgba<u8>| a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap();
    let before = place.picture("strip.png");
    assert!(difference(*after.get_pixel(52, 21), *before.get_pixel(51, 27)) < 12);
    assert!(after != before);
}

#[test]
fn the_scale_is_that_of_the_result() {
    let place = Workplace::with("strip").at_rest();
    for (scale, size) in [("0.5", (48, 24)), ("2", (192, 96)), ("1.01", (97, 48))] {
        succeed(place.folder(), &format!("{WARP} --scale {scale}"));
        let after = place.picture("out.png");
        assert_eq!(after.dimensions(), size);
        assert!(after.pixels().all(|pixel| pixel[3] == 255), "at scale {scale}");
    }
}

#[test]
fn a_grown_result_holds_all_of_the_picture_and_tells_its_origin() {
    let place = Workplace::with("strip").at_rest();
    assert_eq!(succeed(place.folder(), &format!("{WARP} --grow")), b"0,0\n");
    assert!(place.picture("out.png") == place.picture("strip.png"));

    let place = place.changed(|project| {
        for handle in project["handles"].as_array_mut().unwrap() {
            let [x, y] = [0, 1].map(|axis| handle["rest"][axis].as_f64().unwrap());
            handle["posed"] = serde_json::json!([x - 20.0, y + 6.0]);
        }
    });
    assert_eq!(succeed(place.folder(), &format!("{WARP} --grow")), b"20,0\n");
    let grown = place.picture("out.png");
    assert_eq!(grown.dimensions(), (116, 54));
    for (x, y, pixel) in place.picture("strip.png").enumerate_pixels() {
        assert_eq!(grown.get_pixel(x, y + 6), pixel, "at {x}, {y}");
    }
    assert_eq!(succeed(place.folder(), &format!("{WARP} --grow --scale 0.5")), b"10,0\n");
    assert_eq!(place.picture("out.png").dimensions(), (58, 27));
}

#[test]
fn what_is_too_far_out_to_be_drawn_is_refused_where_all_is_asked_for() {
    for far in [1e6, 1.2e6, 9e6] {
        let place = Workplace::with("strip").changed(|project| {
            let handles = project["handles"].as_array_mut().unwrap();
            handles.truncate(1);
            handles[0]["posed"] = serde_json::json!([far, 20.0]);
        });
        let line = refuse(place.folder(), &format!("{WARP} --grow"));
        assert!(line.contains("all of the warped picture would take"), "{line}");
    }
}

#[test]
fn pixel_art_has_the_colours_of_the_picture_and_no_others() {
    let place = Workplace::with("strip");
    let known: HashSet<Rgba<u8>> = place.picture("strip.png").pixels().copied().chain([Rgba([0; 4])]).collect();
    let mixed = |name: &str| place.picture(name).pixels().filter(|pixel| !known.contains(pixel)).count();
    succeed(place.folder(), WARP);
    assert!(mixed("out.png") > 100);
    for more in ["--pixelated", "--pixelated --grow --scale 2"] {
        succeed(place.folder(), &format!("{WARP} {more}"));
        assert_eq!(mixed("out.png"), 0, "{more}");
    }
}

#[test]
fn the_same_project_gives_the_same_file() {
    let place = Workplace::with("ring");
    succeed(place.folder(), WARP);
    succeed(place.folder(), "warp scene.c2warp.json -o again.png");
    let bytes = |name| std::fs::read(place.file(name)).unwrap();
    assert!(bytes("out.png") == bytes("again.png"));
}

#[test]
fn another_picture_may_take_the_place_of_the_projects() {
    let place = Workplace::with("strip").at_rest();
    let mut grey = place.picture("strip.png");
    grey.pixels_mut().for_each(|pixel| pixel.0 = [7, 7, 7, 255]);
    // The type is told from the contents.
    grey.save_with_format(place.file("grey.jpg"), image::ImageFormat::WebP).unwrap();
    std::fs::remove_file(place.file("strip.png")).unwrap();
    succeed(place.folder(), &format!("{WARP} --image grey.jpg"));
    assert!(place.picture("out.png") == grey);
}

#[test]
fn a_photograph_taken_sideways_stands_upright() {
    let place = Workplace::with("untouched");
    // Lies on its side: red on the left becomes red on top when turned clockwise by a quarter.
    let sideways = RgbImage::from_fn(48, 96, |x, _| if x < 24 { [250, 0, 0] } else { [0, 0, 250] }.into());
    // A TIFF header and one entry: tag 0x0112 (orientation), one short, 6 (turn clockwise by a quarter).
    let exif = [b"II*\0\x08\0\0\0".as_slice(), b"\x01\0", b"\x12\x01\x03\0\x01\0\0\0\x06\0\0\0", b"\0\0\0\0"].concat();
    let mut jpeg = Vec::new();
    let mut encoder = JpegEncoder::new_with_quality(&mut jpeg, 100);
    encoder.set_exif_metadata(exif).unwrap();
    encoder.encode_image(&sideways).unwrap();
    place.write("photo.jpg", jpeg);
    succeed(place.folder(), &format!("{WARP} --image photo.jpg"));
    let upright = place.picture("out.png");
    assert_eq!(upright.dimensions(), (96, 48));
    assert!(upright.get_pixel(48, 4)[0] > 240 && upright.get_pixel(48, 44)[2] > 240);
}

#[test]
fn colours_keep_the_profile_that_they_are_meant_by() {
    let place = Workplace::with("untouched");
    // Of an ICC profile the space of its colours plays a part, and no more.
    let profile = |space: &[u8; 4]| [[7; 16].as_slice(), space, &[7; 700]].concat();
    let out = || {
        succeed(place.folder(), &format!("{WARP} --image tagged"));
        let mut decoder = ImageReader::open(place.file("out.png")).unwrap().into_decoder().unwrap();
        decoder.icc_profile().unwrap()
    };
    let tagged = RgbImage::from_pixel(96, 48, [200, 100, 50].into());
    for (space, kept) in [(b"RGB ", Some(profile(b"RGB "))), (b"GRAY", None)] {
        let mut jpeg = Vec::new();
        let mut encoder = JpegEncoder::new(&mut jpeg);
        encoder.set_icc_profile(profile(space)).unwrap();
        encoder.encode_image(&tagged).unwrap();
        place.write("tagged", jpeg);
        assert_eq!(out(), kept);
        let mut png = Vec::new();
        let mut encoder = PngEncoder::new(&mut png);
        encoder.set_icc_profile(profile(space)).unwrap();
        encoder.write_image(&tagged, 96, 48, ExtendedColorType::Rgb8).unwrap();
        place.write("tagged", png);
        assert_eq!(out(), kept);
    }
    // What a PNG says by other chunks is kept as a profile: here a gamma of 1.
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(&tagged, 96, 48, ExtendedColorType::Rgb8).unwrap();
    let end_of_header = 33;
    png.splice(end_of_header..end_of_header, *b"\0\0\0\x04gAMA\0\x01\x86\xa0\x31\xe8\x96\x5f");
    place.write("tagged", png);
    assert!(out().is_some());
}

#[cfg(unix)]
#[test]
fn a_link_and_a_pipe_are_written_through() {
    let place = Workplace::with("untouched");
    place.write("real.png", "");
    std::os::unix::fs::symlink("real.png", place.file("out.png")).unwrap();
    succeed(place.folder(), WARP);
    assert!(place.file("out.png").is_symlink());
    let piped = command(place.folder(), "warp scene.c2warp.json -o /dev/stdout").output().unwrap().stdout;
    assert!(piped == std::fs::read(place.file("real.png")).unwrap());
    assert_eq!(place.listing(), ["out.png", "real.png", "scene.c2warp.json", "strip.png"]);
    // Also one to what is not there yet.
    std::fs::remove_file(place.file("real.png")).unwrap();
    succeed(place.folder(), WARP);
    assert!(place.file("out.png").is_symlink() && place.file("real.png").is_file());
}
