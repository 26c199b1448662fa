//! Tests of `c2warp animate`. Films are decoded by other programs' code, and compared with single frames of `warp`.

use std::fs::File;
use std::io::BufReader;
use std::process::Command;

use image::codecs::png::PngDecoder;
use image::codecs::webp::WebPDecoder;
use image::{AnimationDecoder, Frame, RgbaImage, imageops};
use serde_json::{Value, json};

use crate::command::{command, fail, succeed};
use crate::scene_folder::SceneFolder;

/// Frames a second of the films.
const RATE: f64 = 10.0;

/// A ring with transparency, and a clip of 0.4 s that turns its first handle.
fn turning(looping: &str) -> SceneFolder {
    SceneFolder::new("ring").edited(|project| {
        let id = project["handles"][0]["id"].clone();
        let keys = json!([{ "time": 0, "ease": "linear", "rotation": 0 }, { "time": 0.2, "rotation": 40 }]);
        let tracks = json!([{ "handle": id, "keys": keys }]);
        project["clips"] = json!([{ "name": "turn", "duration": 0.4, "loop": looping, "tracks": tracks }]);
    })
}

/// The frame of `warp` at a time.
fn warped(folder: &SceneFolder, time: f64) -> RgbaImage {
    succeed(folder.path(), &format!("warp scene.c2warp.json --scale 0.5 --clip turn --at {time} -o still.png"));
    folder.picture("still.png")
}

fn animate(folder: &SceneFolder, output: &str) {
    succeed(folder.path(), &format!("animate scene.c2warp.json --scale 0.5 --fps {RATE} {output}"));
}

/// Pixels without colour where nothing is drawn.
fn without_hidden_colours(mut picture: RgbaImage) -> RgbaImage {
    picture.pixels_mut().filter(|pixel| pixel[3] == 0).for_each(|pixel| pixel.0 = [0; 4]);
    picture
}

/// The frames of a GIF as RGBA.
fn gif_frames(folder: &SceneFolder, name: &str) -> (Vec<gif::Frame<'static>>, gif::Repeat) {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(reader(folder, name)).unwrap();
    let frames = std::iter::from_fn(|| decoder.read_next_frame().unwrap().cloned()).collect();
    (frames, decoder.repeat())
}

/// The mean difference of the opaque pixels of a frame of a GIF from a picture.
fn gif_difference(found: &gif::Frame<'_>, wanted: &RgbaImage) -> f64 {
    assert_eq!((found.width.into(), found.height.into()), wanted.dimensions());
    let (mut error, mut opaque) = (0_u64, 0);
    for (found, wanted) in found.buffer.as_chunks::<4>().0.iter().zip(wanted.pixels()) {
        assert_eq!(found[3], if wanted[3] >= 128 { 255 } else { 0 });
        if found[3] == 255 {
            error += (0..3).map(|k| u64::from(found[k].abs_diff(wanted[k]))).sum::<u64>();
            opaque += 3;
        }
    }
    error as f64 / f64::from(opaque)
}

fn assert_frames(folder: &SceneFolder, frames: Vec<Frame>, times: &[f64]) {
    assert_eq!(frames.len(), times.len());
    for (frame, &time) in frames.into_iter().zip(times) {
        let delay = std::time::Duration::from(frame.delay()).as_secs_f64();
        assert!((delay - 1.0 / RATE).abs() < 1e-3, "{delay} s");
        let (found, wanted) =
            (without_hidden_colours(frame.into_buffer()), without_hidden_colours(warped(folder, time)));
        assert!(found == wanted, "at {time} s");
    }
}

fn reader(folder: &SceneFolder, name: &str) -> BufReader<File> {
    BufReader::new(File::open(folder.file(name)).unwrap())
}

#[test]
fn animated_png_has_the_frames_of_warp() {
    let folder = turning("repeat");
    animate(&folder, "-o film.png");
    let frames = PngDecoder::new(reader(&folder, "film.png")).unwrap().apng().unwrap().into_frames();
    assert_frames(&folder, frames.collect_frames().unwrap(), &[0.0, 0.1, 0.2, 0.3]);
    let info = png::Decoder::new(reader(&folder, "film.png")).read_info().unwrap().info().clone();
    assert_eq!(info.animation_control.unwrap().num_plays, 0, "it repeats");
}

