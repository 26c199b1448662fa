//! Drags of the editor's samples: how far the picture jumps, whether it folds, and in which pose it comes to rest.
//!
//! Each handle is dragged along a straight line from rest through the middle of the picture and beyond, and back.
//! Frames follow each other as in the editor. Four handles of each picture are dragged, those with the longest ways.

use std::{error::Error, fs, hint::black_box, path::Path};

use c2warp::{
    Picture, Solution,
    deform::Pose,
    project::{Blend, PoseMode, Project, Rotation, Shape},
    solve,
};
use c2warp_bench::{
    clock::native_ms,
    drag::{Drag, DragTimes, exceeded_by, first_pose, follow},
    measure::{min_ms, minimum, repeat},
};
use glam::DVec2;

use crate::{
    comparison_mesh::ComparisonMesh,
    constraints::{Constraints, Segment},
    dense_arap::pins,
    exact::Centres,
    fitted::fitted,
    measure::Distortion,
    methods::EFFORT,
    optimum::Optimizer,
    random_poses::MESH_SAMPLES,
};

/// Numbers of frames of a drag in one direction.
pub const FRAMES: [u32; 3] = [25, 100, 400];
/// The index of the drag whose times and end count.
const USUAL: usize = 1;
/// The number of drags per picture.
const DRAGS: usize = 4;
/// How far a drag continues beyond the middle, as a fraction of the way to it.
const BEYOND: f64 = 0.6;

/// The drags of one picture.
#[derive(Debug)]
pub struct SampleDrags {
    /// The name of the sample.
    pub picture: String,
    /// The number of sites.
    pub sites: usize,
    /// The drags, the longest one first.
    pub drags: Vec<Dragged>,
    /// Times of drags with 100 frames. Times of first and settled poses are medians over the drags.
    pub times: DragTimes,
}

/// A drag with each of the [`FRAMES`].
#[derive(Debug, Clone)]
pub struct Dragged {
    /// The name of the handle.
    pub handle: String,
    /// Whether the handle passes another one closer than the width of a cell, so that the picture may have to fold.
    pub is_crossing: bool,
    /// The largest move of a vertex in a frame, divided by that of the handle.
    pub largest_moves: [f64; 3],
    /// The largest fraction of the area that is folded in a frame.
    pub folded: f64,
    /// The largest distance of a vertex from rest after the release at home, in pixels.
    pub from_home: f64,
    /// The pose at the end, for the drag with 100 frames.
    pub held: HeldPose,
    /// Energies after the release at the end, over the least known one.
    pub released: [f64; 3],
}

/// A pose at rest, compared with the optimum on a mesh.
#[derive(Debug, Clone)]
pub struct HeldPose {
    /// The energy of exact Jacobians, over the optimum. `None` if no optimum was found.
    pub exact: Option<f64>,
    /// The energy of the same mesh, over the optimum.
    pub on_mesh: Option<f64>,
    /// Folded triangles of the mesh.
    pub folds: usize,
}

impl Dragged {
    /// Returns the largest move with any number of frames.
    #[must_use]
    pub fn largest_move(&self) -> f64 {
        self.largest_moves.into_iter().fold(0.0, f64::max)
    }
}

/// Drags handles of all samples of the editor.
///
/// # Errors
/// If a sample cannot be read or solved.
pub fn drags() -> Result<Vec<SampleDrags>, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples");
    let mut names = Vec::new();
    for entry in fs::read_dir(&folder)? {
        names.extend(entry?.file_name().to_string_lossy().strip_suffix(".c2warp.json").map(str::to_owned));
    }
    names.sort();
    let of_name = |name: &String| {
        eprintln!("    {name}");
        Scene::read(&folder, name)?.drags(name)
    };
    names.iter().map(of_name).collect()
}

/// A solved sample with its handles at rest.
struct Scene {
    project: Project,
    solution: Solution,
    /// The same with harmonic motions.
    harmonic: Solution,
    /// The mesh that is drawn.
    drawn: ComparisonMesh,
    /// A coarser mesh, for the optimum.
    mesh: ComparisonMesh,
    centres: Centres,
}

/// A drag with one number of frames.
struct Run {
    largest_move: f64,
    folded: f64,
    from_home: f64,
    /// The last frame on the way out.
    end: Pose,
    released: Pose,
    frames_ms: Vec<f64>,
}

impl Scene {
    fn read(folder: &Path, name: &str) -> Result<Self, Box<dyn Error>> {
        let mut project = Project::from_json(&fs::read_to_string(folder.join(format!("{name}.c2warp.json")))?)?;
        let picture = image::open(folder.join(name).with_extension("png"))?.into_rgba8();
        project.clips.clear();
        project.pose.mode = PoseMode::Rigid;
        for handle in &mut project.handles {
            let rest = handle.shape.rest().to_vec();
            handle.shape.posed_mut().copy_from_slice(&rest);
            if matches!(handle.shape, Shape::Point { .. }) {
                handle.rotation = Rotation::Auto;
            }
        }
        Ok(Self::new(project, &Picture::new(picture.width(), picture.height(), picture.as_raw())?)?)
    }

