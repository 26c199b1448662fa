//! Tests of small files that claim or unfold to much more, and of machines with little memory.

use std::process::Command;

use png::text_metadata::ITXtChunk;

use crate::command::{command, fail, succeed};
use crate::scene_folder::{PROJECT, SceneFolder};

/// More bytes than a project may have.
const TOO_MANY: usize = 100_000_001;

/// A grey PNG of the strip's size with a colour profile and texts.
fn png(profile: Option<Vec<u8>>, texts: &[ITXtChunk]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut info = png::Info::with_size(96, 48);
    info.icc_profile = profile.map(Into::into);
    let mut writer = png::Encoder::with_info(&mut file, info).unwrap().write_header().unwrap();
    texts.iter().for_each(|text| writer.write_text_chunk(text).unwrap());
    writer.write_image_data(&[128; 96 * 48]).unwrap();
    writer.finish().unwrap();
    file
}

fn compressed(keyword: &str, text: String) -> ITXtChunk {
    let mut chunk = ITXtChunk::new(keyword, text);
    chunk.compressed = true;
    chunk.compress_text().unwrap();
    chunk
}

#[test]
fn a_compressed_project_is_unfolded_to_its_limit() {
    let folder = SceneFolder::new("strip");
    let project = std::fs::read_to_string(folder.file(PROJECT)).unwrap();
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    folder.write("posted.png", png(None, &[compressed("c2warp", project.clone())]));
    succeed(folder.path(), "warp posted.png -o other.png");
    assert!(std::fs::read(folder.file("other.png")).unwrap() == std::fs::read(folder.file("out.png")).unwrap());

    let bomb = png(None, &[compressed("c2warp", " ".repeat(TOO_MANY))]);
    assert!(bomb.len() < 1 << 20);
    folder.write("bomb.png", bomb);
    folder.write("large.c2warp.json", project + &" ".repeat(TOO_MANY));
    for name in ["bomb.png", "large.c2warp.json"] {
        for command in ["check", "inspect"] {
            let line = fail(folder.path(), &format!("{command} {name}"));
            assert!(line.starts_with(&format!("{name}: this project has more than 100 MB")), "{line}");
        }
    }
    // Texts of other keywords are not unfolded.
    folder.write("strip.png", png(None, &[compressed("XML:com.adobe.xmp", " ".repeat(TOO_MANY))]));
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
}

#[test]
fn a_large_colour_profile_is_left_out_by_name() {
    let folder = SceneFolder::new("strip");
    folder.write("strip.png", png(None, &[]));
    for subcommand in ["warp", "bake"] {
        succeed(folder.path(), &format!("{subcommand} scene.c2warp.json -o plain"));
        let plain = std::fs::read(folder.file("plain")).unwrap();
        folder.write("strip.png", png(Some([&[0; 16][..], b"RGB ", &vec![0; 100 << 20]].concat()), &[]));
        let run = command(folder.path(), &format!("{subcommand} scene.c2warp.json -o out")).output().unwrap();
        let told = String::from_utf8(run.stderr).unwrap();
        assert!(run.status.success(), "{told}");
        assert_eq!(told, "c2warp: strip.png: the colour profile has more than 8 MiB, and is left out\n");
        // A rig holds the picture without it, too.
        assert!(std::fs::read(folder.file("out")).unwrap() == plain, "{subcommand}");
        folder.write("strip.png", png(None, &[]));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn too_little_memory_is_one_line() {
    let folder = SceneFolder::new("strip");
    // The result has 283 MB.
    let run = command(folder.path(), "warp scene.c2warp.json --scale 124 -o out.png");
    let mut limited = Command::new("sh");
    limited.current_dir(folder.path()).env("RUST_BACKTRACE", "1");
    limited.args(["-c", "ulimit -v 300000; exec \"$0\" \"$@\""]).arg(run.get_program()).args(run.get_args());
    let ended = limited.output().unwrap();
    let told = String::from_utf8(ended.stderr).unwrap();
    assert_eq!(ended.status.code(), Some(1), "{told}");
    assert!(told.starts_with("c2warp: not enough memory for ") && told.lines().count() == 1, "{told}");
    assert_eq!(folder.file_names(), [PROJECT, "strip.png"]);
}

#[cfg(target_os = "linux")]
#[test]
fn metadata_longer_than_its_file_needs_no_memory() {
    let folder = SceneFolder::new("strip");
    let mut file = std::io::Cursor::new(Vec::new());
    image::DynamicImage::from(folder.picture("strip.png")).write_to(&mut file, image::ImageFormat::WebP).unwrap();
    let picture = &file.into_inner()[12..];
    let header = [&b"VP8X\x0a\0\0\0\x3c\0\0\0"[..], &[95, 0, 0, 47, 0, 0]].concat();
    let metadata = [&b"ICCP"[..], b"\xf0\xff\xff\xff", b"EXIF", b"\xf0\xff\xff\xff"];
    let chunks = [&header[..], picture, metadata[0], metadata[1]].concat();
    let webp = [&b"RIFF"[..], &(chunks.len() as u32 + 4).to_le_bytes(), b"WEBP", &chunks].concat();
    folder.write("strip.webp", webp);
    let run = command(folder.path(), "warp scene.c2warp.json --image strip.webp -o out.png");
    let mut limited = Command::new("sh");
    limited.current_dir(folder.path());
    limited.args(["-c", "ulimit -v 500000; exec \"$0\" \"$@\""]).arg(run.get_program()).args(run.get_args());
    let ended = limited.output().unwrap();
    assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
}