#[test]
fn animated_webp_has_the_frames_of_warp() {
    let folder = turning("none");
    animate(&folder, "-o film.webp --clip turn");
    let decoder = WebPDecoder::new(reader(&folder, "film.webp")).unwrap();
    assert!(decoder.has_animation());
    assert_frames(&folder, decoder.into_frames().collect_frames().unwrap(), &[0.0, 0.1, 0.2, 0.3, 0.4]);
}

#[test]
fn a_range_is_a_part_of_the_clip() {
    for (looping, times) in
        [("repeat", vec![0.15, 0.25]), ("alternate", vec![0.15, 0.25, 0.35, 0.25]), ("none", vec![0.15, 0.25, 0.35])]
    {
        let folder = turning(looping);
        animate(&folder, "-o film.png --range 0.15..0.35");
        let frames = PngDecoder::new(reader(&folder, "film.png")).unwrap().apng().unwrap().into_frames();
        assert_frames(&folder, frames.collect_frames().unwrap(), &times);
    }
}

#[test]
fn gif_has_the_frames_of_warp_in_few_colours() {
    let folder = turning("alternate");
    animate(&folder, "-o film.gif");
    let (frames, repeat) = gif_frames(&folder, "film.gif");
    let times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.3, 0.2, 0.1];
    assert_eq!((frames.len(), repeat), (times.len(), gif::Repeat::Infinite));
    for (frame, &time) in frames.iter().zip(&times) {
        let difference = gif_difference(frame, &warped(&folder, time));
        assert!(difference < 4.2, "mean difference {difference} at {time} s");
    }
    let hundredths: u16 = frames.iter().map(|frame| frame.delay).sum();
    assert_eq!(f64::from(hundredths), times.len() as f64 / RATE * 100.0);
}

#[test]
fn gif_has_colours_that_the_first_frame_hides() {
    let folder = turning("none").edited(|project| {
        // The right half is beyond the picture at first.
        project["handles"] = json!([{ "id": "all", "kind": "point", "rest": [40, 40], "posed": [40, 40] }]);
        project["image"] = json!({ "src": "halves.png", "width": 80, "height": 80 });
        project["domain"] = json!({ "kind": "image" });
        let keys = json!([{ "time": 0, "ease": "linear", "posed": [80, 40] }, { "time": 0.1, "posed": [40, 40] }]);
        let tracks = json!([{ "handle": "all", "keys": keys }]);
        project["clips"] = json!([{ "name": "turn", "duration": 0.1, "loop": "none", "tracks": tracks }]);
    });
    let halves = RgbaImage::from_fn(80, 80, |x, y| {
        image::Rgba(if x < 40 { [200, 20, (2 * y) as u8, 255] } else { [(x / 2) as u8, (3 * y) as u8, 200, 255] })
    });
    halves.save(folder.file("halves.png")).unwrap();
    animate(&folder, "-o film.gif");
    for (frame, time) in gif_frames(&folder, "film.gif").0.iter().zip([0.0, 0.1]) {
        let difference = gif_difference(frame, &warped(&folder, time));
        assert!(difference < 1.0, "mean difference {difference} at {time} s");
    }
}

#[test]
fn matte_blends_with_the_soft_edges_of_a_gif() {
    let folder = turning("repeat");
    animate(&folder, "-o film.gif --matte #ff0000");
    let (frames, _) = gif_frames(&folder, "film.gif");
    let still = warped(&folder, 0.0);
    let soft =
        still.pixels().zip(frames[0].buffer.as_chunks::<4>().0).filter(|(pixel, _)| (60..120).contains(&pixel[3]));
    let redder = soft.clone().filter(|(pixel, found)| found[3] == 255 && found[0] >= pixel[0]).count();
    assert!(redder > 10 && redder * 10 > soft.count() * 9, "{redder}");
}

#[test]
fn frames_are_numbered_files() {
    let folder = turning("repeat");
    animate(&folder, "-o frame-%03d.png");
    for (frame, time) in [0.0, 0.1, 0.2, 0.3].into_iter().enumerate() {
        assert!(folder.picture(&format!("frame-00{frame}.png")) == warped(&folder, time));
    }
    assert!(!folder.file_names().contains(&"frame-004.png".to_owned()));
}

