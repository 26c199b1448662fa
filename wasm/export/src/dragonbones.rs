//! DragonBones JSON 5.5: a skeleton, and a texture file with one part.
//!
//! Lengths are pixels, and y goes down. The origin is the picture's top left corner. Angles are degrees, clockwise.
//! Keys add to the pose of the armature. Scales multiply it. Times are whole frames. A scale of time makes up for clips
//! that last no whole number of them.

use glam::DVec2;
use serde_json::{Value, json};

use c2warp::project::Looping;

use crate::{
    chart::{Chart, Numbers},
    number::{DEGREE, PLACE, SCALE, SHARE, json, shares},
    rig::{EngineRig, FRAMES_PER_SECOND, Timeline},
};

const VERSION: &str = "5.5";

/// The texture file: the whole picture is one part.
pub(crate) fn texture(rig: &EngineRig) -> Vec<u8> {
    let EngineRig { name, width, height, .. } = rig;
    let file = json!({
        "name": name,
        "imagePath": format!("{name}_tex.png"),
        "width": width,
        "height": height,
        "SubTexture": [{ "name": name, "x": 0, "y": 0, "width": width, "height": height }],
    });
    format!("{file}\n").into_bytes()
}

pub(crate) fn skeleton(rig: &EngineRig) -> Vec<u8> {
    let setup = rig.setup(Chart::Sheared);
    let root = &rig.bones[0].name;
    let mut bones = vec![json!({ "name": root })];
    bones.extend(rig.bones.iter().zip(&setup).skip(1).map(|(bone, numbers)| {
        let [x, y, turn, shear, along, across] = *numbers;
        json!({ "name": bone.name, "parent": root, "transform": {
            "x": json(x, PLACE), "y": json(y, PLACE),
            "skX": json((turn + shear).to_degrees(), DEGREE), "skY": json(turn.to_degrees(), DEGREE),
            "scX": json(along, SCALE), "scY": json(across, SCALE),
        } })
    }));
    let timelines = rig.timelines(Chart::Sheared);
    let animations: Vec<Value> =
        timelines.into_iter().map(|timeline| animation(rig, &timeline.there_and_back(), &setup)).collect();
    let first: Vec<Value> =
        animations.iter().take(1).map(|animation| json!({ "gotoAndPlay": animation["name"] })).collect();
    let name = &rig.name;
    let file = json!({
        "frameRate": FRAMES_PER_SECOND,
        "name": name,
        "version": VERSION,
        "compatibleVersion": VERSION,
        "armature": [{
            "type": "Armature",
            "frameRate": FRAMES_PER_SECOND,
            "name": name,
            "aabb": { "x": 0, "y": 0, "width": rig.width, "height": rig.height },
            "bone": bones,
            "slot": [{ "name": name, "parent": root }],
            "skin": [{ "name": "", "slot": [{ "name": name, "display": [mesh(rig)] }] }],
            "animation": animations,
            "defaultActions": first,
        }],
    });
    format!("{file}\n").into_bytes()
}

fn mesh(rig: &EngineRig) -> Value {
    let size = DVec2::new(f64::from(rig.width), f64::from(rig.height));
    let list = |points: &mut dyn Iterator<Item = DVec2>, decimals: i32| -> Vec<Value> {
        points.flat_map(|p| p.to_array()).map(|number| json(number, decimals)).collect()
    };
    let mut weights = Vec::new();
    for vertex in 0..rig.vertices.len() {
        let row = shares(rig.weights.row(vertex));
        weights.push(Value::from(row.len()));
        weights.extend(row.into_iter().flat_map(|(bone, weight)| [Value::from(bone), json(weight, SHARE)]));
    }
    let at_rest = |(index, rest): (usize, DVec2)| {
        [json!(index), json!(1), json!(0), json!(0), json!(1), json(rest.x, PLACE), json(rest.y, PLACE)]
    };
    let edges: Vec<usize> = (0..rig.hull).flat_map(|at| [at, (at + 1) % rig.hull]).collect();
    json!({
        "type": "mesh",
        "name": rig.name,
        "width": rig.width,
        "height": rig.height,
        "vertices": list(&mut rig.displaced.iter().copied(), PLACE),
        "uvs": list(&mut rig.vertices.iter().map(|p| *p / size), SHARE),
        "triangles": rig.triangles.iter().flatten().collect::<Vec<_>>(),
        "weights": weights,
        "slotPose": [1, 0, 0, 1, 0, 0],
        "bonePose": rig.bones.iter().map(|bone| bone.rest).enumerate().flat_map(at_rest).collect::<Vec<_>>(),
        "edges": edges,
        "userEdges": [],
    })
}

fn animation(rig: &EngineRig, timeline: &Timeline, setup: &[Numbers]) -> Value {
    let mut bones = Vec::new();
    for (bone, keys) in &timeline.tracks {
        let (bone, setup) = (&rig.bones[*bone], &setup[*bone]);
        let ends = keys.frames.iter().skip(1).copied().chain([timeline.last_frame]);
        let durations: Vec<u32> = keys.frames.iter().zip(ends).map(|(from, to)| to - from).collect();
        let track = |values: &dyn Fn(&Numbers) -> [(&'static str, Value); 2]| -> Vec<Value> {
            let key = |(duration, numbers): (&u32, &Numbers)| {
                let own = [("duration", json!(duration)), ("tweenEasing", json!(0))];
                Value::Object(
                    own.into_iter().chain(values(numbers)).map(|(key, value)| (key.to_owned(), value)).collect(),
                )
            };
            durations.iter().zip(&keys.numbers).map(key).collect()
        };
        let degrees = |numbers: &Numbers, k: usize| json((numbers[k] - setup[k]).to_degrees(), DEGREE);
        bones.push(json!({
            "name": bone.name,
            "translateFrame": track(&|n| [("x", json(n[0] - setup[0], PLACE)), ("y", json(n[1] - setup[1], PLACE))]),
            "rotateFrame": track(&|n| [("rotate", degrees(n, 2)), ("skew", degrees(n, 3))]),
            "scaleFrame": track(&|n| [("x", json(n[4] / setup[4], SCALE)), ("y", json(n[5] / setup[5], SCALE))]),
        }));
    }
    let plays = if timeline.looping == Looping::None { 1 } else { 0 };
    let scale = json(timeline.duration * f64::from(FRAMES_PER_SECOND) / f64::from(timeline.last_frame), SCALE);
    json!({
        "duration": timeline.last_frame, "scale": scale, "playTimes": plays, "fadeInTime": 0, "name": timeline.name,
        "bone": bones
    })
}
