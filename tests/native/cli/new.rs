//! Tests of `c2warp new`: projects with given and suggested handles.

use std::fs;

use c2warp::project::{DomainSpec, Project, Rotation, Shape};
use image::{Rgba, RgbaImage};

use crate::command::{command, fail, succeed, succeed_with_closed_pipe};
use crate::scene_folder::{PROJECT, SceneFolder};

fn project(folder: &SceneFolder, name: &str) -> Project {
    Project::from_json(&fs::read_to_string(folder.file(name)).unwrap()).unwrap()
}

#[test]
fn new_project_has_the_given_handles_and_the_settings_of_the_editor() {
    let folder = SceneFolder::new("gingerbread");
    assert!(succeed(folder.path(), "new gingerbread.png --handles 90,42 24,96.5 156,96").is_empty());
    let made = project(&folder, "gingerbread.c2warp.json");
    let points: Vec<&Shape> = made.handles.iter().map(|handle| &handle.shape).collect();
    let point = |x: f64, y: f64| Shape::Point { rest: [x, y].into(), posed: [x, y].into() };
    assert_eq!(points, [&point(90.0, 42.0), &point(24.0, 96.5), &point(156.0, 96.0)]);
    assert!(made.handles.iter().all(|handle| handle.rotation == Rotation::Auto));
    assert_eq!(made.image.src, "gingerbread.png");
    assert_eq!(made.domain, Some(DomainSpec::Alpha { threshold: 0.5 }));
    assert_eq!(made, made.clone().with_editor_settings());
    // It can be warped unchanged, and the picture is found from another folder.
    fs::create_dir(folder.file("rigs")).unwrap();
    succeed(folder.path(), "new gingerbread.png --handles 90,120 -o rigs/one.c2warp.json");
    assert_eq!(project(&folder, "rigs/one.c2warp.json").image.src, "../gingerbread.png");
    succeed(folder.path(), "warp rigs/one.c2warp.json -o out.png");
    let [drawn, picture] = ["out.png", "gingerbread.png"].map(|name| folder.picture(name));
    assert_eq!(drawn.dimensions(), picture.dimensions());
    assert!(drawn.iter().zip(picture.iter()).all(|(drawn, level)| drawn.abs_diff(*level) <= 1));
}

#[test]
fn suggested_handles_can_be_solved() {
    let folder = SceneFolder::new("gingerbread");
    succeed(folder.path(), "new gingerbread.png --suggest");
    let suggested = project(&folder, "gingerbread.c2warp.json").handles;
    assert!((5..=14).contains(&suggested.len()), "{suggested:?}");
    assert!(suggested.iter().any(|handle| handle.id == "body"));
    succeed(folder.path(), "check gingerbread.c2warp.json");
    let printed = succeed(folder.path(), "new gingerbread.png --suggest 3 -o -");
    assert_eq!(Project::from_json(&String::from_utf8(printed).unwrap()).unwrap().handles.len(), 3);
    succeed_with_closed_pipe(folder.path(), "new gingerbread.png --suggest 3 -o -");
    // A photograph has no outline, and the command reports it.
    RgbaImage::from_pixel(90, 60, Rgba([9, 99, 200, 255])).save(folder.file("photo.png")).unwrap();
    let ended = command(folder.path(), "new photo.png --suggest").output().unwrap();
    assert!(ended.status.success());
    assert_eq!(
        String::from_utf8(ended.stderr).unwrap(),
        "c2warp: photo.png: the picture has no outline to follow, so the handles are in even rows\n"
    );
    let spread = project(&folder, "photo.c2warp.json");
    assert_eq!((spread.handles.len(), spread.domain), (9, Some(DomainSpec::Image)));
    // Its boundary is held, and that of the gingerbread is not.
    assert!(spread.fix_boundary && !project(&folder, "gingerbread.c2warp.json").fix_boundary);
}

#[test]
fn new_projects_replace_nothing_and_refuse_bad_handles() {
    let folder = SceneFolder::new("ring");
    folder.write("empty.png", "");
    RgbaImage::from_pixel(40, 30, Rgba([9, 9, 9, 3])).save(folder.file("faint.png")).unwrap();
    let before = fs::read(folder.file(PROJECT)).unwrap();
    for (arguments, reason) in [
        ("new ring.png --handles 20,64 -o scene.c2warp.json", "scene.c2warp.json: this file already exists: choose"),
        ("new ring.png --suggest --force -o ring.png", "ring.png: this is the input ring.png: choose another output"),
        ("new ring.png --handles 64,64", "ring.png: handle “handle-1” at (64, 64) lies outside the domain"),
        ("new ring.png --handles 3,1e9", "ring.png: handle “handle-1” at (3, 1000000000) lies outside the domain"),
        ("new ring.png --handles 20,64 20,64", "handles “handle-1” and “handle-2” are less than 0.01 px apart"),
        ("new empty.png --suggest", "empty.png: this is not a picture: the file is empty"),
        ("new faint.png --suggest", "faint.png: no pixel of the picture is opaque at the threshold 0.5"),
        ("new no.png --suggest", "no.png: cannot read this file"),
        ("new ring.png --suggest -o no/folder/ring.c2warp.json", "cannot write this file"),
    ] {
        let line = fail(folder.path(), arguments);
        assert!(line.contains(reason), "{arguments}: {line}");
    }
    assert_eq!(folder.file_names(), ["empty.png", "faint.png", "ring.png", PROJECT]);
    assert!(fs::read(folder.file(PROJECT)).unwrap() == before);
    succeed(folder.path(), "new ring.png --handles 20,64 --force -o scene.c2warp.json");
    assert_eq!(project(&folder, PROJECT).handles.len(), 1);
    for arguments in
        ["new ring.png", "new ring.png --suggest 0", "new ring.png --suggest 101", "new ring.png --handles x"]
    {
        assert_eq!(command(folder.path(), arguments).output().unwrap().status.code(), Some(2), "{arguments}");
    }
}
