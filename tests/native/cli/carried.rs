//! Tests of projects that a PNG carries, and of pictures that a project holds.

use std::fs;

use png::{BitDepth, ColorType, Encoder};

use crate::command::{fail, succeed};
use crate::scene_folder::{PROJECT, SceneFolder};

const WARP: &str = "warp scene.c2warp.json -o out.png";

/// Returns a PNG with texts before its pixels, and one with the same texts behind them.
fn with_texts(texts: &[(&str, &str)]) -> [Vec<u8>; 2] {
    [true, false].map(|is_before| {
        let mut file = Vec::new();
        let mut encoder = Encoder::new(&mut file, 1, 1);
        encoder.set_color(ColorType::Grayscale);
        encoder.set_depth(BitDepth::Eight);
        let mut writer = encoder.write_header().unwrap();
        let chunks = || texts.iter().map(|&(keyword, text)| png::text_metadata::ITXtChunk::new(keyword, text));
        if is_before {
            chunks().for_each(|chunk| writer.write_text_chunk(&chunk).unwrap());
        }
        writer.write_image_data(&[0]).unwrap();
        if !is_before {
            chunks().for_each(|chunk| writer.write_text_chunk(&chunk).unwrap());
        }
        drop(writer);
        file
    })
}

/// Writes each byte as `%XX`.
fn data_url(file: &[u8]) -> String {
    let content: String = file.iter().map(|byte| format!("%{byte:02x}")).collect();
    format!("data:image/png;name=strip.png,{content}")
}

#[test]
fn a_png_is_a_project_by_its_text_chunk() {
    let folder = SceneFolder::new("strip");
    succeed(folder.path(), WARP);
    let project = fs::read_to_string(folder.file(PROJECT)).unwrap();
    for file in with_texts(&[("Comment", "not this one"), ("c2warp", &project)]) {
        folder.write("posted.png", file);
        succeed(folder.path(), "warp posted.png -o other.png");
        assert_eq!(fs::read(folder.file("other.png")).unwrap(), fs::read(folder.file("out.png")).unwrap());
    }
    let line = fail(folder.path(), "warp posted.png -o posted.png");
    assert!(line.contains("posted.png: this is the input posted.png"), "{line}");
}

#[test]
fn a_png_without_a_project_is_rejected_by_name() {
    let folder = SceneFolder::new("strip");
    let line = fail(folder.path(), "warp strip.png -o out.png");
    assert!(line.contains("strip.png: this PNG contains no project"), "{line}");
    let [broken, _] = with_texts(&[("c2warp", "{")]);
    folder.write("broken.png", broken);
    let line = fail(folder.path(), "warp broken.png -o out.png");
    assert!(line.contains("broken.png: ") && line.contains("EOF"), "{line}");
}

#[test]
fn a_project_may_hold_its_picture() {
    let folder = SceneFolder::new("strip");
    succeed(folder.path(), WARP);
    let held = data_url(&fs::read(folder.file("strip.png")).unwrap());
    let folder = folder.edited(|project| project["image"]["src"] = held.into());
    fs::remove_file(folder.file("strip.png")).unwrap();
    succeed(folder.path(), "warp scene.c2warp.json -o other.png");
    assert_eq!(fs::read(folder.file("other.png")).unwrap(), fs::read(folder.file("out.png")).unwrap());
}

#[test]
fn a_held_picture_is_rejected_by_its_key() {
    let mut folder = SceneFolder::new("strip");
    for (src, reason) in [
        ("data:image/png;base64", "the data: URL is damaged"),
        ("data:image/png;base64,&&&", "the data: URL is damaged"),
        ("data:,", "this is not a picture: the file is empty"),
        ("DATA:text/plain,once%20upon%20a%20time", "this is not a PNG, JPEG, WebP or SVG picture"),
    ] {
        folder = folder.edited(|project| project["image"]["src"] = src.into());
        let line = fail(folder.path(), WARP);
        assert!(line.contains("scene.c2warp.json: image.src: ") && line.contains(reason), "{src}: {line}");
    }
}
