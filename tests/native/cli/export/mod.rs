//! Tests of `c2warp export`: files are read according to the formats' documentation, and vertices are compared with the
//! solver.

mod dragonbones;
mod exact;
mod gltf;
mod godot;
mod reading;
mod spine;

use std::fs;

use c2warp::project::Looping;
use glam::DVec2;
use serde_json::{Value, json};

use self::exact::Exact;
use self::reading::{Listing, Reading};
use crate::command::{fail, succeed};
use crate::scene_folder::SceneFolder;

/// Rounding of numbers in text.
const ROUNDING_PX: f64 = 0.01;
/// The stated error of keys.
const KEYS_PX: f64 = 0.1;
const TIMES: u32 = 12;

fn clip(handle: &str, name: &str, looping: &str, keys: &Value) -> Value {
    json!({ "name": name, "duration": 0.7, "loop": looping, "tracks": [{ "handle": handle, "keys": keys }] })
}

/// Points in the linear blend, with a turn of more than half a circle.
fn strip() -> SceneFolder {
    SceneFolder::new("strip").edited(|project| {
        let keys = json!([
            { "time": 0, "posed": [48, 24], "rotation": 0 }, { "time": 0.5, "posed": [50, 18], "rotation": 250 }
        ]);
        project["clips"] = json!([
            clip("middle", "turn", "none", &keys),
            clip(
                "middle",
                "to and/fro",
                "alternate",
                &json!([{ "time": 0, "posed": [48, 24] }, { "time": 0.7, "posed": [44, 30] }])
            ),
        ]);
    })
}

/// A cut-out figure in the rigid mode and blend.
fn figure() -> SceneFolder {
    SceneFolder::new("gingerbread").edited(|project| {
        project["pose"] = json!({ "mode": "rigid", "blend": "rigid", "density": 40 });
        for handle in project["handles"].as_array_mut().unwrap() {
            handle["rotation"] = "auto".into();
        }
        let rest = project["handles"][1]["rest"].clone();
        let moved = json!([rest[0].as_f64().unwrap() + 5.0, rest[1].as_f64().unwrap() - 25.0]);
        let keys = json!([{ "time": 0, "posed": rest }, { "time": 0.35, "posed": moved }]);
        project["clips"] = json!([clip("left-hand", "wave", "repeat", &keys)]);
    })
}

/// Bars, which stretch only along their lines.
fn bars() -> SceneFolder {
    SceneFolder::new("tower")
}

/// A picture that a brush has moved before its handles do.
fn brushed() -> SceneFolder {
    SceneFolder::new("brushed").edited(|project| {
        let keys = json!([{ "time": 0, "posed": [24, 96] }, { "time": 0.35, "posed": [30, 76] }]);
        project["clips"] = json!([clip("left-hand", "wave", "repeat", &keys)]);
    })
}

/// The printed table: the name of each row with its largest error and the one of 99 %.
fn errors(report: &[u8]) -> Vec<(String, f64, f64)> {
    let text = String::from_utf8(report.to_vec()).unwrap();
    let rows = text.lines().skip_while(|line| !line.starts_with("error in pixels")).skip(1);
    let row = |line: &str| {
        let mut numbers = line.split_whitespace().rev().map(|word| word.parse::<f64>().unwrap());
        let [_mean, percentile, largest] = [(); 3].map(|()| numbers.next().unwrap());
        (line[..34].trim().to_owned(), largest, percentile)
    };
    rows.map(row).collect()
}

fn largest(report: &[u8], name: &str) -> f64 {
    let rows = errors(report);
    rows.iter().find(|row| row.0.starts_with(name)).unwrap_or_else(|| panic!("{name} in {rows:?}")).1
}

/// Exports a scene and compares the vertices of the file with the solver, in the project's pose and along all clips.
fn check(folder: &SceneFolder, output: &str, options: &str, read: impl Fn(&SceneFolder) -> Reading) {
    let report = succeed(folder.path(), &format!("export scene.c2warp.json -o {output} {options}"));
    let reading = read(folder);
    let exact = Exact::of(folder);
    let greatest = |found: &[DVec2], exact: &[DVec2]| {
        assert_eq!(found.len(), exact.len());
        found.iter().zip(exact).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
    };
    let error = greatest(&reading.posed(None), &exact.posed(&reading.rest, None));
    let stated = largest(&report, "vertices, project's pose");
    assert!(error <= stated + ROUNDING_PX, "{output}: {error} px in the pose, {stated} stated");
    for (at, clip) in exact.project.clips.iter().enumerate() {
        let stated = largest(&report, &format!("vertices, clip {:?}", clip.name)) + KEYS_PX;
        for k in 0..TIMES {
            let time = clip.duration * f64::from(k) / f64::from(TIMES);
            let error = greatest(&reading.posed(Some((at, time))), &exact.posed(&reading.rest, Some((at, time))));
            assert!(
                error <= stated + ROUNDING_PX,
                "{output}: {error} px at {time} s of {:?}, {stated} stated",
                clip.name
            );
        }
    }
    let area: f64 = reading
        .triangles
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|vertex| reading.rest[vertex]);
            (b - a).perp_dot(c - a) / 2.0
        })
        .sum();
    let drawn = exact.solution.domain().area();
    assert!(area > 0.98 * drawn && area < 1.4 * drawn, "{output}: triangles of {area} px² for {drawn} px²");
}

