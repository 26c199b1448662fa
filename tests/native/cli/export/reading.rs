//! A rig as read from a file, in the places of the picture: pixels, y down.

use std::collections::BTreeMap;

use glam::{DAffine2, DVec2};

/// The pose of the bones, or that at a time of a clip.
pub(super) type Moment = Option<(usize, f64)>;

/// The bones and clips of a rig by their names.
pub(super) struct Listing {
    /// The places of the bones in the pose of the project.
    pub(super) bones: BTreeMap<String, DVec2>,
    /// How long clips last, in seconds.
    pub(super) clips: BTreeMap<String, f64>,
}

/// A rig as read from a file.
pub(super) struct Reading {
    /// The vertices at rest, by their texture coordinates.
    pub(super) rest: Vec<DVec2>,
    pub(super) triangles: Vec<[usize; 3]>,
    /// For each vertex its bones with a place that each of them carries, and weights.
    pub(super) weights: Vec<Vec<(usize, DVec2, f64)>>,
    /// The names of the bones.
    pub(super) names: Vec<String>,
    /// How long clips last, in seconds, by their names.
    pub(super) clips: BTreeMap<String, f64>,
    /// The bones at a moment.
    pub(super) bones: Box<dyn Fn(Moment) -> Vec<DAffine2>>,
    /// Whether y goes up in the file.
    pub(super) is_upward: bool,
}

impl Reading {
    pub(super) fn posed(&self, moment: Moment) -> Vec<DVec2> {
        let bones = (self.bones)(moment);
        let place = |row: &Vec<(usize, DVec2, f64)>| -> DVec2 {
            let sum: DVec2 = row.iter().map(|&(bone, p, weight)| weight * bones[bone].transform_point2(p)).sum();
            if self.is_upward { DVec2::new(sum.x, -sum.y) } else { sum }
        };
        self.weights.iter().map(place).collect()
    }

    pub(super) fn listing(self) -> Listing {
        let place = |bone: &DAffine2| {
            let DVec2 { x, y } = bone.translation;
            DVec2::new(x, if self.is_upward { -y } else { y })
        };
        let places = (self.bones)(None);
        Listing { bones: self.names.into_iter().zip(places.iter().map(place)).collect(), clips: self.clips }
    }
}

/// A value between keys that straight lines join. It stays before the first and after the last one.
pub(super) fn interpolated(times: &[f64], values: &[f64], time: f64) -> f64 {
    let next = times.partition_point(|&key| key <= time);
    match (next.checked_sub(1), values.get(next)) {
        (None, _) => values[0],
        (Some(last), None) => values[last],
        (Some(last), Some(value)) => {
            let along = (time - times[last]) / (times[next] - times[last]);
            values[last] + along * (value - values[last])
        }
    }
}

/// The matrix of axes at two angles in degrees, with their lengths.
pub(super) fn axes([x, y]: [f64; 2], [first, second]: [f64; 2], [along, across]: [f64; 2]) -> DAffine2 {
    let axis = |degrees: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        DVec2::new(cos, sin)
    };
    DAffine2::from_cols(along * axis(first), across * axis(second), DVec2::new(x, y))
}
