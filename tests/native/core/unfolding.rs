//! Tests of the handles that force folds, and of the nearest pose without folds, where the answer is known.

use c2warp::{
    deform::{HandlePose, PosedPicture, Unfolded},
    project::{Blend, Handle, PoseMode, Project, Rotation, Support},
};
use glam::DVec2;

use crate::{
    handles::{bar, polygon},
    scenes::{mesh_of, project, solved},
};

/// Handles at the corners of a square of 320 px.
const CORNERS: [[f64; 2]; 4] = [[50.0, 50.0], [350.0, 50.0], [50.0, 350.0], [350.0, 350.0]];
const MODES: [PoseMode; 2] = [PoseMode::Harmonic, PoseMode::Rigid];

/// A square with handles at its corners, and others.
struct Scene {
    picture: PosedPicture,
    handles: Vec<Handle>,
}

impl Scene {
    fn new(mode: PoseMode, handles: impl IntoIterator<Item = Handle>) -> Self {
        let ring = [(40.0, 40.0), (360.0, 40.0), (360.0, 360.0), (40.0, 360.0)].map(DVec2::from).to_vec();
        let mut project: Project = project(&[ring], &[], Support::Smooth);
        (project.pose.mode, project.pose.density) = (mode, 40);
        let rotation = if mode == PoseMode::Rigid { Rotation::Auto } else { Rotation::Degrees(0.0) };
        let corners = CORNERS.map(|p| Handle::point(format!("corner {p:?}"), p));
        project.handles = corners.into_iter().chain(handles).map(|handle| handle.turned(rotation)).collect();
        let solution = solved(&project).expect("a valid scene");
        let picture = PosedPicture::new(mesh_of(&solution), solution.poser().clone(), project.handles.clone());
        let picture = picture.expect("one solution");
        Self { picture, handles: project.handles }
    }

    fn poses(&self) -> Vec<HandlePose> {
        self.handles.iter().map(HandlePose::from).collect()
    }

    fn folds(&self, poses: &[HandlePose]) -> usize {
        self.picture.fold_count_of(poses, Blend::Linear).expect("a pose")
    }

    /// The ids of the forcing handles of a pose, in alphabetical order.
    fn forcing_in(&self, poses: &[HandlePose]) -> Vec<&str> {
        let forcing = self.picture.forcing_handles(poses, Blend::Linear).expect("a pose");
        let mut ids: Vec<&str> = forcing.into_iter().map(|handle| self.handles[handle].id.as_str()).collect();
        ids.sort_unstable();
        ids
    }

    fn forcing(&self) -> Vec<&str> {
        let poses = self.poses();
        assert!(self.folds(&poses) > 0, "the scene folds");
        self.forcing_in(&poses)
    }

    fn unfolded(&self, last: Option<&[HandlePose]>) -> Unfolded {
        self.picture.unfolded(&self.poses(), last, Blend::Linear).expect("a pose").expect("a way out")
    }
}

fn point(id: &str, rest: [f64; 2], posed: [f64; 2]) -> Handle {
    Handle::point(id, rest).posed_at([posed])
}

fn swapped() -> [Handle; 2] {
    [point("one", [160.0, 200.0], [240.0, 200.0]), point("other", [240.0, 200.0], [160.0, 200.0])]
}

/// One handle is pushed through another one, which stays.
fn pushed() -> [Handle; 3] {
    let still = [point("still", [240.0, 200.0], [240.0, 200.0]), point("far", [200.0, 90.0], [200.0, 90.0])];
    let [still, far] = still;
    [point("pushed", [180.0, 200.0], [290.0, 200.0]), still, far]
}

fn turned_over() -> [Handle; 1] {
    [bar("bar", &[(150.0, 200.0), (250.0, 200.0)], &[(250.0, 200.0), (150.0, 200.0)])]
}

/// A polygon is mirrored: it folds in any mode.
fn mirrored() -> [Handle; 1] {
    let corners = [(150.0, 150.0), (250.0, 150.0), (250.0, 250.0), (150.0, 250.0)];
    [polygon("mirrored", &corners, &corners.map(|(x, y)| (400.0 - x, y)))]
}

#[test]
fn swapped_handles_both_force_the_folds() {
    assert_eq!(Scene::new(PoseMode::Harmonic, swapped()).forcing(), ["one", "other"]);
}

#[test]
fn mirrored_polygon_forces_the_folds() {
    for mode in MODES {
        assert!(Scene::new(mode, mirrored()).forcing().contains(&"mirrored"), "{mode:?}");
    }
}

#[test]
fn the_rigid_mode_goes_around_what_folds_otherwise() {
    for (name, handles) in
        [("swapped", swapped().to_vec()), ("pushed", pushed().to_vec()), ("turned over", turned_over().to_vec())]
    {
        let scene = Scene::new(PoseMode::Rigid, handles);
        assert_eq!(scene.folds(&scene.poses()), 0, "{name}");
    }
}

#[test]
fn handle_pushed_through_another_forces_the_folds() {
    let scene = Scene::new(PoseMode::Harmonic, pushed());
    let forcing = scene.picture.forcing_handles(&scene.poses(), Blend::Linear).unwrap();
    let ids: Vec<&str> = forcing.iter().map(|&handle| scene.handles[handle].id.as_str()).collect();
    assert_eq!(ids[0], "pushed", "{ids:?}");
    assert!(ids.iter().all(|id| ["pushed", "still"].contains(id)), "{ids:?}");
}

