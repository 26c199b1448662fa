//! Reads DragonBones JSON 5.5, apart from the writer.

use std::fs;

use glam::{DAffine2, DVec2};
use serde_json::Value;

use super::reading::{Moment, Reading, axes, interpolated};
use crate::scene_folder::SceneFolder;

pub(super) fn read(folder: &SceneFolder) -> Reading {
    let parse = |name: &str| -> Value { serde_json::from_slice(&fs::read(folder.file(name)).unwrap()).unwrap() };
    let (file, texture) = (parse("out_ske.json"), parse("out_tex.json"));
    assert_eq!(file["version"], "5.5");
    let armature = file["armature"][0].clone();
    let mesh = &armature["skin"][0]["slot"][0]["display"][0];
    let part = &texture["SubTexture"][0];
    assert!(mesh["type"] == "mesh" && mesh["name"] == part["name"]);
    assert!(folder.file(texture["imagePath"].as_str().unwrap()).exists());
    let numbers =
        |key: &str| -> Vec<f64> { mesh[key].as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect() };
    let size = DVec2::new(part["width"].as_f64().unwrap(), part["height"].as_f64().unwrap());
    let rest: Vec<DVec2> = numbers("uvs").chunks(2).map(|uv| DVec2::new(uv[0], uv[1]) * size).collect();
    let matrix = |n: &[f64]| DAffine2::from_cols_array(&[n[0], n[1], n[2], n[3], n[4], n[5]]);
    let slot = matrix(&numbers("slotPose"));
    let bind: Vec<(usize, DAffine2)> =
        numbers("bonePose").chunks(7).map(|row| (row[0] as usize, matrix(&row[1..]).inverse())).collect();
    let all = numbers("weights");
    let (mut weights, mut at) = (Vec::new(), 0);
    for p in numbers("vertices").chunks(2) {
        let p = slot.transform_point2(DVec2::new(p[0], p[1]));
        let count = all[at] as usize;
        let carried = |one: &[f64]| {
            let bone = one[0] as usize;
            let inverse = bind.iter().find(|known| known.0 == bone).expect("bones of weights have a pose").1;
            (bone, inverse.transform_point2(p), one[1])
        };
        weights.push(all[at + 1..at + 1 + 2 * count].chunks(2).map(carried).collect());
        at += 1 + 2 * count;
    }
    assert_eq!(at, all.len());
    let corners: Vec<usize> = numbers("triangles").into_iter().map(|corner| corner as usize).collect();
    let triangles = corners.chunks(3).map(|t| [t[0], t[1], t[2]]).collect();
    let name = |value: &Value| value["name"].as_str().unwrap().to_owned();
    let names = armature["bone"].as_array().unwrap().iter().map(name).collect();
    let rate = armature["frameRate"].as_f64().unwrap();
    let seconds = |clip: &Value| clip["duration"].as_f64().unwrap() / rate * clip["scale"].as_f64().unwrap();
    let clips = armature["animation"].as_array().unwrap().iter().map(|clip| (name(clip), seconds(clip))).collect();
    let bones = Box::new(move |moment| bones(&armature, moment));
    Reading { rest, triangles, weights, names, clips, bones, is_upward: false }
}

fn bones(armature: &Value, moment: Moment) -> Vec<DAffine2> {
    let rate = armature["frameRate"].as_f64().unwrap();
    let animation = moment.map(|(clip, time)| {
        let animation = &armature["animation"][clip];
        (animation, time * rate / animation["scale"].as_f64().unwrap())
    });
    let root = armature["bone"][0]["name"].clone();
    let local = |bone: &Value| {
        assert!(bone["name"] == root || bone["parent"] == root);
        let own = |key: &str, default: f64| bone["transform"][key].as_f64().unwrap_or(default);
        let value = |track: &str, key: &str, still: f64| {
            let Some((animation, frame)) = animation else { return still };
            let bones = animation["bone"].as_array().unwrap();
            let Some(of_bone) = bones.iter().find(|one| one["name"] == bone["name"]) else { return still };
            let (mut times, mut values, mut at) = (Vec::new(), Vec::new(), 0.0);
            for entry in of_bone[track].as_array().unwrap() {
                times.push(at);
                values.push(entry[key].as_f64().unwrap_or(still));
                at += entry["duration"].as_f64().unwrap();
                assert!(entry["tweenEasing"] == 0, "straight lines");
            }
            // The runtime turns by less than half a circle between two keys.
            assert!(key != "rotate" || values.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 180.0));
            assert_eq!(at, animation["duration"].as_f64().unwrap());
            interpolated(&times, &values, frame)
        };
        let rotation = own("skY", 0.0) + value("rotateFrame", "rotate", 0.0);
        let skew = own("skX", 0.0) - own("skY", 0.0) + value("rotateFrame", "skew", 0.0);
        let scale = [own("scX", 1.0) * value("scaleFrame", "x", 1.0), own("scY", 1.0) * value("scaleFrame", "y", 1.0)];
        let place =
            [own("x", 0.0) + value("translateFrame", "x", 0.0), own("y", 0.0) + value("translateFrame", "y", 0.0)];
        axes(place, [rotation, rotation + skew + 90.0], scale)
    };
    armature["bone"].as_array().unwrap().iter().map(local).collect()
}
