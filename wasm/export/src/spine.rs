//! Spine JSON 4.2 with its atlas, as documented at <http://esotericsoftware.com/spine-json-format>.
//!
//! Lengths are pixels, and y goes up. The origin is the picture's top left corner: a point at (x, y) of it is at
//! (x, −y). Angles are degrees, anticlockwise. Keys add to the setup pose. Scales multiply it.

use glam::DVec2;
use serde_json::{Map, Value, json};

use crate::{
    chart::{Chart, Numbers},
    number::{DEGREE, PLACE, SCALE, SHARE, json, shares},
    rig::{EngineRig, Timeline},
};

const VERSION: &str = "4.2.0";

/// The atlas of one region: the whole picture.
pub(crate) fn atlas(rig: &EngineRig) -> Vec<u8> {
    let EngineRig { name, width, height, .. } = rig;
    format!("{name}.png\nsize: {width}, {height}\nfilter: Linear, Linear\n{name}\nbounds: 0, 0, {width}, {height}\n")
        .into_bytes()
}

pub(crate) fn skeleton(rig: &EngineRig) -> Vec<u8> {
    let setup = rig.setup(Chart::Sheared);
    let root = &rig.bones[0].name;
    let mut bones = vec![json!({ "name": root })];
    bones.extend(rig.bones.iter().zip(&setup).skip(1).map(|(bone, numbers)| of_bone(&bone.name, root, numbers)));
    let animations: Map<String, Value> = rig
        .timelines(Chart::Sheared)
        .into_iter()
        .map(|timeline| {
            let timeline = timeline.there_and_back();
            (timeline.name.clone(), json!({ "bones": animated(rig, &timeline, &setup) }))
        })
        .collect();
    let name = &rig.name;
    let file = json!({
        "skeleton": {
            "spine": VERSION, "x": 0, "y": -i64::from(rig.height), "width": rig.width, "height": rig.height,
            "images": "./"
        },
        "bones": bones,
        "slots": [{ "name": name, "bone": root, "attachment": name }],
        "skins": [{ "name": "default", "attachments": { name: { name: mesh(rig) } } }],
        "animations": animations,
    });
    format!("{file}\n").into_bytes()
}

fn of_bone(name: &str, parent: &str, numbers: &Numbers) -> Value {
    let [x, y, turn, shear, along, across] = *numbers;
    let mut bone = Map::new();
    bone.insert("name".into(), name.into());
    bone.insert("parent".into(), parent.into());
    let mut set = |key: &str, value: Value, default: i64| {
        if value != default {
            bone.insert(key.into(), value);
        }
    };
    set("rotation", json(-turn.to_degrees(), DEGREE), 0);
    set("x", json(x, PLACE), 0);
    set("y", json(-y, PLACE), 0);
    set("scaleX", json(along, SCALE), 1);
    set("scaleY", json(across, SCALE), 1);
    set("shearY", json(-shear.to_degrees(), DEGREE), 0);
    Value::Object(bone)
}

fn mesh(rig: &EngineRig) -> Value {
    let size = DVec2::new(f64::from(rig.width), f64::from(rig.height));
    let uvs: Vec<Value> = rig.vertices.iter().flat_map(|p| (*p / size).to_array()).map(|uv| json(uv, SHARE)).collect();
    let mut vertices = Vec::new();
    for (vertex, p) in rig.displaced.iter().enumerate() {
        let row = shares(rig.weights.row(vertex));
        vertices.push(Value::from(row.len()));
        for (bone, weight) in row {
            let q = *p - rig.bones[bone].rest;
            vertices.extend([Value::from(bone), json(q.x, PLACE), json(-q.y, PLACE), json(weight, SHARE)]);
        }
    }
    json!({
        "type": "mesh",
        "uvs": uvs,
        "triangles": rig.triangles.iter().flatten().collect::<Vec<_>>(),
        "vertices": vertices,
        "hull": rig.hull,
        "width": rig.width,
        "height": rig.height,
    })
}

fn animated(rig: &EngineRig, timeline: &Timeline, setup: &[Numbers]) -> Map<String, Value> {
    let mut bones = Map::new();
    for (bone, keys) in &timeline.tracks {
        let (bone, setup) = (&rig.bones[*bone], &setup[*bone]);
        let mut tracks = Map::new();
        // A bone that stays has a second key only to end the clip.
        let ends_clip = keys.numbers.len() > 1 && keys.numbers.iter().all(|numbers| *numbers == keys.numbers[0]);
        let mut track = |name: &str, still: i64, values: &dyn Fn(&Numbers) -> Vec<(&'static str, Value)>| {
            let all: Vec<Vec<(&str, Value)>> = keys.numbers.iter().map(values).collect();
            let is_needed = ends_clip && name == "translate";
            if !is_needed && all.iter().flatten().all(|(_, value)| *value == still) {
                return;
            }
            let key = |(frame, values): (&u32, Vec<(&str, Value)>)| {
                let time = [("time", json(f64::from(*frame) * timeline.frame, SCALE))];
                let entries = time.into_iter().chain(values).map(|(key, value)| (key.to_owned(), value));
                Value::Object(entries.collect())
            };
            tracks.insert(name.to_owned(), keys.frames.iter().zip(all).map(key).collect());
        };
        let degrees = |k: usize| move |numbers: &Numbers| json(-(numbers[k] - setup[k]).to_degrees(), DEGREE);
        track("rotate", 0, &|numbers| vec![("value", degrees(2)(numbers))]);
        track("translate", 0, &|numbers| {
            vec![("x", json(numbers[0] - setup[0], PLACE)), ("y", json(setup[1] - numbers[1], PLACE))]
        });
        track("scale", 1, &|numbers| {
            vec![("x", json(numbers[4] / setup[4], SCALE)), ("y", json(numbers[5] / setup[5], SCALE))]
        });
        track("shear", 0, &|numbers| vec![("x", Value::from(0)), ("y", degrees(3)(numbers))]);
        if !tracks.is_empty() {
            bones.insert(bone.name.clone(), Value::Object(tracks));
        }
    }
    bones
}
