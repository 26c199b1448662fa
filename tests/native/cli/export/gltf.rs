//! Reads the bones and clips of glTF 2.0, apart from the writer. Its vertices are read by three.js.

use std::fs;

use glam::DVec2;
use serde_json::Value;

use super::reading::Listing;
use crate::scene_folder::SceneFolder;

pub(super) fn listing(folder: &SceneFolder) -> Listing {
    let bytes = fs::read(folder.file("out.glb")).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let file: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let name = |value: &Value| value["name"].as_str().unwrap().to_owned();
    let nodes = list(&file["nodes"]);
    let parent = |node: usize| nodes.iter().position(|other| list(&other["children"]).contains(&node.into()));
    // No bone hangs from one that is turned or scaled, other than inner ones, which lie in their origin.
    let place = |node: usize| {
        let ancestors = std::iter::successors(Some(node), |&node| parent(node));
        let number = |value: &Value| value.as_f64().unwrap_or(0.0);
        let places = ancestors.map(|node| &nodes[node]["translation"]);
        places.map(|t| DVec2::new(number(&t[0]), -number(&t[1]))).sum::<DVec2>()
    };
    let joints = list(&file["skins"][0]["joints"]).into_iter().map(|joint| joint.as_u64().unwrap() as usize);
    let seconds = |clip: &Value| {
        assert!(!list(&clip["channels"]).is_empty(), "the specification demands a channel");
        let inputs = list(&clip["samplers"]).into_iter().map(|sampler| sampler["input"].as_u64().unwrap() as usize);
        inputs.map(|input| file["accessors"][input]["max"][0].as_f64().unwrap()).fold(0.0, f64::max)
    };
    Listing {
        bones: joints.map(|joint| (name(&nodes[joint]), place(joint))).collect(),
        clips: list(&file["animations"]).iter().map(|clip| (name(clip), seconds(clip))).collect(),
    }
}
