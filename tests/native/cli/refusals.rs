//! What is refused: in one line that says what, where and what to do, and without leaving anything behind.

use std::fs;

use image::{DynamicImage, ImageFormat, Rgba, RgbaImage};
use serde_json::json;

use crate::command::{command, refuse, succeed};
use crate::workplace::{PROJECT, Workplace};

const WARP: &str = "warp scene.c2warp.json -o out.png";

/// Refuses to warp; gives the line.
#[track_caller]
fn refused(place: &Workplace) -> String {
    let before = place.listing();
    let line = refuse(place.folder(), WARP);
    assert_eq!(place.listing(), before, "something was left behind");
    line
}

#[track_caller]
fn says(line: &str, parts: &[&str]) {
    for part in parts {
        assert!(line.contains(part), "{part:?} is missing in: {line}");
    }
}

fn bytes(picture: RgbaImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let picture = DynamicImage::ImageRgba8(picture);
    match format {
        ImageFormat::Jpeg => picture.into_rgb8().write_to(&mut bytes, format),
        _ => picture.write_to(&mut bytes, format),
    }
    .unwrap();
    bytes.into_inner()
}

#[test]
fn files_that_are_no_pictures() {
    let place = Workplace::with("strip");
    for (contents, reason) in [
        (&b""[..], "is empty"),
        (b"once upon a time", "is not a picture that can be read: PNG, JPEG and WebP can"),
        (b"GIF89a\x01\0\x01\0\x80\0\0", "is a picture of type Gif, which cannot be read: PNG, JPEG and WebP can"),
        (b"\x89PNG\r\n\x1a\n", "is damaged or cut short"),
    ] {
        place.write("strip.png", contents);
        says(&refused(&place), &["strip.png", reason]);
    }
    fs::remove_file(place.file("strip.png")).unwrap();
    says(&refused(&place), &["strip.png", "cannot be read"]);
    fs::create_dir(place.file("strip.png")).unwrap();
    says(&refused(&place), &["strip.png", "cannot be read"]);
}

#[test]
fn pictures_cut_short() {
    let place = Workplace::with("strip");
    let picture = place.picture("strip.png");
    for format in [ImageFormat::Png, ImageFormat::WebP, ImageFormat::Jpeg] {
        let whole = bytes(picture.clone(), format);
        for length in [16, whole.len() / 3, whole.len() / 2, whole.len() - 30] {
            place.write("strip.png", &whole[..length]);
            says(&refused(&place), &["strip.png", "is damaged or cut short"]);
        }
    }
}

#[test]
fn pictures_of_impossible_sizes() {
    let place = Workplace::with("strip");
    for (width, height) in [(1, 1), (1, 48), (20_000, 20)] {
        place.write("strip.png", bytes(RgbaImage::new(width, height), ImageFormat::Png));
        says(&refused(&place), &["strip.png", &format!("{width}×{height}")]);
    }
    // A head that promises 60,000 by 60,000 pixels, and nothing after it: refused before anything is set aside for them.
    let mut png = bytes(RgbaImage::new(2, 2), ImageFormat::Png);
    png[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    let crc = crc32(&png[12..29]).to_be_bytes();
    png[29..33].copy_from_slice(&crc);
    place.write("strip.png", png);
    says(&refused(&place), &["strip.png", "60000×60000"]);
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes
        .iter()
        .fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1))))
}

#[test]
fn a_picture_of_another_size_names_both() {
    let place = Workplace::with("strip").changed(|project| project["image"]["width"] = json!(95));
    says(&refused(&place), &["95×48", "96×48"]);
}

#[test]
fn a_picture_without_an_opaque_pixel() {
    let place = Workplace::with("ring");
    place.picture("ring.png").pixels_mut().for_each(|pixel| pixel[3] = 0);
    let clear = RgbaImage::from_pixel(128, 128, Rgba([9, 9, 9, 40]));
    clear.save(place.file("ring.png")).unwrap();
    says(&refused(&place), &["opaque", "0.5"]);
}