/// The bones and clips of a scene in all formats.
fn listings(folder: &SceneFolder, options: &str) -> [(&'static str, Listing); 4] {
    let export = |output| drop(succeed(folder.path(), &format!("export scene.c2warp.json -o {output} {options}")));
    ["out.spine.json", "out_ske.json", "out.glb", "out.tscn"].into_iter().for_each(export);
    [
        ("Spine", spine::read(folder).listing()),
        ("DragonBones", dragonbones::read(folder).listing()),
        ("glTF", gltf::listing(folder)),
        ("Godot", godot::read(folder).listing()),
    ]
}

#[test]
fn each_handle_is_a_bone_of_its_name_at_its_place_in_all_formats() {
    // The first has many sites, the second turns and stretches, and the third has bars alone.
    for (folder, options) in [(figure(), "--bones 6"), (strip(), "--bones 3 --influences 2"), (bars(), "--bones 2")] {
        // Names that others could take: those of the root, of bones between, and of further bones of a handle.
        let folder = folder.edited(|project| {
            let last = project["handles"].as_array().unwrap().len() - 1;
            for (at, name) in [(0, "site 9"), (last, "root")] {
                let text =
                    project.to_string().replace(&project["handles"][at]["id"].to_string(), &json!(name).to_string());
                *project = serde_json::from_str(&text).unwrap();
            }
        });
        let Exact { project, .. } = Exact::of(&folder);
        // As few bones as possible, and in the largest scene as many as usual.
        let usual = (project.handles.len() > 3).then_some("");
        for options in [options].into_iter().chain(usual) {
            for (format, Listing { bones, .. }) in listings(&folder, options) {
                for handle in &project.handles {
                    let place = bones.get(&handle.id).unwrap_or_else(|| panic!("{format} {options}: {:?}", handle.id));
                    let corners = handle.shape.posed();
                    let pieces = corners.windows(2).map(|piece| (piece[0], piece[1]));
                    let on_piece = |(a, b): (DVec2, DVec2)| place.distance(a) + place.distance(b) - a.distance(b);
                    let off = pieces.map(on_piece).fold(place.distance(corners[0]), f64::min);
                    assert!(off < ROUNDING_PX, "{format} {options}: {:?} is {off} px off", handle.id);
                }
            }
        }
    }
}

#[test]
fn pieces_of_a_bar_have_bones_of_their_own_where_there_are_enough() {
    let names = |options: &str| -> Vec<String> {
        let [(_, spine), ..] = listings(&bars(), options);
        spine.bones.into_keys().filter(|name| !name.starts_with("site ")).collect()
    };
    let few = names("--bones 2");
    assert_eq!(few.len(), 3, "the root and two bars: {few:?}");
    let of_handle = |name: &str| names("").into_iter().filter(|bone| bone.starts_with(name)).count();
    let Exact { project, .. } = Exact::of(&bars());
    assert!(project.handles.iter().all(|handle| of_handle(&handle.id) >= 2), "{:?}", names(""));
}

#[test]
fn clips_last_as_long_in_all_formats() {
    let still = |name: &str, seconds: f64, looping: &str, keys: &[(f64, [f64; 2])]| {
        let key = |&(time, posed): &(f64, [f64; 2])| json!({ "time": time, "posed": posed });
        let keys: Vec<Value> = keys.iter().map(key).collect();
        let tracks = if keys.is_empty() { json!([]) } else { json!([{ "handle": "middle", "keys": keys }]) };
        json!({ "name": name, "duration": seconds, "loop": looping, "tracks": tracks })
    };
    let [here, there] = [[48.0, 24.0], [44.0, 30.0]];
    let clips = json!([
        still("no track", 2.0, "none", &[]),
        still("one key", 3.0, "repeat", &[(0.5, there)]),
        still("one key at rest", 0.5, "none", &[(0.0, here)]),
        still("two equal keys", 1.5, "none", &[(0.0, there), (1.0, there)]),
        still("there and back", 1.0, "alternate", &[(0.0, there)]),
        still("pause at the end", 2.0, "none", &[(0.0, here), (0.5, there)]),
        still("pause at the beginning", 2.0, "none", &[(1.5, here), (2.0, there)]),
        still("no whole number of frames", 0.71, "repeat", &[(0.0, here), (0.4, there)]),
        still("less than a frame", 0.004, "none", &[]),
    ]);
    let with_handles = strip().edited(|project| project["clips"] = clips.clone());
    let without = SceneFolder::new("untouched").edited(|project| project["clips"] = json!([clips[0], clips[8]]));
    for folder in [with_handles, without] {
        let Exact { project, .. } = Exact::of(&folder);
        for (format, Listing { clips, .. }) in listings(&folder, "") {
            assert_eq!(clips.len(), project.clips.len(), "{format}");
            for clip in &project.clips {
                let plays_back = clip.looping == Looping::Alternate && format != "Godot";
                let wanted = if plays_back { 2.0 * clip.duration } else { clip.duration };
                let found = clips[&clip.name];
                assert!((found - wanted).abs() < 2e-6, "{format}: {found} s of {:?}, {wanted} s", clip.name);
            }
        }
    }
}

#[test]
fn more_handles_than_bones_are_refused_by_their_number() {
    let folder = strip();
    let before = folder.file_names();
    let line = fail(folder.path(), "export scene.c2warp.json -o out.glb --bones 2");
    assert_eq!(line, "scene.c2warp.json: this project has 3 handles: --bones must be at least 3");
    let many = strip().edited(|project| {
        let handle = |k: usize| {
            let at = [4.0 + (k % 30) as f64 * 3.0, 4.0 + (k / 30) as f64 * 4.0];
            json!({ "id": format!("{k}"), "kind": "point", "rest": at, "posed": at })
        };
        (project["clips"], project["handles"]) = (json!([]), (0..256).map(handle).collect());
    });
    let line = fail(many.path(), "export scene.c2warp.json -o out.glb --bones 255");
    assert_eq!(
        line,
        "scene.c2warp.json: this project has 256 handles: an engine's rig has up to 255 bones, one for each handle"
    );
    assert_eq!(folder.file_names(), before);
}

#[test]
fn spine_vertices_are_those_of_the_solver() {
    check(&strip(), "out.spine.json", "", spine::read);
    check(&strip(), "out.spine.json", "--influences 32", spine::read);
    check(&figure(), "out.spine.json", "--vertices 150", spine::read);
    check(&bars(), "out.spine.json", "--bones 30", spine::read);
    check(&brushed(), "out.spine.json", "", spine::read);
}

#[test]
fn dragonbones_vertices_are_those_of_the_solver() {
    check(&strip(), "out_ske.json", "", dragonbones::read);
    check(&figure(), "out_ske.json", "--vertices 150", dragonbones::read);
    check(&bars(), "out_ske.json", "--bones 30", dragonbones::read);
    check(&brushed(), "out_ske.json", "", dragonbones::read);
}

#[test]
fn godot_vertices_are_those_of_the_solver() {
    check(&strip(), "out.tscn", "", godot::read);
    check(&figure(), "out.tscn", "--vertices 150", godot::read);
    check(&bars(), "out.tscn", "--bones 30", godot::read);
    check(&brushed(), "out.tscn", "", godot::read);
}

#[test]
fn all_weights_of_a_linear_blend_are_exact() {
    for folder in [strip(), bars()] {
        let report = succeed(folder.path(), "export scene.c2warp.json -o out.glb --bones 255 --influences 32");
        let rows = errors(&report);
        let vertices = rows.iter().filter(|row| row.0.starts_with("vertices"));
        assert!(vertices.clone().count() >= 2 && vertices.clone().all(|row| row.1 <= 0.01), "{rows:?}");
    }
}

#[test]
fn four_weights_lose_half_a_pixel_at_most_at_99_of_100_vertices() {
    for folder in [strip(), figure(), bars()] {
        let report = succeed(folder.path(), "export scene.c2warp.json -o out.glb");
        let rows = errors(&report);
        assert!(rows.iter().filter(|row| row.0.starts_with("vertices")).all(|row| row.2 <= 0.5), "{rows:?}");
    }
}

#[test]
fn files_are_written_side_by_side_and_hold_the_picture() {
    let folder = strip();
    for output in ["a.spine.json", "b_ske.json", "c.glb", "d.tscn"] {
        succeed(folder.path(), &format!("export scene.c2warp.json -o {output}"));
    }
    let names = folder.file_names();
    let rigs =
        ["a.atlas", "a.png", "a.spine.json", "b_ske.json", "b_tex.json", "b_tex.png", "c.glb", "d.png", "d.tscn"];
    assert_eq!(names, rigs.into_iter().chain(["scene.c2warp.json", "strip.png"]).collect::<Vec<_>>());
    for name in ["a.png", "b_tex.png", "d.png"] {
        assert!(folder.picture(name) == folder.picture("strip.png"), "{name}");
    }
    let atlas = fs::read_to_string(folder.file("a.atlas")).unwrap();
    assert_eq!(atlas, "a.png\nsize: 96, 48\nfilter: Linear, Linear\na\nbounds: 0, 0, 96, 48\n");
}

#[test]
fn the_picture_of_the_project_stays_as_it_is() {
    let folder = strip();
    let before = fs::read(folder.file("strip.png")).unwrap();
    succeed(folder.path(), "export scene.c2warp.json -o strip.spine.json");
    assert!(fs::read(folder.file("strip.png")).unwrap() == before);
}

#[test]
fn the_same_project_gives_the_same_files() {
    let folder = figure();
    for (output, others) in
        [("out.spine.json", "out.atlas"), ("out_ske.json", "out_tex.json"), ("out.glb", ""), ("out.tscn", "")]
    {
        let all = || {
            let report = succeed(folder.path(), &format!("export scene.c2warp.json -o {output}"));
            let files = [output, others].into_iter().filter(|name| !name.is_empty());
            (report, files.map(|name| fs::read(folder.file(name)).unwrap()).collect::<Vec<_>>())
        };
        assert!(all() == all(), "{output}");
    }
}

#[test]
fn refused_options_name_the_option_and_write_nothing() {
    let folder = strip();
    let before = folder.file_names();
    let refused = |options: &str| fail(folder.path(), &format!("export scene.c2warp.json {options}"));
    for (options, line) in [
        ("-o out.json", "out.json: the name of a rig must end with .spine.json, _ske.json, .glb or .tscn"),
        ("-o -", "-: the name of a rig must end with .spine.json, _ske.json, .glb or .tscn"),
        ("-o out.glb --influences 0", "--influences: expected a number from 1 to 32, found 0"),
        ("-o out.tscn --influences 5", "--influences: Godot blends at most 4 bones per vertex, found 5"),
        ("-o out.glb --vertices 2", "--vertices: expected a number from 3 to 65535, found 2"),
        ("-o out.glb --vertices NaN", "--vertices: expected a whole number, found NaN"),
        ("-o out.glb --bones -1", "--bones: expected a whole number, found -1"),
        (
            "-o out.glb --bones 2000",
            "--bones: expected a number from 1 to 255, found 2000: engines store bone numbers in 8 bits",
        ),
        ("-o out.glb --bones 1.5", "--bones: expected a whole number, found 1.5"),
        (
            "-o out.glb --vertices 3",
            "scene.c2warp.json: --vertices: the outline alone needs 4 vertices, but only 3 are allowed",
        ),
    ] {
        assert_eq!(refused(options), line);
    }
    assert_eq!(folder.file_names(), before);
    let long = strip().edited(|project| project["clips"][0]["duration"] = 500.into());
    let line = fail(long.path(), "export scene.c2warp.json -o out.glb");
    assert_eq!(line, "scene.c2warp.json: clip \"turn\" lasts 500 s: a clip of an engine's rig can last up to 120 s");
}

#[test]
fn two_thousand_sites_become_the_requested_number_of_bones() {
    let folder = strip().edited(|project| project["pose"] = json!({ "density": 2000 }));
    let report =
        String::from_utf8(succeed(folder.path(), "export scene.c2warp.json -o out.spine.json --bones 255")).unwrap();
    let words: Vec<&str> = report.lines().next().unwrap().split_whitespace().collect();
    let [bones, sites] = [1, 3].map(|at| words[at].parse::<usize>().unwrap());
    assert!(bones <= 255 && sites >= 2000, "{report}");
}

#[test]
fn a_project_without_handles_is_a_picture_without_bones() {
    let folder = SceneFolder::new("untouched");
    check(&folder, "out.spine.json", "", spine::read);
    check(&folder, "out.tscn", "", godot::read);
}
