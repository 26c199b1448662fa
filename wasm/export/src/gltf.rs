//! glTF 2.0 as one binary file, following the specification by Khronos.
//!
//! One unit is one pixel, and y goes up. The origin is the picture's top left corner: a point at (x, y) of it is at
//! (x, −y, 0). Bones with unequal scales become two nested nodes, because nodes have no shear.

use glam::DVec2;
use serde_json::{Map, Value, json};

use crate::{
    chart::{Chart, Numbers},
    rig::{EngineRig, Timeline},
};

const FLOAT: u32 = 5126;
const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_BUFFER: u32 = 34963;
const LINEAR: u32 = 9729;
const LINEAR_MIPMAPS: u32 = 9987;
const CLAMPED: u32 = 33071;
/// Number of bones per attribute.
const SET: usize = 4;
/// Weights are multiples of 2 to the power of minus this, so they sum to exactly 1 in 32-bit floats.
const WEIGHT_BITS: i32 = 20;
/// A bone is one node if its second angle and the difference of its scales stay below this.
const SIMILAR: f64 = 1e-7;

pub(crate) fn binary(rig: &EngineRig, png: &[u8]) -> Vec<u8> {
    let mut buffer = Buffer::default();
    let primitive = primitive(rig, &mut buffer);
    let bind: Vec<f32> = rig
        .bones
        .iter()
        .flat_map(|bone| {
            let [x, y] = [-bone.rest.x as f32, bone.rest.y as f32];
            [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, 0.0, 1.0]
        })
        .collect();
    let bind = buffer.floats(&bind, "MAT4", None);
    let timelines: Vec<Timeline> = rig.timelines(Chart::Chained).into_iter().map(Timeline::there_and_back).collect();
    let nodes = Nodes::new(rig, &timelines);
    let animations: Vec<Value> = timelines.iter().map(|timeline| nodes.animation(timeline, &mut buffer)).collect();
    let image = buffer.view(png, None);
    let name = &rig.name;
    let mut file = json!({
        "asset": { "version": "2.0", "generator": "c2warp", "extras": { "unit": "pixel" } },
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{ "name": name, "nodes": [0, 1] }],
        "nodes": nodes.nodes,
        "meshes": [{ "name": name, "primitives": [primitive] }],
        "skins": [{ "name": name, "inverseBindMatrices": bind, "skeleton": 1, "joints": nodes.joints }],
        "materials": [{
            "name": name,
            "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0, "roughnessFactor": 1 },
            "alphaMode": "BLEND",
            "doubleSided": true,
            "extensions": { "KHR_materials_unlit": {} },
        }],
        "textures": [{ "sampler": 0, "source": 0 }],
        "samplers": [{ "magFilter": LINEAR, "minFilter": LINEAR_MIPMAPS, "wrapS": CLAMPED, "wrapT": CLAMPED }],
        "images": [{ "name": name, "bufferView": image, "mimeType": "image/png" }],
    });
    if !animations.is_empty() {
        file["animations"] = animations.into();
    }
    buffer.align();
    file["buffers"] = json!([{ "byteLength": buffer.bytes.len() }]);
    file["bufferViews"] = buffer.views.into();
    file["accessors"] = buffer.accessors.into();
    packed(&file, &buffer.bytes)
}

/// The two chunks of a binary file.
fn packed(file: &Value, buffer: &[u8]) -> Vec<u8> {
    let mut text = file.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |bytes: usize| (bytes as u32).to_le_bytes();
    let mut binary = Vec::new();
    binary.extend(b"glTF");
    binary.extend(2_u32.to_le_bytes());
    binary.extend(length(12 + 8 + text.len() + 8 + buffer.len()));
    binary.extend(length(text.len()));
    binary.extend(b"JSON");
    binary.extend(text);
    binary.extend(length(buffer.len()));
    binary.extend(b"BIN\0");
    binary.extend(buffer);
    binary
}