#[test]
fn handles_in_impossible_places() {
    let outside = Workplace::with("ring").changed(|project| project["handles"][1]["rest"] = json!([64, 64]));
    says(&refused(&outside), &["east", "outside"]);
    let beyond = Workplace::with("strip").changed(|project| project["handles"][0]["rest"] = json!([-3, 24]));
    says(&refused(&beyond), &["left", "outside"]);
    let far = Workplace::with("strip").changed(|project| project["handles"][0]["rest"] = json!([1e300, 24]));
    says(&refused(&far), &["handle “left” at (1e300, 24) lies outside"]);
    let coinciding = Workplace::with("strip").changed(|project| project["handles"][2]["rest"] = json!([48.001, 24]));
    says(
        &refused(&coinciding),
        &["handles “middle” and “right” are less than 0.01 px apart: move or delete one of them"],
    );
}

#[test]
fn projects_that_are_not_to_the_letter() {
    for (from, to, reason) in [
        ("[48, 24]", "[\"x\", 24]", "handles[1].rest[0]: expected a number, found \"x\""),
        ("[48, 24]", "[NaN, 24]", "handles[1].rest[0]: expected value"),
        ("\"rotation\"", "\"rotate\"", "handles[1].rotate: unknown key"),
        ("\"samples\"", "\"sample\"", "sample: unknown key"),
        ("1500", "12", "samples: expected a whole number from 100 to 2000000, found 12"),
        ("\"middle\"", "\"left\"", "handles[1].id: \"left\" is the name of another handle"),
        ("c2warp/1", "c2warp/2", "format: expected \"c2warp/1\", found \"c2warp/2\""),
        ("1.1", "-1", "handles[2].scale: expected a number above 0, found -1"),
        ("\"strip.png\"", "\"\"", "names no picture in image.src"),
        ("\"handles\"", "handles", "key must be a string"),
    ] {
        let place = Workplace::with("strip");
        let text = fs::read_to_string(place.file(PROJECT)).unwrap();
        assert!(text.contains(from));
        place.write(PROJECT, text.replacen(from, to, 1));
        says(&refused(&place), &["scene.c2warp.json: ", reason]);
    }
    let place = Workplace::with("strip");
    for (contents, reason) in
        [(&b""[..], "EOF"), (b"\xff\xfe{\0", "it is not UTF-8 text"), (b"[]", "expected an object")]
    {
        place.write(PROJECT, contents);
        says(&refused(&place), &["scene.c2warp.json: ", reason]);
    }
    fs::remove_file(place.file(PROJECT)).unwrap();
    says(&refused(&place), &["scene.c2warp.json: cannot be read"]);
}

#[test]
fn bars_and_polygons_that_are_none() {
    let line = |kind: &str, rest: serde_json::Value| json!({ "id": "tail", "kind": kind, "rest": rest });
    for (handle, held, reason) in [
        (
            line("bar", json!([[20, 20], [20, 20]])),
            false,
            "handle “tail” has no length between its corners 0 and the next",
        ),
        (line("bar", json!([[20, 20]])), false, "handles[3].rest: expected at least 2 points, found 1"),
        (line("polygon", json!([[20, 20], [30, 20]])), false, "handles[3].rest: expected at least 3 points, found 2"),
        (line("bar", json!([[40, 24], [60, 24]])), false, "handles “middle” and “tail” are"),
        (line("bar", json!([[-30, -20], [-10, -20]])), false, "handle “tail” at (-30, -20) lies outside the domain"),
        (line("bar", json!([[20, 0.5], [40, 0.5]])), true, "handle “tail” stands on the boundary, which is held"),
        (line("bar", json!([[20, 30], [40, 30], [25, 30]])), false, "“tail” run along each other"),
    ] {
        let place = Workplace::with("strip").changed(|project| {
            project["handles"].as_array_mut().unwrap().push(handle);
            project["fix_boundary"] = json!(held);
        });
        says(&refused(&place), &["scene.c2warp.json: ", reason]);
    }
}

#[test]
fn scales_that_make_no_picture() {
    let place = Workplace::with("strip");
    for scale in ["0", "-1", "NaN", "inf", "1e-9", "1000", "1e300"] {
        says(&refuse(place.folder(), &format!("{WARP} --scale {scale}")), &["--scale", "96×48", "16384"]);
    }
}

