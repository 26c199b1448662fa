//! Tests of one project with other pictures: of other sizes and outlines, and many of them in one call.

use std::fs;

use image::imageops::{self, FilterType};
use image::{Rgba, RgbaImage};
use serde_json::json;

use crate::command::{command, fail, succeed};
use crate::scene_folder::SceneFolder;

/// Mean difference of the alpha and colours of two pictures of the same size, from 0 to 255.
fn difference(one: &RgbaImage, other: &RgbaImage) -> f64 {
    assert_eq!(one.dimensions(), other.dimensions());
    let premultiplied =
        |&Rgba([r, g, b, a]): &Rgba<u8>| [r, g, b, 255].map(|level| f64::from(level) * f64::from(a) / 255.0);
    let apart = |(one, other): (&Rgba<u8>, &Rgba<u8>)| -> f64 {
        premultiplied(one).iter().zip(premultiplied(other)).map(|(a, b)| (a - b).abs()).sum()
    };
    one.pixels().zip(other.pixels()).map(apart).sum::<f64>() / f64::from(one.width() * one.height() * 4)
}

#[test]
fn picture_of_another_size_gets_the_same_warp() {
    let folder = SceneFolder::new("islands");
    let picture = folder.picture("islands.png");
    let (width, height) = (picture.width() * 2, picture.height() * 2);
    let large = imageops::resize(&picture, width, height, FilterType::Nearest);
    large.save(folder.file("large.png")).unwrap();
    // The same picture with a margin around it, at another place.
    let mut placed = RgbaImage::new(width + 90, height + 40);
    imageops::replace(&mut placed, &large, 70, 10);
    placed.save(folder.file("placed.png")).unwrap();

    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    let expected = imageops::resize(&folder.picture("out.png"), width, height, FilterType::Nearest);
    succeed(folder.path(), "warp scene.c2warp.json --image large.png -o large-out.png");
    assert!(difference(&folder.picture("large-out.png"), &expected) < 3.0);
    succeed(folder.path(), "warp scene.c2warp.json --image placed.png --fit alpha -o placed-out.png");
    let placed = imageops::crop_imm(&folder.picture("placed-out.png"), 70, 10, width, height).to_image();
    assert!(difference(&placed, &expected) < 3.0);

    // Points of other commands are those of the new picture, too.
    folder.write("points.csv", "x,y\n");
    succeed(folder.path(), "map scene.c2warp.json --image large.png --at points.csv -o map.csv");
    let line = fail(folder.path(), "inspect scene.c2warp.json --image placed.png");
    for part in ["placed.png: this picture of", "other proportions", "--fit box", "--fit alpha"] {
        assert!(line.contains(part), "{line}");
    }
    let opaque = RgbaImage::from_pixel(width, height, Rgba([9, 9, 9, 255]));
    opaque.save(folder.file("opaque.png")).unwrap();
    let line = fail(folder.path(), "inspect scene.c2warp.json --image opaque.png --fit alpha");
    assert!(line.starts_with("opaque.png: the picture has no transparent part"), "{line}");
    fs::remove_file(folder.file("islands.png")).unwrap();
    let line = fail(folder.path(), "inspect scene.c2warp.json --image large.png --fit alpha");
    assert!(line.starts_with("islands.png: cannot read this file"), "{line}");
}

#[test]
fn handles_outside_the_new_outline_move_inside_or_are_named() {
    let folder = SceneFolder::new("strip").edited(|project| {
        project["domain"] = json!({ "kind": "alpha" });
        project["handles"] = json!([{ "id": "hat", "kind": "point", "rest": [48, 1] }]);
    });
    let mut picture = folder.picture("strip.png");
    let clear = |picture: &mut RgbaImage, rows: u32| {
        picture.enumerate_pixels_mut().filter(|&(_, y, _)| y < rows).for_each(|(_, _, pixel)| pixel[3] = 0);
    };
    clear(&mut picture, 3);
    picture.save(folder.file("lower.png")).unwrap();
    let run = command(folder.path(), "warp scene.c2warp.json --image lower.png --fit box -o out.png").output().unwrap();
    let told = String::from_utf8(run.stderr).unwrap();
    assert!(run.status.success(), "{told}");
    assert!(told.starts_with("c2warp: lower.png: moved into the outline, by up to "), "{told}");
    assert!(told.ends_with(" px: “hat”\n"), "{told}");
    clear(&mut picture, 20);
    picture.save(folder.file("lower.png")).unwrap();
    let line = fail(folder.path(), "warp scene.c2warp.json --image lower.png --fit box -o out.png");
    assert!(line.starts_with("lower.png: handle “hat” would lie 19 px outside the outline"), "{line}");
}

