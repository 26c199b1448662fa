//! The places of a rig's vertices by the solver.

use std::fs;

use c2warp::clip::Playback;
use c2warp::deform::Pose;
use c2warp::project::Project;
use c2warp::{Picture, Solution, solve};
use glam::DVec2;

use super::reading::Moment;
use crate::scene_folder::{PROJECT, SceneFolder};

pub(super) struct Exact {
    pub(super) project: Project,
    pub(super) solution: Solution,
}

impl Exact {
    pub(super) fn of(folder: &SceneFolder) -> Self {
        let project = Project::from_json(&fs::read_to_string(folder.file(PROJECT)).unwrap()).unwrap();
        let pixels = folder.picture(&project.image.src);
        let picture = Picture::new(pixels.width(), pixels.height(), pixels.as_raw()).unwrap();
        let solution = solve(&project, &picture).unwrap();
        Self { project, solution }
    }

    pub(super) fn posed(&self, rest: &[DVec2], moment: Moment) -> Vec<DVec2> {
        let pose = self.pose(moment);
        rest.iter().map(|&p| self.place(&pose, p)).collect()
    }

    fn pose(&self, moment: Moment) -> Pose {
        let Some((clip, time)) = moment else { return self.solution.pose(&self.project).unwrap() };
        let Project { clips, handles, pose, .. } = &self.project;
        let mut playback = Playback::new(self.solution.poser().clone(), clips[clip].clone(), handles.clone());
        playback.pose(time, pose.blend).unwrap()
    }

    /// By `map` inside the domain. Around it, by the weights of its nearest point.
    fn place(&self, pose: &Pose, p: DVec2) -> DVec2 {
        if let Some(mapped) = self.solution.map(pose, p) {
            return mapped.posed;
        }
        let edges = self
            .solution
            .domain()
            .rings()
            .iter()
            .flat_map(|ring| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]));
        let on_edge = |[a, b]: [DVec2; 2]| a + (b - a) * ((p - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
        let nearest = edges.map(on_edge).min_by(|a, b| a.distance(p).total_cmp(&b.distance(p))).unwrap();
        pose.blended(p, self.solution.weights_at(nearest).unwrap())
    }
}
