//! A scene of Godot 4: a `Polygon2D` with a `Skeleton2D`, and an `AnimationPlayer`.
//!
//! Lengths are pixels, and y goes down. The origin is the picture's top left corner. Angles are radians, clockwise.
//! The texture is looked up beside the scene, so both can be in any folder of a project.

use std::fmt::{self, Write};

use glam::DVec2;

use c2warp::project::Looping;

use crate::{
    chart::{Chart, Numbers},
    number::{PLACE, SCALE, SHARE, rounded, shares},
    rig::{EngineRig, Timeline},
};

/// The text of one property of a bone.
type ValueText = fn(&Numbers) -> String;

const SKELETON: &str = "Skeleton2D";

pub(crate) fn scene(rig: &EngineRig) -> Vec<u8> {
    let mut text = String::new();
    write_scene(rig, &mut text).expect("text grows without errors");
    text.into_bytes()
}

fn write_scene(rig: &EngineRig, to: &mut String) -> fmt::Result {
    let timelines = rig.timelines(Chart::Sheared);
    let steps = 2 + timelines.len() + usize::from(!timelines.is_empty());
    writeln!(to, "[gd_scene load_steps={steps} format=3]\n")?;
    writeln!(to, "[ext_resource type=\"Texture2D\" path={} id=\"1\"]\n", quoted(&format!("{}.png", rig.name)))?;
    for (at, timeline) in timelines.iter().enumerate() {
        write_animation(rig, at, timeline, to)?;
    }
    if !timelines.is_empty() {
        writeln!(to, "[sub_resource type=\"AnimationLibrary\" id=\"library\"]\n_data = {{")?;
        for (at, timeline) in timelines.iter().enumerate() {
            let comma = if at + 1 < timelines.len() { "," } else { "" };
            writeln!(to, "{}: SubResource(\"animation_{at}\"){comma}", quoted(&timeline.name))?;
        }
        writeln!(to, "}}\n")?;
    }
    writeln!(to, "[node name={} type=\"Node2D\"]\n", quoted(&rig.name))?;
    writeln!(to, "[node name=\"{SKELETON}\" type=\"Skeleton2D\" parent=\".\"]\n")?;
    let root = &rig.bones[0].name;
    write_bone(root, SKELETON, DVec2::ZERO, None, to)?;
    for (bone, numbers) in rig.bones.iter().zip(rig.setup(Chart::Sheared)).skip(1) {
        write_bone(&bone.name, &format!("{SKELETON}/{root}"), bone.rest, Some(numbers), to)?;
    }
    write_polygon(rig, to)?;
    if !timelines.is_empty() {
        writeln!(to, "\n[node name=\"AnimationPlayer\" type=\"AnimationPlayer\" parent=\".\"]")?;
        writeln!(to, "libraries = {{\n\"\": SubResource(\"library\")\n}}")?;
    }
    Ok(())
}

fn write_bone(name: &str, parent: &str, rest: DVec2, pose: Option<Numbers>, to: &mut String) -> fmt::Result {
    writeln!(to, "[node name={} type=\"Bone2D\" parent={}]", quoted(name), quoted(parent))?;
    if let Some([x, y, turn, shear, along, across]) = pose {
        writeln!(to, "position = {}", vector([x, y], PLACE))?;
        writeln!(to, "rotation = {}", rounded(turn, SHARE))?;
        writeln!(to, "scale = {}", vector([along, across], SCALE))?;
        writeln!(to, "skew = {}", rounded(shear, SHARE))?;
    }
    let [x, y] = [rest.x, rest.y].map(|number| rounded(number, PLACE));
    writeln!(to, "rest = Transform2D(1, 0, 0, 1, {x}, {y})")?;
    // Without a child, a bone has no length that the editor could calculate.
    writeln!(to, "auto_calculate_length_and_angle = false\nlength = 16.0\nbone_angle = 0.0\n")
}