#[test]
fn folder_with_bad_files_has_a_result_for_each_good_one() {
    let folder = SceneFolder::new("strip");
    let strip = folder.picture("strip.png");
    fs::create_dir(folder.file("in")).unwrap();
    for number in 0..100 {
        let mut picture = strip.clone();
        picture.pixels_mut().for_each(|pixel| pixel[0] = number);
        picture.save(folder.file(&format!("in/{number:02}.png"))).unwrap();
    }
    folder.write("in/.hidden", "");
    folder.write("in/07.png", "once upon a time");
    let bytes = fs::read(folder.file("in/20.png")).unwrap();
    folder.write("in/20.png", &bytes[..bytes.len() / 2]);
    RgbaImage::from_pixel(31, 67, Rgba([1, 2, 3, 255])).save(folder.file("in/99.png")).unwrap();

    let warp =
        |jobs: &str| command(folder.path(), &format!("warp scene.c2warp.json --image in {jobs}")).output().unwrap();
    let run = warp("-o out/deep -j 4");
    assert_eq!(run.status.code(), Some(1));
    assert!(run.stdout.is_empty());
    let told = String::from_utf8(run.stderr).unwrap();
    let mut lines: Vec<&str> = told.lines().collect();
    lines.sort_unstable();
    assert_eq!(lines.len(), 3, "{told}");
    for (line, part) in
        lines.iter().zip(["in/07.png: this is not a", "in/20.png: the picture is damaged", "in/99.png: "])
    {
        assert!(line.starts_with(&format!("c2warp: {part}")), "{line}");
    }
    let entries = fs::read_dir(folder.file("out/deep")).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    let expected: Vec<_> = (0..99).filter(|n| ![7, 20].contains(n)).map(|n| format!("{n:02}.png")).collect();
    assert_eq!(names, expected);
    // The results are those of single calls, whatever the number of threads.
    succeed(folder.path(), "warp scene.c2warp.json --image in/50.png -o single.png");
    assert!(fs::read(folder.file("single.png")).unwrap() == fs::read(folder.file("out/deep/50.png")).unwrap());
    assert_eq!(warp("-o one -j 1").status.code(), Some(1));
    for name in [&names[0], &names[96]] {
        let read = |out: &str| fs::read(folder.file(&format!("{out}/{name}"))).unwrap();
        assert!(read("one") == read("out/deep"));
    }
}

#[test]
fn several_projects_have_results_with_their_names() {
    let folder = SceneFolder::new("strip");
    let project = fs::read_to_string(folder.file("scene.c2warp.json")).unwrap();
    let frame = |number: i32| {
        let mut project: serde_json::Value = serde_json::from_str(&project).unwrap();
        project["handles"][1]["posed"][0] = (48 + number).into();
        folder.write(&format!("{number}.c2warp.json"), project.to_string());
    };
    (1..=4).for_each(frame);
    folder.write("5.c2warp.json", "{}");
    let all = "warp 1.c2warp.json 2.c2warp.json 3.c2warp.json 4.c2warp.json 5.c2warp.json";
    let run = command(folder.path(), &format!("{all} --grow --stmap maps -o out -j 2")).output().unwrap();
    let [printed, told] = [run.stdout, run.stderr].map(|text| String::from_utf8(text).unwrap());
    assert_eq!(run.status.code(), Some(1));
    assert!(told.starts_with("c2warp: 5.c2warp.json: ") && told.lines().count() == 1, "{told}");
    let names: Vec<_> = printed.lines().map(|line| line.split_once(' ').unwrap().1).collect();
    assert_eq!(names, ["1.png", "2.png", "3.png", "4.png"]);
    for name in ["1", "4"] {
        let single = succeed(folder.path(), &format!("warp {name}.c2warp.json --grow --stmap one.exr -o one.png"));
        let origin = String::from_utf8(single).unwrap();
        assert!(printed.contains(&format!("{} {name}.png", origin.trim())), "{printed}");
        let read = |file: &str| fs::read(folder.file(file)).unwrap();
        assert!(read("one.png") == read(&format!("out/{name}.png")));
        assert!(read("one.exr") == read(&format!("maps/{name}.exr")));
    }
    // Inputs are never written over, and results not over one another.
    fs::create_dir(folder.file("solo")).unwrap();
    fs::copy(folder.file("strip.png"), folder.file("solo/strip.png")).unwrap();
    let line = fail(folder.path(), "warp 1.c2warp.json --image solo -o solo");
    assert_eq!(line, "solo/strip.png: this is the input solo/strip.png: choose another output");
    let line = fail(folder.path(), "warp 1.c2warp.json 2.c2warp.json --image strip.png --image strip.png -o out");
    assert!(line.starts_with("pass one project"), "{line}");
    fs::create_dir(folder.file("empty")).unwrap();
    assert_eq!(fail(folder.path(), "warp 1.c2warp.json --image empty -o out"), "empty: this folder has no files");
}