#[test]
fn grown_frames_have_one_size_that_holds_all() {
    let folder = turning("none").edited(|project| {
        // The ring leaves the picture at both sides, one after the other.
        let key = |time: f64, x: f64| json!({ "time": time, "ease": "linear", "posed": [x, 64] });
        project["handles"] = json!([{ "id": "all", "kind": "point", "rest": [30, 64], "posed": [30, 64] }]);
        let tracks = json!([{ "handle": "all", "keys": [key(0.0, 0.0), key(0.2, 70.0)] }]);
        project["clips"] = json!([{ "name": "turn", "duration": 0.2, "loop": "none", "tracks": tracks }]);
    });
    let arguments = "animate scene.c2warp.json --scale 0.5 --fps 10 --grow";
    let origin = |line: Vec<u8>| -> [i64; 2] {
        let line = String::from_utf8(line).unwrap();
        let (left, top) = line.trim().split_once(',').unwrap();
        [left, top].map(|number| number.parse().unwrap())
    };
    let [left, top] = origin(succeed(folder.path(), &format!("{arguments} -o frame-%d.png")));
    let (mut most_left, mut most_right) = (0, 0);
    for (frame, time) in [0.0, 0.1, 0.2].into_iter().enumerate() {
        let still = format!("warp scene.c2warp.json --scale 0.5 --clip turn --at {time} --grow -o still.png");
        let [x, y] = origin(succeed(folder.path(), &still));
        let still = folder.picture("still.png");
        let found = folder.picture(&format!("frame-{frame}.png"));
        let mut wanted = RgbaImage::new(found.width(), found.height());
        imageops::replace(&mut wanted, &still, left - x, top - y);
        assert!(found == wanted, "at {time} s");
        most_left = most_left.max(x);
        most_right = most_right.max(i64::from(still.width()) - x);
    }
    let size = folder.picture("frame-0.png").dimensions();
    assert!(left > 10 && most_right > 64 + 10, "it leaves both sides: {left}, {most_right}");
    assert_eq!((left, top, size), (most_left, 0, ((most_left + most_right) as u32, 64)));
    for name in ["film.gif", "film.webp"] {
        succeed(folder.path(), &format!("{arguments} -o {name}"));
    }
    let frames = WebPDecoder::new(reader(&folder, "film.webp")).unwrap().into_frames().collect_frames().unwrap();
    let last = without_hidden_colours(frames.into_iter().next_back().unwrap().into_buffer());
    assert!(last == without_hidden_colours(folder.picture("frame-2.png")));
    assert_eq!(u32::from(gif_frames(&folder, "film.gif").0[0].width), size.0);
}

#[test]
fn sheet_has_all_frames_and_their_positions() {
    let folder = turning("none");
    animate(&folder, "--sheet sheet.png");
    let sheet = folder.picture("sheet.png");
    let table: Value = serde_json::from_slice(&std::fs::read(folder.file("sheet.json")).unwrap()).unwrap();
    assert_eq!(table["meta"]["image"], "sheet.png");
    assert_eq!(table["meta"]["size"], json!({ "w": sheet.width(), "h": sheet.height() }));
    let frames = table["frames"].as_object().unwrap();
    assert_eq!(frames.len(), 5);
    for (at, time) in [0.0, 0.1, 0.2, 0.3, 0.4].into_iter().enumerate() {
        let frame = &frames[&format!("turn-{at}.png")];
        assert_eq!(frame["duration"], 100);
        let [x, y, w, h] = ["x", "y", "w", "h"].map(|key| frame["frame"][key].as_u64().unwrap() as u32);
        assert!(imageops::crop_imm(&sheet, x, y, w, h).to_image() == warped(&folder, time));
    }
}

#[test]
fn films_do_not_depend_on_the_run() {
    let folder = turning("repeat");
    for kind in ["png", "gif", "webp"] {
        animate(&folder, &format!("-o a.{kind}"));
        animate(&folder, &format!("-o b.{kind}"));
        let [a, b] = ["a", "b"].map(|name| std::fs::read(folder.file(&format!("{name}.{kind}"))).unwrap());
        assert!(a == b, "{kind}");
    }
}