    fn new(project: Project, picture: &Picture<'_>) -> Result<Self, c2warp::Error> {
        let mut other = project.clone();
        other.pose.mode = PoseMode::Harmonic;
        let harmonic = solve(&other, picture)?;
        other.samples = MESH_SAMPLES;
        let mesh = ComparisonMesh::of(&solve(&other, picture)?);
        let solution = solve(&project, picture)?;
        let (drawn, centres) = (ComparisonMesh::of(&solution), Centres::new(&mesh, &solution));
        Ok(Self { project, solution, harmonic, drawn, mesh, centres })
    }

    fn drags(&self, picture: &str) -> Result<SampleDrags, Box<dyn Error>> {
        let new = self.solution.poser().clone();
        let (mut drags, mut frames, mut settled, mut first, mut harmonic) = (vec![], vec![], vec![], vec![], vec![]);
        for drag in self.longest_ways() {
            let ends = drag.handles_at(&self.project.handles, 1.0);
            let firsts = repeat(native_ms, EFFORT, || first_pose(native_ms, &new, &ends))?;
            let [few, usual, many] = FRAMES.map(|count| self.run(&drag, count));
            let runs = [few?, usual?, many?];
            first.push(minimum(firsts.iter().map(|(_, ms)| *ms)));
            settled.push(min_ms(native_ms, EFFORT, || {
                // A poser keeps its last pose from rest, and a copy does not.
                let _ = black_box(self.solution.poser().clone().settle(&runs[USUAL].end, &ends));
            }));
            frames.extend_from_slice(&runs[USUAL].frames_ms);
            harmonic.push(min_ms(native_ms, EFFORT, || {
                let _ = black_box(self.harmonic.poser().pose(&ends, Blend::Linear));
            }));
            drags.push(self.dragged(&drag, &firsts[0].0, &runs)?);
        }
        let median = |times: &[f64]| exceeded_by(0.5, times);
        let times = DragTimes {
            frame: median(&frames),
            slow_frame: exceeded_by(0.01, &frames),
            first: median(&first),
            settle: median(&settled),
            harmonic: median(&harmonic),
        };
        Ok(SampleDrags { picture: picture.to_owned(), sites: self.solution.sites().len(), drags, times })
    }

    /// The drags of point handles with the longest ways.
    fn longest_ways(&self) -> Vec<Drag> {
        let middle = DVec2::new(f64::from(self.project.image.width), f64::from(self.project.image.height)) / 2.0;
        let rest = |handle: usize| self.project.handles[handle].shape.rest()[0];
        let is_point = |&handle: &usize| matches!(self.project.handles[handle].shape, Shape::Point { .. });
        let mut handles: Vec<usize> = (0..self.project.handles.len()).filter(is_point).collect();
        handles.sort_by(|&a, &b| rest(b).distance(middle).total_cmp(&rest(a).distance(middle)));
        let drag = |handle| Drag { handle, to: rest(handle).lerp(middle, 1.0 + BEYOND) };
        handles.into_iter().take(DRAGS).map(drag).collect()
    }

    fn run(&self, drag: &Drag, count: u32) -> Result<Run, c2warp::Error> {
        let (handles, poser) = (&self.project.handles, self.solution.poser());
        let step = handles[drag.handle].shape.rest()[0].distance(drag.to) / f64::from(count);
        let start = poser.pose(handles, Blend::Linear)?;
        let mut before = self.drawn_at(&start);
        let (mut largest_move, mut folded, mut frames_ms) = (0.0_f64, 0.0_f64, Vec::new());
        let mut on_frame = |pose: &Pose, ms| {
            let after = self.drawn_at(pose);
            largest_move = largest_move.max(farthest(&before, &after) / step);
            folded = folded.max(self.folded(&after));
            before = after;
            frames_ms.push(ms);
        };
        let end = follow(native_ms, poser, start, drag.frames(handles, [0.0, 1.0], count), &mut on_frame)?;
        let home = follow(native_ms, poser, end.clone(), drag.frames(handles, [1.0, 0.0], count), &mut on_frame)?;
        let home = self.drawn_at(&poser.settle(&home, handles)?);
        let released = poser.settle(&end, &drag.handles_at(handles, 1.0))?;
        let from_home = farthest(&home, &self.drawn.vertices);
        Ok(Run { largest_move, folded, from_home, end, released, frames_ms })
    }