#[test]
fn points_that_are_none() {
    let place = Workplace::with("strip");
    for (contents, reason) in [
        (&b""[..], "the first line must be x,y"),
        (b"1,2\n3,4\n", "the first line must be x,y"),
        (b"x,y\n1,2\nfar,away\n", "line 3: expected two finite numbers x,y, found \"far,away\""),
        (b"x,y\n1,NaN\n", "line 2: expected two finite numbers"),
        (b"x,y\n1\n", "line 2: expected two finite numbers"),
        (b"x,y\n1,2,3\n", "line 2: expected two finite numbers"),
        (b"x,y\n\xff,2\n", "it is not UTF-8 text"),
    ] {
        place.write("points.csv", contents);
        for subcommand in ["weights", "map", "distance --from 1,1"] {
            let line = refuse(place.folder(), &format!("{subcommand} {PROJECT} --at points.csv -o out.csv"));
            says(&line, &["points.csv: ", reason]);
        }
    }
    says(&refuse(place.folder(), &format!("map {PROJECT} --at no.csv -o out.csv")), &["no.csv: cannot be read"]);
    assert!(!place.file("out.csv").exists());
}

#[test]
fn a_start_outside_the_domain() {
    let place = Workplace::with("ring");
    place.write("points.csv", "x,y\n108,64\n");
    for from in ["64,64", "-4,1e6"] {
        let line = refuse(place.folder(), &format!("distance {PROJECT} --from {from} --at points.csv -o out.csv"));
        says(&line, &["outside the domain"]);
    }
}

#[test]
fn outputs_that_cannot_be_written() {
    let place = Workplace::with("untouched");
    for output in ["no/such/folder/out.png", "."] {
        says(&refuse(place.folder(), &format!("warp {PROJECT} -o {output}")), &["cannot be written"]);
    }
    assert_eq!(place.listing(), [PROJECT, "strip.png"]);
}

#[test]
fn outputs_that_are_the_project_or_no_png() {
    let place = Workplace::with("untouched");
    place.write("points.csv", "x,y\n1,2\n");
    let before = fs::read(place.file(PROJECT)).unwrap();
    for subcommand in ["warp", "weights --at points.csv", "map --at points.csv", "distance --from 1,1 --at points.csv"]
    {
        says(&refuse(place.folder(), &format!("{subcommand} {PROJECT} -o ./{PROJECT}")), &[PROJECT, "is the project"]);
    }
    assert!(fs::read(place.file(PROJECT)).unwrap() == before);
    says(&refuse(place.folder(), &format!("warp {PROJECT} -o out.jpg")), &["out.jpg", "type Jpeg", "end it with .png"]);
    let with_map = |path: &str, map: &str| refuse(place.folder(), &format!("warp {PROJECT} -o {path} --stmap {map}"));
    says(&with_map("out.png", "map.png"), &["map.png", "type Png", "OpenExr", "end it with .exr"]);
    says(&with_map("out", "out"), &["out: is where the picture goes"]);
    says(&with_map("-", "/dev/stdout"), &["/dev/stdout: is where the picture goes"]);
    // What is no picture's name will do.
    succeed(place.folder(), &format!("warp {PROJECT} -o out.0001"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let place = Workplace::with("untouched");
    says(&refuse(place.folder(), &format!("warp {PROJECT} -o /dev/full")), &["cannot be written"]);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended = command(place.folder(), &format!("inspect {PROJECT}")).stdout(full).output().unwrap();
    assert_eq!(ended.status.code(), Some(1));
    says(&String::from_utf8(ended.stderr).unwrap(), &["c2warp: the output cannot be written"]);
}

#[test]
fn a_refusal_leaves_an_earlier_result_alone() {
    let place = Workplace::with("strip");
    succeed(place.folder(), WARP);
    let earlier = place.picture("out.png");
    place.write(PROJECT, "{}");
    refused(&place);
    assert!(place.picture("out.png").dimensions() == earlier.dimensions() && place.picture("out.png") == earlier);
}

#[test]
fn arguments_that_make_no_sense() {
    let place = Workplace::with("untouched");
    for arguments in
        ["", "bend", "warp", "warp scene.c2warp.json", "distance scene.c2warp.json --from here --at a -o b"]
    {
        let ended = command(place.folder(), arguments).output().unwrap();
        assert_eq!(ended.status.code(), Some(2), "{arguments}");
        assert!(!ended.stderr.is_empty());
    }
    assert!(command(place.folder(), "--help").output().unwrap().status.success());
}