/// The output of a program that may be missing.
fn output_of(program: &str, arguments: &[&str], folder: &SceneFolder) -> Option<Vec<u8>> {
    let run = match Command::new(program).args(arguments).current_dir(folder.path()).output() {
        Ok(run) => run,
        Err(reason) => {
            eprintln!("skipped: {program} is not installed: {reason}");
            return None;
        }
    };
    assert!(run.status.success(), "{program}: {}", String::from_utf8_lossy(&run.stderr));
    Some(run.stdout)
}

/// FFmpeg is written by others and shares no code with the encoders. It does not read animated WebP.
#[test]
fn ffmpeg_decodes_the_frames_of_warp() {
    let folder = turning("repeat");
    let times = [0.0, 0.1, 0.2, 0.3];
    let wanted = times.map(|time| warped(&folder, time));
    let (width, height) = wanted[0].dimensions();
    for name in ["film.gif", "film.png"] {
        animate(&folder, &format!("-o {name}"));
        let probe =
            ["-v", "error", "-of", "csv=p=0", "-show_entries", "packet=duration_time:stream=width,height", name];
        let Some(lines) = output_of("ffprobe", &probe, &folder) else { return };
        let lines = String::from_utf8(lines).unwrap();
        let durations: Vec<f64> = lines.lines().filter_map(|line| line.trim_end_matches(',').parse().ok()).collect();
        assert_eq!(durations, [0.1; 4], "{name}");
        assert!(lines.contains(&format!("{width},{height}")), "{name}: {lines}");

        let decode = ["-v", "error", "-i", name, "-vsync", "passthrough", "-f", "rawvideo", "-pix_fmt", "rgba", "-"];
        let Some(decoded) = output_of("ffmpeg", &decode, &folder) else { return };
        let frames = decoded.chunks_exact(4 * width as usize * height as usize);
        assert_eq!(frames.len(), times.len(), "{name}");
        for (rgba, wanted) in frames.zip(&wanted) {
            let found = RgbaImage::from_raw(width, height, rgba.to_vec()).unwrap();
            if name == "film.gif" {
                let frame = gif::Frame {
                    width: width as u16,
                    height: height as u16,
                    buffer: rgba.into(),
                    ..gif::Frame::default()
                };
                let difference = gif_difference(&frame, wanted);
                assert!(difference < 4.2, "mean difference {difference}");
            } else {
                assert!(without_hidden_colours(found) == without_hidden_colours(wanted.clone()), "{name}");
            }
        }
    }
}

/// The device is full from the beginning, and a frame is the second output.
#[cfg(target_os = "linux")]
#[test]
fn outputs_that_fill_up_are_named_and_leave_no_half_file() {
    let folder = turning("repeat");
    for name in ["full.gif", "full.png", "full.webp", "frame-1.png"] {
        std::os::unix::fs::symlink("/dev/full", folder.file(name)).unwrap();
    }
    let names = folder.file_names();
    let arguments = "animate scene.c2warp.json --scale 0.5 --fps 10";
    for output in ["-o full.gif", "-o full.png", "-o full.webp", "--sheet full.png"] {
        let line = fail(folder.path(), &format!("{arguments} {output}"));
        let name = output.rsplit(' ').next().unwrap();
        assert!(line.contains(&format!("{name}: cannot write this file: No space left")), "{line}");
    }
    assert_eq!(folder.file_names(), names);
    let line = fail(folder.path(), &format!("{arguments} -o frame-%d.png"));
    assert!(line.contains("frame-1.png: cannot write this file: No space left"), "{line}");
    assert!(folder.picture("frame-0.png") == warped(&folder, 0.0), "frames before it are whole");
}

