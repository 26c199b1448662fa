//! Tests of invalid input. An error is one line that names the problem, its location and a remedy. No file is left
//! behind.

use std::fs;

use image::{DynamicImage, ImageFormat, Rgba, RgbaImage};
use serde_json::json;

use crate::command::{command, fail, succeed};
use crate::scene_folder::{PROJECT, SceneFolder};

const WARP: &str = "warp scene.c2warp.json -o out.png";

/// Fails to warp and returns the error message. No file may change its name, appear or vanish.
#[track_caller]
fn fail_to_warp(folder: &SceneFolder) -> String {
    let before = folder.file_names();
    let line = fail(folder.path(), WARP);
    assert_eq!(folder.file_names(), before, "a file was left behind");
    line
}

#[track_caller]
fn assert_contains(line: &str, parts: &[&str]) {
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
fn invalid_picture_files_are_rejected() {
    let folder = SceneFolder::new("strip");
    for (contents, reason) in [
        (&b""[..], "the file is empty"),
        (b"once upon a time", "this is not a PNG, JPEG, WebP or SVG picture"),
        (b"GIF89a\x01\0\x01\0\x80\0\0", "this is a GIF picture: save it as PNG, JPEG or WebP"),
        (b"II*\0\x08\0\0\0", "this is a TIFF picture: save it as PNG, JPEG or WebP"),
        (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", "this is a HEIC picture: save it as"),
        (b"\x89PNG\r\n\x1a\n", "the picture is damaged or truncated"),
    ] {
        folder.write("strip.png", contents);
        assert_contains(&fail_to_warp(&folder), &["strip.png", reason]);
    }
    fs::remove_file(folder.file("strip.png")).unwrap();
    assert_contains(&fail_to_warp(&folder), &["strip.png", "cannot read this file"]);
    fs::create_dir(folder.file("strip.png")).unwrap();
    assert_contains(&fail_to_warp(&folder), &["strip.png", "cannot read this file"]);
}

#[test]
fn truncated_pictures_are_rejected() {
    let folder = SceneFolder::new("strip");
    let picture = folder.picture("strip.png");
    for format in [ImageFormat::Png, ImageFormat::WebP, ImageFormat::Jpeg] {
        let whole = bytes(picture.clone(), format);
        for length in [16, whole.len() / 3, whole.len() / 2, whole.len() - 30] {
            folder.write("strip.png", &whole[..length]);
            assert_contains(&fail_to_warp(&folder), &["strip.png", "the picture is damaged or truncated"]);
        }
    }
}

#[test]
fn picture_whose_decoder_panics_is_damaged() {
    let folder = SceneFolder::new("strip");
    folder.write("strip.jpg", include_bytes!("../../attacks/corpus/pictures/decoder-that-panics"));
    let new = "new strip.jpg --handles 3,3 --output new.c2warp.json";
    // The decoder panics where the processor has AVX2.
    if command(folder.path(), new).output().unwrap().status.code() != Some(0) {
        assert_contains(&fail(folder.path(), new), &["strip.jpg: the picture is damaged or truncated"]);
    }
}

#[test]
fn too_small_and_too_large_pictures_are_rejected() {
    let folder = SceneFolder::new("strip");
    for (width, height) in [(1, 1), (1, 48), (20_000, 20)] {
        folder.write("strip.png", bytes(RgbaImage::new(width, height), ImageFormat::Png));
        assert_contains(&fail_to_warp(&folder), &["strip.png", &format!("{width}×{height}")]);
    }
    // The header promises 60,000 by 60,000 pixels. It must be rejected before memory is allocated.
    let mut png = bytes(RgbaImage::new(2, 2), ImageFormat::Png);
    png[16..24].copy_from_slice(&[0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60]);
    let crc = crc32(&png[12..29]).to_be_bytes();
    png[29..33].copy_from_slice(&crc);
    folder.write("strip.png", png);
    assert_contains(&fail_to_warp(&folder), &["strip.png", "60000×60000"]);
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes
        .iter()
        .fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1))))
}

#[test]
fn mismatching_picture_size_names_both_sizes() {
    let folder = SceneFolder::new("strip").edited(|project| project["image"]["width"] = json!(95));
    assert_contains(&fail_to_warp(&folder), &["95×48", "96×48"]);
}

#[test]
fn transparent_picture_is_rejected() {
    let folder = SceneFolder::new("ring");
    folder.picture("ring.png").pixels_mut().for_each(|pixel| pixel[3] = 0);
    let clear = RgbaImage::from_pixel(128, 128, Rgba([9, 9, 9, 40]));
    clear.save(folder.file("ring.png")).unwrap();
    assert_contains(&fail_to_warp(&folder), &["opaque", "0.5"]);
}