fn write_polygon(rig: &EngineRig, to: &mut String) -> fmt::Result {
    let [points, uv] = [&rig.displaced, &rig.vertices].map(|p| list(p.iter().flat_map(DVec2::to_array), PLACE));
    writeln!(to, "[node name=\"Polygon2D\" type=\"Polygon2D\" parent=\".\"]")?;
    writeln!(to, "texture = ExtResource(\"1\")")?;
    writeln!(to, "skeleton = NodePath(\"../{SKELETON}\")")?;
    writeln!(to, "polygon = PackedVector2Array({points})")?;
    writeln!(to, "uv = PackedVector2Array({uv})")?;
    let triangles: Vec<String> =
        rig.triangles.iter().map(|[a, b, c]| format!("PackedInt32Array({a}, {b}, {c})")).collect();
    writeln!(to, "polygons = [{}]", triangles.join(", "))?;
    let rows: Vec<Vec<(usize, f64)>> = (0..rig.vertices.len()).map(|vertex| shares(rig.weights.row(vertex))).collect();
    let weights = |index: usize| {
        let weight = |row: &Vec<(usize, f64)>| row.iter().find(|one| one.0 == index).map_or(0.0, |one| one.1);
        format!("{}, PackedFloat32Array({})", quoted(&path(rig, index)), list(rows.iter().map(weight), SHARE))
    };
    let weights: Vec<String> = (0..rig.bones.len()).map(weights).collect();
    writeln!(to, "bones = [{}]", weights.join(", "))?;
    let inner = if rig.hull == 0 { 0 } else { rig.vertices.len() - rig.hull };
    writeln!(to, "internal_vertex_count = {inner}")
}

/// The path of a bone from the skeleton.
fn path(rig: &EngineRig, bone: usize) -> String {
    let root = &rig.bones[0].name;
    if bone == 0 { root.clone() } else { format!("{root}/{}", rig.bones[bone].name) }
}

fn write_animation(rig: &EngineRig, at: usize, timeline: &Timeline, to: &mut String) -> fmt::Result {
    let looping = match timeline.looping {
        Looping::Repeat => 1,
        Looping::Alternate => 2,
        _ => 0,
    };
    writeln!(to, "[sub_resource type=\"Animation\" id=\"animation_{at}\"]")?;
    writeln!(to, "resource_name = {}", quoted(&timeline.name))?;
    writeln!(to, "length = {}\nloop_mode = {looping}", rounded(timeline.duration, SCALE))?;
    writeln!(to, "step = {}", rounded(timeline.frame, SHARE))?;
    let mut track = 0;
    for (bone, keys) in &timeline.tracks {
        let times = list(keys.frames.iter().map(|&frame| f64::from(frame) * timeline.frame), SCALE);
        let ones = vec!["1"; keys.frames.len()].join(", ");
        let values: [(&str, ValueText); 4] = [
            ("position", |n| vector([n[0], n[1]], PLACE)),
            ("rotation", |n| rounded(n[2], SHARE).to_string()),
            ("scale", |n| vector([n[4], n[5]], SCALE)),
            ("skew", |n| rounded(n[3], SHARE).to_string()),
        ];
        for (property, value) in values {
            let path = format!("{SKELETON}/{}:{property}", path(rig, *bone));
            let values: Vec<String> = keys.numbers.iter().map(value).collect();
            writeln!(to, "tracks/{track}/type = \"value\"\ntracks/{track}/imported = false")?;
            writeln!(to, "tracks/{track}/enabled = true\ntracks/{track}/path = NodePath({})", quoted(&path))?;
            writeln!(to, "tracks/{track}/interp = 1\ntracks/{track}/loop_wrap = true")?;
            writeln!(to, "tracks/{track}/keys = {{\n\"times\": PackedFloat32Array({times}),")?;
            writeln!(to, "\"transitions\": PackedFloat32Array({ones}),\n\"update\": 0,")?;
            writeln!(to, "\"values\": [{}]\n}}", values.join(", "))?;
            track += 1;
        }
    }
    writeln!(to)
}

fn vector(pair: [f64; 2], decimals: i32) -> String {
    let [x, y] = pair.map(|number| rounded(number, decimals));
    format!("Vector2({x}, {y})")
}

fn list(numbers: impl Iterator<Item = f64>, decimals: i32) -> String {
    numbers.map(|number| rounded(number, decimals).to_string()).collect::<Vec<_>>().join(", ")
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