#[test]
fn flipped_bar_forces_the_folds() {
    assert_eq!(Scene::new(PoseMode::Harmonic, turned_over()).forcing(), ["bar"]);
}

#[test]
fn a_pose_without_folds_has_no_forcing_handles() {
    let scene = Scene::new(PoseMode::Rigid, [point("one", [160.0, 200.0], [170.0, 190.0])]);
    assert_eq!(scene.forcing_in(&scene.poses()), [""; 0]);
    let same = scene.unfolded(None);
    assert_eq!((same.poses, same.fraction, same.moved), (scene.poses(), 1.0, vec![]));
}

#[test]
fn forcing_handles_stay_when_all_handles_move_or_change_places() {
    let mode = PoseMode::Harmonic;
    let scene = Scene::new(mode, pushed());
    let expected: Vec<String> = scene.forcing().into_iter().map(str::to_owned).collect();
    let mut moved = scene.poses();
    moved.iter_mut().flat_map(|pose| &mut pose.posed).for_each(|corner| *corner += DVec2::new(400.0, -70.0));
    assert_eq!(scene.forcing_in(&moved), expected, "{mode:?}");
    let reversed = Scene::new(mode, pushed().into_iter().rev());
    assert_eq!(reversed.forcing(), expected, "{mode:?}");
    let flipped = |p: DVec2| [400.0 - p.x, p.y];
    let mirrored =
        pushed().map(|handle| point(&handle.id, flipped(handle.shape.rest()[0]), flipped(handle.shape.posed()[0])));
    assert_eq!(Scene::new(mode, mirrored).forcing(), expected, "{mode:?}");
}

/// The x coordinate of the first handle after the corners.
fn x(poses: &[HandlePose]) -> f64 {
    poses[4].posed[0].x
}

#[test]
fn nearest_pose_without_folds_moves_only_the_forcing_handles() {
    let mode = PoseMode::Harmonic;
    let scene = Scene::new(mode, pushed());
    let poses = scene.poses();
    let out = scene.unfolded(None);
    assert_eq!(scene.folds(&out.poses), 0, "{mode:?}");
    let changed: Vec<usize> = (0..poses.len()).filter(|&k| out.poses[k] != poses[k]).collect();
    assert_eq!(changed, [4], "{mode:?}");
    // It begins to fold right behind the nearest pose.
    let mut farther = out.poses.clone();
    let (rest, wanted) = (180.0, 290.0);
    assert!((x(&out.poses) - (rest + out.fraction * (wanted - rest))).abs() < 0.02, "{mode:?}: {out:?}");
    farther[4].posed[0].x = rest + (out.fraction + 0.5_f64.powi(8)) * (wanted - rest);
    assert!(scene.folds(&farther) > 0, "{mode:?}");
    assert!(x(&out.poses) > rest + 10.0, "{mode:?}: {out:?}");
}

#[test]
fn unfolding_returns_towards_the_last_pose_without_folds() {
    let scene = Scene::new(PoseMode::Rigid, pushed());
    let mut last = scene.poses();
    last[4].posed[0] = [190.0, 150.0].into();
    assert_eq!(scene.folds(&last), 0);
    let out = scene.unfolded(Some(&last));
    assert_eq!(scene.folds(&out.poses), 0);
    let [from, to, at] = [&last, &scene.poses(), &out.poses].map(|poses| poses[4].posed[0]);
    assert!(at.distance(from.lerp(to, out.fraction)) < 0.02, "{out:?}");
    // A last pose that folds itself is no way out.
    let out = scene.unfolded(Some(&scene.poses()));
    assert_eq!(out, scene.unfolded(None));
}

#[test]
fn swapped_handles_and_turned_bars_come_out_of_their_folds() {
    for mode in MODES {
        for scene in [Scene::new(mode, swapped()), Scene::new(mode, turned_over())] {
            let out = scene.unfolded(None);
            assert_eq!(scene.folds(&out.poses), 0, "{mode:?}");
            assert!(out.moved.iter().all(|&handle| handle >= 4), "{mode:?}: {out:?}");
        }
    }
}

#[test]
fn a_bar_keeps_its_length_on_the_way_out_of_folds() {
    let out = Scene::new(PoseMode::Rigid, turned_over()).unfolded(None);
    let [a, b] = out.poses[4].posed[..] else { panic!("a bar has two corners") };
    assert!((a.distance(b) - 100.0).abs() < 0.05, "{out:?}");
    assert!(out.fraction > 0.05, "{out:?}");
}

/// All handles moved together long ago, and no pose is known from which they came.
#[test]
fn folds_far_from_rest_are_left_without_moving_the_others() {
    let scene = Scene::new(PoseMode::Rigid, pushed());
    let mut poses = scene.poses();
    poses.iter_mut().flat_map(|pose| &mut pose.posed).for_each(|corner| *corner += DVec2::new(900.0, 0.0));
    let out = scene.picture.unfolded(&poses, None, Blend::Linear).unwrap().unwrap();
    assert_eq!(scene.folds(&out.poses), 0);
    assert!((0..poses.len()).all(|k| out.poses[k] == poses[k] || out.moved.contains(&k)), "{out:?}");
    assert!(out.moved.iter().all(|&handle| handle >= 4), "{out:?}");
}