#[test]
fn handles_outside_or_too_close_are_rejected() {
    let outside = SceneFolder::new("ring").edited(|project| project["handles"][1]["rest"] = json!([64, 64]));
    assert_contains(&fail_to_warp(&outside), &["east", "outside"]);
    let beyond = SceneFolder::new("strip").edited(|project| project["handles"][0]["rest"] = json!([-3, 24]));
    assert_contains(&fail_to_warp(&beyond), &["left", "outside"]);
    let far = SceneFolder::new("strip").edited(|project| project["handles"][0]["rest"] = json!([1e300, 24]));
    assert_contains(&fail_to_warp(&far), &["handle “left” at (1e300, 24) lies outside"]);
    let coinciding = SceneFolder::new("strip").edited(|project| project["handles"][2]["rest"] = json!([48.001, 24]));
    assert_contains(
        &fail_to_warp(&coinciding),
        &["handles “middle” and “right” are less than 0.01 px apart: move or delete one of them"],
    );
}

#[test]
fn invalid_projects_name_the_offending_key() {
    for (from, to, reason) in [
        ("[48, 24]", "[\"x\", 24]", "handles[1].rest[0]: expected a number, found \"x\""),
        ("[48, 24]", "[NaN, 24]", "handles[1].rest[0]: expected value"),
        ("\"rotation\"", "\"rotate\"", "handles[1].rotate: unknown key"),
        ("\"samples\"", "\"sample\"", "sample: unknown key"),
        ("1500", "12", "samples: expected a whole number from 100 to 2000000, found 12"),
        ("\"middle\"", "\"left\"", "handles[1].id: \"left\" is already the id of another handle"),
        ("c2warp/1", "c2warp/2", "format: expected \"c2warp/1\", found \"c2warp/2\""),
        ("1.1", "-1", "handles[2].scale: expected a number above 0, found -1"),
        ("\"strip.png\"", "\"\"", "image.src is empty"),
        ("\"handles\"", "handles", "key must be a string"),
    ] {
        let folder = SceneFolder::new("strip");
        let text = fs::read_to_string(folder.file(PROJECT)).unwrap();
        assert!(text.contains(from));
        folder.write(PROJECT, text.replacen(from, to, 1));
        assert_contains(&fail_to_warp(&folder), &["scene.c2warp.json: ", reason]);
    }
    let folder = SceneFolder::new("strip");
    for (contents, reason) in
        [(&b""[..], "EOF"), (b"\xff\xfe{\0", "the file is not UTF-8 text"), (b"[]", "expected an object")]
    {
        folder.write(PROJECT, contents);
        assert_contains(&fail_to_warp(&folder), &["scene.c2warp.json: ", reason]);
    }
    fs::remove_file(folder.file(PROJECT)).unwrap();
    assert_contains(&fail_to_warp(&folder), &["scene.c2warp.json: cannot read this file"]);
}

#[test]
fn invalid_bars_and_polygons_are_rejected() {
    let line = |kind: &str, rest: serde_json::Value| json!({ "id": "tail", "kind": kind, "rest": rest });
    for (handle, fix_boundary, reason) in [
        (line("bar", json!([[20, 20], [20, 20]])), false, "corner 0 of handle “tail” coincides with the next corner"),
        (line("bar", json!([[20, 20]])), false, "handles[3].rest: expected at least 2 points, found 1"),
        (line("polygon", json!([[20, 20], [30, 20]])), false, "handles[3].rest: expected at least 3 points, found 2"),
        (line("bar", json!([[40, 24], [60, 24]])), false, "handles “middle” and “tail” are"),
        (line("bar", json!([[-30, -20], [-10, -20]])), false, "handle “tail” at (-30, -20) lies outside the domain"),
        (line("bar", json!([[20, 0.5], [40, 0.5]])), true, "handle “tail” is on the fixed boundary"),
        (line("bar", json!([[20, 30], [40, 30], [25, 30]])), false, "handle “tail” runs along itself"),
    ] {
        let folder = SceneFolder::new("strip").edited(|project| {
            project["handles"].as_array_mut().unwrap().push(handle);
            project["fix_boundary"] = json!(fix_boundary);
        });
        assert_contains(&fail_to_warp(&folder), &["scene.c2warp.json: ", reason]);
    }
}

#[test]
fn invalid_scales_are_rejected() {
    let folder = SceneFolder::new("strip");
    for scale in ["0", "-1", "NaN", "inf", "1e-9", "1000", "1e300"] {
        assert_contains(&fail(folder.path(), &format!("{WARP} --scale {scale}")), &["--scale", "96×48", "16384"]);
    }
}