fn primitive(rig: &EngineRig, buffer: &mut Buffer) -> Value {
    let size = DVec2::new(f64::from(rig.width), f64::from(rig.height));
    let places: Vec<f32> = rig.displaced.iter().flat_map(|p| [p.x as f32, -p.y as f32, 0.0]).collect();
    let uvs: Vec<f32> = rig.vertices.iter().flat_map(|p| (*p / size).to_array()).map(|uv| uv as f32).collect();
    let mut attributes = Map::new();
    attributes.insert("POSITION".into(), buffer.bounded(&places, "VEC3", Some(ARRAY_BUFFER)).into());
    attributes.insert("TEXCOORD_0".into(), buffer.floats(&uvs, "VEC2", Some(ARRAY_BUFFER)).into());
    let rows: Vec<Vec<(usize, f64)>> = (0..rig.vertices.len()).map(|vertex| shares(rig.weights.row(vertex))).collect();
    for set in 0..rig.influences().div_ceil(SET) {
        let slots = || rows.iter().flat_map(|row| (0..SET).map(move |k| row.get(SET * set + k)));
        let joints: Vec<u8> = slots().map(|slot| slot.map_or(0, |one| one.0 as u8)).collect();
        let weights: Vec<f32> = slots().map(|slot| slot.map_or(0.0, |one| one.1 as f32)).collect();
        let view = buffer.view(&joints, Some(ARRAY_BUFFER));
        let joints = buffer.accessor(view, BYTE, "VEC4", rows.len());
        attributes.insert(format!("JOINTS_{set}"), joints.into());
        attributes.insert(format!("WEIGHTS_{set}"), buffer.floats(&weights, "VEC4", Some(ARRAY_BUFFER)).into());
    }
    // y goes up, so triangles change their sense: those of the picture are seen from the front.
    let corners: Vec<u8> = rig
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [a, c, b])
        .flat_map(|corner| (corner as u16).to_le_bytes())
        .collect();
    let view = buffer.view(&corners, Some(ELEMENT_BUFFER));
    let indices = buffer.accessor(view, SHORT, "SCALAR", corners.len() / 2);
    json!({ "attributes": attributes, "indices": indices, "material": 0 })
}

/// Weights in binary steps that sum to 1 exactly, the greatest first.
fn shares(row: impl Iterator<Item = (usize, f64)>) -> Vec<(usize, f64)> {
    let whole = f64::from(1 << WEIGHT_BITS);
    let mut row: Vec<(usize, f64)> = row.map(|(bone, weight)| (bone, (weight * whole).round())).collect();
    row.sort_by(|a, b| b.1.total_cmp(&a.1));
    let sum: f64 = row.iter().map(|one| one.1).sum();
    if let Some(first) = row.first_mut() {
        first.1 += whole - sum;
    }
    row.retain(|one| one.1 > 0.0);
    row.iter_mut().for_each(|one| one.1 /= whole);
    row
}

/// The nodes: the mesh, the root, and one or two for each bone.
struct Nodes {
    nodes: Vec<Value>,
    /// The node of each bone that moves vertices.
    joints: Vec<usize>,
    /// For each bone, the outer node, and the inner node if its scales are unequal.
    of_bones: Vec<(usize, Option<usize>)>,
}

impl Nodes {
    fn new(rig: &EngineRig, timelines: &[Timeline]) -> Self {
        let setup = rig.setup(Chart::Chained);
        let mut nodes = vec![json!({ "name": rig.name, "mesh": 0, "skin": 0 }), json!({ "name": rig.bones[0].name })];
        let (mut joints, mut of_bones, mut children) = (vec![1], vec![(1, None)], Vec::new());
        for (at, (bone, numbers)) in rig.bones.iter().zip(&setup).enumerate().skip(1) {
            let tracks = timelines.iter().flat_map(|timeline| &timeline.tracks).filter(|(bone, _)| *bone == at);
            let is_similar = tracks
                .flat_map(|(_, keys)| &keys.numbers)
                .chain([numbers])
                .all(|&[.., second, along, across]| second.abs() < SIMILAR && (along - across).abs() < SIMILAR);
            let outer = nodes.len();
            children.push(outer);
            let [translation, scale] = [place(numbers), scale(numbers)];
            let mut node = json!({ "translation": translation, "rotation": turn(numbers[2]), "scale": scale });
            if is_similar {
                node["name"] = bone.name.as_str().into();
                nodes.push(node);
                joints.push(outer);
                of_bones.push((outer, None));
            } else {
                node["name"] = format!("{} stretch", bone.name).into();
                node["children"] = json!([outer + 1]);
                nodes.push(node);
                nodes.push(json!({ "name": bone.name, "rotation": turn(numbers[3]) }));
                joints.push(outer + 1);
                of_bones.push((outer, Some(outer + 1)));
            }
        }
        if !children.is_empty() {
            nodes[1]["children"] = children.into();
        }
        Self { nodes, joints, of_bones }
    }

