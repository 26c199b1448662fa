//! Reads Spine JSON, apart from the writer. The format: <https://esotericsoftware.com/spine-json-format>.

use std::fs;

use glam::{DAffine2, DVec2};
use serde_json::Value;

use super::reading::{Moment, Reading, axes, interpolated};
use crate::scene_folder::SceneFolder;

pub(super) fn read(folder: &SceneFolder) -> Reading {
    let file: Value = serde_json::from_slice(&fs::read(folder.file("out.spine.json")).unwrap()).unwrap();
    assert!(file["skeleton"]["spine"].as_str().unwrap().starts_with("4.2"));
    let slot = &file["slots"][0];
    let attachment = slot["attachment"].as_str().unwrap();
    let mesh = &file["skins"][0]["attachments"][slot["name"].as_str().unwrap()][attachment];
    assert_eq!(mesh["type"], "mesh");
    let numbers =
        |key: &str| -> Vec<f64> { mesh[key].as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect() };
    let size = DVec2::new(mesh["width"].as_f64().unwrap(), mesh["height"].as_f64().unwrap());
    let rest: Vec<DVec2> = numbers("uvs").chunks(2).map(|uv| DVec2::new(uv[0], uv[1]) * size).collect();
    let corners: Vec<usize> = numbers("triangles").into_iter().map(|corner| corner as usize).collect();
    assert!(mesh["hull"].as_u64().unwrap() as usize <= rest.len());
    let all = numbers("vertices");
    assert!(all.len() > 2 * rest.len(), "weighted vertices");
    let (mut weights, mut at) = (Vec::new(), 0);
    while at < all.len() {
        let count = all[at] as usize;
        let row = all[at + 1..at + 1 + 4 * count].chunks(4);
        weights.push(row.map(|one| (one[0] as usize, DVec2::new(one[1], one[2]), one[3])).collect());
        at += 1 + 4 * count;
    }
    let triangles = corners.chunks(3).map(|t| [t[0], t[1], t[2]]).collect();
    let name = |bone: &Value| bone["name"].as_str().unwrap().to_owned();
    let names = file["bones"].as_array().unwrap().iter().map(name).collect();
    let clips =
        file["animations"].as_object().unwrap().iter().map(|(name, clip)| (name.clone(), seconds(clip))).collect();
    let bones = Box::new(move |moment| bones(&file, moment));
    Reading { rest, triangles, weights, names, clips, bones, is_upward: true }
}

/// The time of the last key: the runtime ends the clip there.
fn seconds(animation: &Value) -> f64 {
    let tracks = animation["bones"].as_object().unwrap().values().flat_map(|bone| bone.as_object().unwrap().values());
    let times = tracks.flat_map(|keys| keys.as_array().unwrap()).map(|key| key["time"].as_f64().unwrap_or(0.0));
    times.fold(0.0, f64::max)
}

fn bones(file: &Value, moment: Moment) -> Vec<DAffine2> {
    // An object keeps the order of the file's clips under names in the order of the alphabet, so look up by the name.
    let animation = moment.map(|(clip, time)| {
        let names: Vec<&String> = file["animations"].as_object().unwrap().keys().collect();
        let order = if names.len() == 2 { ["turn", "to and_fro"][clip] } else { names[clip] };
        (&file["animations"][order], time)
    });
    let mut worlds: Vec<(String, DAffine2)> = Vec::new();
    for bone in file["bones"].as_array().unwrap() {
        let name = bone["name"].as_str().unwrap();
        let own = |key: &str, default: f64| bone[key].as_f64().unwrap_or(default);
        let value = |track: &str, key: &str, still: f64| {
            let Some((animation, time)) = animation else { return still };
            let Some(keys) = animation["bones"][name][track].as_array() else { return still };
            let number = |key: &Value, name: &str, default: f64| key[name].as_f64().unwrap_or(default);
            let times: Vec<f64> = keys.iter().map(|key| number(key, "time", 0.0)).collect();
            let values: Vec<f64> = keys.iter().map(|entry| number(entry, key, still)).collect();
            interpolated(&times, &values, time)
        };
        let rotation = own("rotation", 0.0) + value("rotate", "value", 0.0);
        let shear = [own("shearX", 0.0) + value("shear", "x", 0.0), own("shearY", 0.0) + value("shear", "y", 0.0)];
        let scale = [own("scaleX", 1.0) * value("scale", "x", 1.0), own("scaleY", 1.0) * value("scale", "y", 1.0)];
        let place = [own("x", 0.0) + value("translate", "x", 0.0), own("y", 0.0) + value("translate", "y", 0.0)];
        let local = axes(place, [rotation + shear[0], rotation + 90.0 + shear[1]], scale);
        let world = match bone["parent"].as_str() {
            Some(parent) => worlds.iter().find(|known| known.0 == parent).expect("parents come first").1 * local,
            None => local,
        };
        worlds.push((name.to_owned(), world));
    }
    worlds.into_iter().map(|(_, world)| world).collect()
}
