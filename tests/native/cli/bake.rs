//! Tests of `c2warp bake`.

use std::fs;

use c2warp::project::Displacement;
use c2warp::rig::Rig;
use serde_json::json;

use crate::command::{fail, succeed};
use crate::scene_folder::{SceneFolder, all_by_24_px};

const BAKE: &str = "bake scene.c2warp.json -o out.c2rig";

fn waving() -> SceneFolder {
    SceneFolder::new("strip").edited(|project| {
        let keys = json!([{ "time": 0, "posed": [48, 24] }, { "time": 0.5, "posed": [50, 18] }]);
        project["clips"] = json!([{
            "name": "wave", "duration": 1, "loop": "repeat", "tracks": [{ "handle": "middle", "keys": keys }]
        }]);
    })
}

#[test]
fn rig_holds_clips_and_the_smaller_picture() {
    let folder = waving();
    succeed(folder.path(), BAKE);
    let rig = Rig::from_bytes(&fs::read(folder.file("out.c2rig")).unwrap()).unwrap();
    assert_eq!(rig.clips().iter().map(|clip| &clip.name[..]).collect::<Vec<_>>(), ["wave"]);
    let picture = rig.picture();
    assert_eq!((picture.width, picture.height), (96, 48));
    let given = fs::read(folder.file("strip.png")).unwrap();
    assert!(picture.file.len() <= given.len());
    let decoded = image::load_from_memory(&picture.file).unwrap().into_rgba8();
    assert!(decoded == folder.picture("strip.png"));
}

#[test]
fn only_the_rig_of_a_displaced_picture_has_version_2() {
    let version = |folder: &SceneFolder| {
        succeed(folder.path(), BAKE);
        let file = fs::read(folder.file("out.c2rig")).unwrap();
        let rig = Rig::from_bytes(&file).unwrap();
        let by = rig.displaced_vertices().iter().zip(rig.vertices()).map(|(a, b)| a.x - b.x).fold(0.0, f64::max);
        (file[8..12].to_vec(), by.round())
    };
    assert_eq!(version(&waving()), (vec![1, 0, 0, 0], 0.0));
    let displaced = waving().edited(|project| project["displacement"] = all_by_24_px());
    assert_eq!(version(&displaced), (vec![2, 0, 0, 0], 24.0));
    let without_handles = SceneFolder::new("untouched").edited(|project| project["displacement"] = all_by_24_px());
    assert_eq!(version(&without_handles), (vec![2, 0, 0, 0], 24.0));
    // Numbers of 0 displace nothing.
    let zeros = serde_json::to_value(Displacement::new(4, 4, vec![0; 32])).unwrap();
    assert_eq!(version(&waving().edited(|project| project["displacement"] = zeros)), (vec![1, 0, 0, 0], 0.0));
}

#[test]
fn the_same_project_gives_the_same_bytes() {
    let folder = waving();
    let print = || succeed(folder.path(), "bake scene.c2warp.json -o -");
    assert!(print() == print());
}

#[test]
fn refused_rigs_leave_the_file_as_it_is() {
    let folder = waving().edited(|project| project["clips"][0]["duration"] = 700.into());
    folder.write("out.c2rig", "before");
    let line = fail(folder.path(), BAKE);
    assert_eq!(line, "scene.c2warp.json: clip \"wave\" lasts 700 s: a clip of a rig can last up to 600 s");
    assert_eq!(fs::read(folder.file("out.c2rig")).unwrap(), b"before");
    let line = fail(folder.path(), "bake scene.c2warp.json -o out.png");
    assert_eq!(line, "out.png: the extension means Png, but the output is a rig: use .c2rig");
}