    fn dragged(&self, drag: &Drag, from_rest: &Pose, runs: &[Run; 3]) -> Result<Dragged, c2warp::Error> {
        let mut project = self.project.clone();
        project.handles = drag.handles_at(&project.handles, 1.0);
        let held = &runs[USUAL].released;
        let on_mesh = [held, from_rest].map(|pose| self.on_mesh(pose));
        let pins = pins(&self.mesh, &Constraints::of(&project));
        let optimum = Optimizer::new(&self.mesh, &pins).lowest(&[&on_mesh[0], &on_mesh[1]]);
        let energies = runs.each_ref().map(|run| self.centres.energy(&run.released));
        let mut least = energies.into_iter().fold(self.centres.energy(from_rest), f64::min);
        if let Some(optimum) = &optimum {
            let near = fitted(&self.solution, &self.mesh.vertices, &optimum.posed)?;
            let near = self.solution.poser().settle(&near, &project.handles)?;
            least = least.min(self.centres.energy(&near));
        }
        let over_optimum = |energy: f64| Some(energy / Distortion::of(&self.mesh, &optimum.as_ref()?.posed).energy);
        let distortion = Distortion::of(&self.mesh, &on_mesh[0]);
        let greatest = |of: fn(&Run) -> f64| runs.iter().map(of).fold(0.0, f64::max);
        Ok(Dragged {
            handle: self.project.handles[drag.handle].id.to_string(),
            is_crossing: self.is_crossing(drag),
            largest_moves: runs.each_ref().map(|run| run.largest_move),
            folded: greatest(|run| run.folded),
            from_home: greatest(|run| run.from_home),
            held: HeldPose {
                exact: over_optimum(energies[USUAL]),
                on_mesh: over_optimum(distortion.energy),
                folds: distortion.folds,
            },
            released: energies.map(|energy| energy / least),
        })
    }

    fn is_crossing(&self, drag: &Drag) -> bool {
        let mut others = self.project.clone();
        let from = others.handles.remove(drag.handle).shape.rest()[0];
        let way = Segment { rest: [from, drag.to], posed: [from, drag.to] };
        let width = (self.drawn.areas.iter().sum::<f64>() / self.solution.sites().len() as f64).sqrt();
        Constraints::of(&others).check_points().iter().any(|&(rest, _)| way.nearest(rest).1 < width)
    }

    fn drawn_at(&self, pose: &Pose) -> Vec<DVec2> {
        self.solution.posed_vertices(pose)[..self.drawn.vertices.len()].to_vec()
    }

    /// The fraction of the area of folded triangles.
    fn folded(&self, posed: &[DVec2]) -> f64 {
        let is_folded = |triangle: usize| {
            let [a, b, c] = self.drawn.corners(triangle, posed);
            (b - a).perp_dot(c - a) <= 0.0
        };
        let areas = self.drawn.areas.iter().enumerate();
        let folded: f64 = areas.filter(|&(triangle, _)| is_folded(triangle)).map(|(_, area)| area).sum();
        folded / self.drawn.areas.iter().sum::<f64>()
    }

    fn on_mesh(&self, pose: &Pose) -> Vec<DVec2> {
        let map = |&p: &DVec2| self.solution.map(pose, p).map_or(p, |mapped| mapped.posed);
        self.mesh.vertices.iter().map(map).collect()
    }
}

fn farthest(a: &[DVec2], b: &[DVec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use c2warp::project::Handle;

    use super::*;

    fn scene(handles: impl IntoIterator<Item = Handle>) -> Scene {
        let mut project = Project::for_picture(80, 40).with_handles(handles).with_editor_settings();
        (project.samples, project.pose.density) = (400, 20);
        Scene::new(project, &Picture::new(80, 40, &vec![255; 80 * 40 * 4]).unwrap()).unwrap()
    }

    #[test]
    fn a_single_handle_moves_the_picture_rigidly_and_back() {
        let found = scene([Handle::point("a", [10.0, 20.0])]).drags("strip").unwrap();
        let [drag] = &found.drags[..] else { panic!("one handle") };
        assert!(drag.largest_moves.iter().all(|moved| (moved - 1.0).abs() < 1e-6), "{drag:?}");
        assert!(drag.folded == 0.0 && drag.from_home < 1e-6 && drag.held.folds == 0, "{drag:?}");
        assert!(!drag.is_crossing, "{drag:?}");
    }

    #[test]
    fn path_near_another_handle_is_a_crossing() {
        let rest = [[10.0, 20.0], [55.0, 20.0], [40.0, 38.0]];
        let scene = scene(["a", "b", "c"].into_iter().zip(rest).map(|(id, rest)| Handle::point(id, rest)));
        let crossings: Vec<bool> = scene.longest_ways().iter().map(|drag| scene.is_crossing(drag)).collect();
        // In the order of the longest ways: a passes through b, and c and b pass nothing.
        assert_eq!(crossings, [true, false, false]);
    }
}