    fn animation(&self, timeline: &Timeline, buffer: &mut Buffer) -> Value {
        let (mut channels, mut samplers) = (Vec::new(), Vec::new());
        for (bone, keys) in &timeline.tracks {
            let (outer, inner) = self.of_bones[*bone];
            let times: Vec<f32> = keys.frames.iter().map(|&frame| (f64::from(frame) * timeline.frame) as f32).collect();
            let input = buffer.bounded(&times, "SCALAR", None);
            let mut channel = |node: usize, path: &str, kind: &str, values: Vec<f32>| {
                let output = buffer.floats(&values, kind, None);
                channels.push(json!({ "sampler": samplers.len(), "target": { "node": node, "path": path } }));
                samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
            };
            let numbers = || keys.numbers.iter();
            channel(outer, "translation", "VEC3", numbers().flat_map(place).collect());
            channel(outer, "rotation", "VEC4", numbers().flat_map(|n| turn(n[2])).collect());
            channel(outer, "scale", "VEC3", numbers().flat_map(scale).collect());
            if let Some(inner) = inner {
                channel(inner, "rotation", "VEC4", numbers().flat_map(|n| turn(n[3])).collect());
            }
        }
        json!({ "name": timeline.name, "channels": channels, "samplers": samplers })
    }
}

fn place(numbers: &Numbers) -> [f32; 3] {
    [numbers[0] as f32, -numbers[1] as f32, 0.0]
}

fn scale(numbers: &Numbers) -> [f32; 3] {
    [numbers[4] as f32, numbers[5] as f32, 1.0]
}

/// The quaternion of a clockwise turn, with y up.
fn turn(angle: f64) -> [f32; 4] {
    let (sin, cos) = libm::sincos(-angle / 2.0);
    [0.0, 0.0, sin as f32, cos as f32]
}

/// The binary chunk with its views and accessors.
#[derive(Default)]
struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    fn align(&mut self) {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
    }

    fn view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        self.align();
        let mut view = json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = target.into();
        }
        self.bytes.extend(bytes);
        self.views.push(view);
        self.views.len() - 1
    }

    fn accessor(&mut self, view: usize, component: u32, kind: &str, count: usize) -> usize {
        self.accessors.push(json!({ "bufferView": view, "componentType": component, "count": count, "type": kind }));
        self.accessors.len() - 1
    }

    fn floats(&mut self, numbers: &[f32], kind: &str, target: Option<u32>) -> usize {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let view = self.view(&bytes, target);
        self.accessor(view, FLOAT, kind, numbers.len() / components(kind))
    }

    /// Floats with their bounds, which the specification requires for positions and times.
    fn bounded(&mut self, numbers: &[f32], kind: &str, target: Option<u32>) -> usize {
        let accessor = self.floats(numbers, kind, target);
        let n = components(kind);
        let bound = |start: f32, choose: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..n).map(|k| numbers.iter().skip(k).step_by(n).copied().fold(start, choose)).collect()
        };
        self.accessors[accessor]["min"] = bound(f32::INFINITY, f32::min).into();
        self.accessors[accessor]["max"] = bound(f32::NEG_INFINITY, f32::max).into();
        accessor
    }
}

fn components(kind: &str) -> usize {
    match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        _ => 16,
    }
}