#[test]
fn invalid_points_name_their_line() {
    let folder = SceneFolder::new("strip");
    for (contents, reason) in [
        (&b""[..], "the first line must be x,y"),
        (b"1,2\n3,4\n", "the first line must be x,y"),
        (b"x,y\n1,2\nfar,away\n", "line 3: expected two finite numbers x,y, found \"far,away\""),
        (b"x,y\n1,NaN\n", "line 2: expected two finite numbers"),
        (b"x,y\n1\n", "line 2: expected two finite numbers"),
        (b"x,y\n1,2,3\n", "line 2: expected two finite numbers"),
        (b"x,y\n\xff,2\n", "the file is not UTF-8 text"),
    ] {
        folder.write("points.csv", contents);
        for subcommand in ["weights", "map", "distance --from 1,1"] {
            let line = fail(folder.path(), &format!("{subcommand} {PROJECT} --at points.csv -o out.csv"));
            assert_contains(&line, &["points.csv: ", reason]);
        }
    }
    assert_contains(
        &fail(folder.path(), &format!("map {PROJECT} --at no.csv -o out.csv")),
        &["no.csv: cannot read this file"],
    );
    assert!(!folder.file("out.csv").exists());
}

#[test]
fn distance_from_outside_the_domain_is_rejected() {
    let folder = SceneFolder::new("ring");
    folder.write("points.csv", "x,y\n108,64\n");
    for from in ["64,64", "-4,1e6"] {
        let line = fail(folder.path(), &format!("distance {PROJECT} --from {from} --at points.csv -o out.csv"));
        assert_contains(&line, &["outside the domain"]);
    }
}

#[test]
fn unwritable_outputs_are_rejected() {
    let folder = SceneFolder::new("untouched");
    for arguments in ["warp scene.c2warp.json -o no/such/folder/out.png", "bake scene.c2warp.json -o ."] {
        assert_contains(&fail(folder.path(), arguments), &["cannot write this file"]);
    }
    assert_eq!(folder.file_names(), [PROJECT, "strip.png"]);
}

#[test]
fn project_and_other_extensions_are_rejected_as_outputs() {
    let folder = SceneFolder::new("untouched");
    folder.write("points.csv", "x,y\n1,2\n");
    let before = fs::read(folder.file(PROJECT)).unwrap();
    for subcommand in ["warp", "weights --at points.csv", "map --at points.csv", "distance --from 1,1 --at points.csv"]
    {
        assert_contains(
            &fail(folder.path(), &format!("{subcommand} {PROJECT} -o ./{PROJECT}")),
            &[PROJECT, "this is the input"],
        );
    }
    assert!(fs::read(folder.file(PROJECT)).unwrap() == before);
    assert_contains(
        &fail(folder.path(), &format!("warp {PROJECT} -o out.jpg")),
        &["out.jpg", "means Jpeg", "use .png"],
    );
    let with_map = |path: &str, map: &str| fail(folder.path(), &format!("warp {PROJECT} -o {path} --stmap {map}"));
    assert_contains(&with_map("out.png", "map.png"), &["map.png", "means Png", "OpenExr", "use .exr"]);
    assert_contains(&with_map("out", "out"), &["out: this is also the output out"]);
    assert_contains(&with_map("-", "/dev/stdout"), &["/dev/stdout: this is also the output -"]);
    // Extensions of no known type are accepted.
    succeed(folder.path(), &format!("warp {PROJECT} -o out.0001"));
}

#[cfg(target_os = "linux")]
#[test]
fn full_disk_is_reported() {
    let folder = SceneFolder::new("untouched");
    assert_contains(&fail(folder.path(), &format!("warp {PROJECT} -o /dev/full")), &["cannot write this file"]);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let ended = command(folder.path(), &format!("inspect {PROJECT}")).stdout(full).output().unwrap();
    assert_eq!(ended.status.code(), Some(1));
    assert_contains(&String::from_utf8(ended.stderr).unwrap(), &["c2warp: cannot write to standard output"]);
}

#[test]
fn failed_run_keeps_the_previous_output() {
    let folder = SceneFolder::new("strip");
    succeed(folder.path(), WARP);
    let previous = folder.picture("out.png");
    folder.write(PROJECT, "{}");
    fail_to_warp(&folder);
    assert!(folder.picture("out.png").dimensions() == previous.dimensions() && folder.picture("out.png") == previous);
}

#[test]
fn invalid_command_line_exits_with_status_2() {
    let folder = SceneFolder::new("untouched");
    for arguments in
        ["", "bend", "warp", "warp scene.c2warp.json", "distance scene.c2warp.json --from here --at a -o b"]
    {
        let ended = command(folder.path(), arguments).output().unwrap();
        assert_eq!(ended.status.code(), Some(2), "{arguments}");
        assert!(!ended.stderr.is_empty());
    }
    assert!(command(folder.path(), "--help").output().unwrap().status.success());
}