#[test]
fn damaged_clips_are_named_by_the_path_of_the_key() {
    type Change = fn(&mut Value);
    let changes: [(Change, &str); 6] = [
        (
            |clip| clip["tracks"][0]["keys"][1]["time"] = 1.5.into(),
            "clips[0].tracks[0].keys[1].time: expected seconds from",
        ),
        (
            |clip| clip["tracks"][0]["keys"][1]["time"] = 0.into(),
            "clips[0].tracks[0].keys[1].time: expected a time after 0",
        ),
        (|clip| clip["tracks"][0]["handle"] = "tail".into(), r#"clips[0].tracks[0].handle: there is no handle "tail""#),
        (|clip| clip["duration"] = 0.into(), "clips[0].duration: expected seconds above 0"),
        (|clip| clip["duration"] = 3601.into(), "clips[0].duration: expected seconds above 0 and up to 3600"),
        (|clip| clip["loop"] = "once".into(), "clips[0].loop: "),
    ];
    for (change, reason) in changes {
        let folder = turning("repeat").edited(|project| change(&mut project["clips"][0]));
        let names = folder.file_names();
        let line = fail(folder.path(), "animate scene.c2warp.json -o film.gif");
        assert!(line.contains(reason), "{line}");
        assert_eq!(folder.file_names(), names);
    }
}

#[test]
fn refused_films_name_the_reason_and_leave_no_file() {
    let folder = turning("repeat");
    let names = folder.file_names();
    let refused = |arguments: &str| fail(folder.path(), &format!("animate scene.c2warp.json {arguments}"));
    for (arguments, reason) in [
        ("-o film.gif --clip wave", r#"there is no clip "wave": the clips are ["turn"]"#),
        ("-o film.gif --fps 0", "--fps: expected a frame rate above 0 and up to 240, found 0"),
        ("-o film.png --fps 241", "--fps: expected a frame rate above 0 and up to 240, found 241"),
        ("-o film.gif --fps 60", "--fps: viewers show a GIF at no more than 50 frames per second"),
        ("-o film.png --range 0.1..0.5", "--range: clip “turn”: expected a range within 0 to 0.4 seconds that"),
        ("-o film.png --range 0.3..0.1", "that ends after it begins, found 0.3..0.1"),
        ("-o film.png --range -1..0.1", "found -1..0.1"),
        ("-o film.mp4", "film.mp4: the name of a film must end with .gif, .png or .webp"),
        ("-o frame-%04d.gif", "frame-%04d.gif"),
        ("-o film.png --scale 0", "--scale"),
        ("-o nowhere/film.png", "nowhere/film.png: cannot write this file"),
        ("-o nowhere/frame-%d.png", "nowhere/frame-0.png: cannot write this file"),
        ("--sheet sheet.jpg", "sheet.jpg: a sprite sheet must be a PNG"),
        ("-o film.png --sheet film.png", "film.png: this is also the output film.png"),
        ("-o film.png --scale 120 --grow", "--scale"),
        ("--sheet sheet.png --scale 40", "need a sheet of"),
    ] {
        let line = refused(arguments);
        assert!(line.contains(reason), "{arguments}: {line}");
    }
    assert_eq!(folder.file_names(), names);
    for option in ["--matte red", "--range 0.1", "--range 0.1..x", "--range ..0.1"] {
        let run = command(folder.path(), &format!("animate scene.c2warp.json -o film.gif {option}")).output().unwrap();
        assert_eq!(run.status.code(), Some(2), "{option}");
    }
}

#[test]
fn the_clip_must_be_clear_and_of_a_fair_length() {
    let folder = turning("repeat").edited(|project| {
        let mut other = project["clips"][0].clone();
        other["name"] = "hour".into();
        other["duration"] = 3600.into();
        project["clips"].as_array_mut().unwrap().push(other);
    });
    let line = fail(folder.path(), "animate scene.c2warp.json -o film.gif");
    assert!(line.contains(r#"name the clip to draw with --clip: the clips are ["turn", "hour"]"#), "{line}");
    let line = fail(folder.path(), "animate scene.c2warp.json -o film.png --clip hour --fps 240");
    assert!(line.contains("--fps: a film of clip “hour” would have 864000 frames, but at most 36000"), "{line}");
    let folder = folder.edited(|project| project["clips"] = json!([]));
    let line = fail(folder.path(), "animate scene.c2warp.json -o film.gif");
    assert!(line.ends_with("name the clip to draw with --clip: the project has no clips"), "{line}");
}
