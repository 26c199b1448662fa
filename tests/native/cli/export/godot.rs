//! Reads a scene of Godot 4, apart from the writer.

use std::collections::HashMap;
use std::fs;

use glam::{DAffine2, DVec2};

use super::reading::{Moment, Reading, axes, interpolated};
use crate::scene_folder::SceneFolder;

/// A section with its heading and properties.
struct Section {
    heading: String,
    properties: HashMap<String, String>,
}

impl Section {
    /// A quoted attribute of the heading.
    fn attribute(&self, name: &str) -> &str {
        let start = self.heading.find(&format!("{name}=\"")).map_or(usize::MAX, |at| at + name.len() + 2);
        self.heading.get(start..).and_then(|rest| rest.split('"').next()).unwrap_or("")
    }

    fn numbers(&self, property: &str) -> Vec<f64> {
        self.properties.get(property).map_or_else(Vec::new, |text| numbers(text))
    }
}

/// All numbers in a text, besides those in names such as `Vector2`.
fn numbers(text: &str) -> Vec<f64> {
    let words = text.split(|c: char| "()[]{},:\" \n".contains(c)).filter(|word| !word.is_empty());
    words.filter_map(|word| word.parse().ok()).collect()
}

fn sections(text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    let mut last = String::new();
    for line in text.lines().filter(|line| !line.is_empty()) {
        if line.starts_with('[') {
            sections.push(Section { heading: line.to_owned(), properties: HashMap::new() });
        } else if let (Some((key, value)), false) = (line.split_once(" = "), line.starts_with('"')) {
            last = key.to_owned();
            sections.last_mut().unwrap().properties.insert(last.clone(), value.to_owned());
        } else {
            let value = sections.last_mut().unwrap().properties.get_mut(&last).unwrap();
            value.push('\n');
            value.push_str(line);
        }
    }
    sections
}

pub(super) fn read(folder: &SceneFolder) -> Reading {
    let text = fs::read_to_string(folder.file("out.tscn")).unwrap();
    assert!(text.starts_with("[gd_scene load_steps="));
    let all = sections(&text);
    let texture = all.iter().find(|section| section.heading.starts_with("[ext_resource")).unwrap();
    assert!(folder.file(texture.attribute("path")).exists());
    let polygon = all.iter().find(|section| section.attribute("type") == "Polygon2D").unwrap();
    let pairs = |property: &str| -> Vec<DVec2> {
        polygon.numbers(property).chunks(2).map(|p| DVec2::new(p[0], p[1])).collect()
    };
    let (places, rest) = (pairs("polygon"), pairs("uv"));
    let corners = polygon.numbers("polygons");
    let triangles = corners.chunks(3).map(|t| [t[0], t[1], t[2]].map(|corner| corner as usize)).collect();
    let bones: Vec<Bone> = all.iter().filter(|section| section.attribute("type") == "Bone2D").map(Bone::new).collect();
    let mut weights: Vec<Vec<(usize, DVec2, f64)>> = vec![Vec::new(); places.len()];
    let list = &polygon.properties["bones"];
    // The list alternates between paths in quotes and weights.
    let parts: Vec<&str> = list.trim_matches(['[', ']']).split('"').skip(1).collect();
    for pair in parts.chunks(2) {
        let bone = bones.iter().position(|bone| bone.path == format!("Skeleton2D/{}", pair[0])).unwrap();
        let of_bone = numbers(pair[1]);
        assert_eq!(of_bone.len(), places.len());
        for (vertex, &weight) in of_bone.iter().enumerate().filter(|(_, weight)| **weight > 0.0) {
            weights[vertex].push((bone, bones[bone].rest.inverse().transform_point2(places[vertex]), weight));
        }
    }
    assert!(weights.iter().all(|row| (1..=4).contains(&row.len())), "Godot takes four bones");
    let names = bones.iter().map(|bone| bone.path.rsplit('/').next().unwrap().to_owned()).collect();
    let of_clips = || all.iter().filter(|section| section.attribute("type") == "Animation");
    let text = |section: &Section, property: &str| section.properties[property].trim_matches('"').to_owned();
    let clips = of_clips().map(|clip| (text(clip, "resource_name"), clip.numbers("length")[0])).collect();
    let animations: Vec<Vec<Track>> =
        of_clips().map(|section| (0..).map_while(|at| Track::new(section, at)).collect()).collect();
    let posed = move |moment: Moment| {
        bones.iter().map(|bone| bone.posed(moment.map(|(clip, time)| (&animations[clip][..], time)))).collect()
    };
    Reading { rest, triangles, weights, names, clips, bones: Box::new(posed), is_upward: false }
}

struct Bone {
    path: String,
    /// x, y, rotation, scale x, scale y, skew.
    pose: [f64; 6],
    rest: DAffine2,
}

impl Bone {
    fn new(section: &Section) -> Self {
        let number = |property: &str, at: usize, default: f64| *section.numbers(property).get(at).unwrap_or(&default);
        let rest = section.numbers("rest");
        Self {
            path: format!("{}/{}", section.attribute("parent"), section.attribute("name")),
            pose: [
                number("position", 0, 0.0),
                number("position", 1, 0.0),
                number("rotation", 0, 0.0),
                number("scale", 0, 1.0),
                number("scale", 1, 1.0),
                number("skew", 0, 0.0),
            ],
            // The root does not move, so that the places of its children are those in the scene.
            rest: DAffine2::from_cols_array(&[rest[0], rest[1], rest[2], rest[3], rest[4], rest[5]]),
        }
    }

    fn posed(&self, moment: Option<(&[Track], f64)>) -> DAffine2 {
        let mut pose = self.pose;
        if let Some((tracks, time)) = moment {
            for (property, first) in [("position", 0), ("rotation", 2), ("scale", 3), ("skew", 5)] {
                let path = format!("{}:{property}", self.path);
                if let Some(track) = tracks.iter().find(|track| track.path == path) {
                    let width = track.values.len() / track.times.len();
                    for k in 0..width {
                        let values: Vec<f64> = track.values.iter().skip(k).step_by(width).copied().collect();
                        pose[first + k] = interpolated(&track.times, &values, time);
                    }
                }
            }
        }
        let [x, y, rotation, along, across, skew] = pose;
        axes([x, y], [rotation.to_degrees(), (rotation + skew).to_degrees() + 90.0], [along, across])
    }
}

struct Track {
    path: String,
    times: Vec<f64>,
    values: Vec<f64>,
}

impl Track {
    fn new(animation: &Section, at: usize) -> Option<Self> {
        let path = animation.properties.get(&format!("tracks/{at}/path"))?;
        let keys = &animation.properties[&format!("tracks/{at}/keys")];
        let part = |name: &str| {
            let start = keys.find(&format!("\"{name}\":")).unwrap() + name.len() + 3;
            let rest = &keys[start..];
            numbers(&rest[..rest.find(['\n', '}']).unwrap_or(rest.len())])
        };
        assert_eq!(animation.properties[&format!("tracks/{at}/type")], "\"value\"");
        Some(Self { path: path.split('"').nth(1).unwrap().to_owned(), times: part("times"), values: part("values") })
    }
}
