//! Tests of displaced pictures: a brush moves positions at rest before the handles pose them.

use c2warp::{
    Filter, Picture, ResampleOptions, Solution, Solver, SpriteMesh, Stage,
    cloud::PointCloud,
    deform::{HandlePose, Pose, PosedPicture},
    pose::Poser,
    project::{Blend, Displacement, Handle, PoseMode, Project},
    solve, solve_cloud,
};
use c2warp_tests::Scene;
use glam::{DMat2, DVec2};

use crate::scenes::mesh_of;

/// A grid of 20 px, with values by the place of each control point.
fn grid(displacement: impl Fn(DVec2) -> DVec2) -> Displacement {
    let place = |k: u32| 20.0 * (DVec2::new(f64::from(k % 11), f64::from(k / 11)) - 1.0);
    let values = (0..99).flat_map(|k| (256.0 / 20.0 * displacement(place(k))).to_array()).map(|v| v.round() as i16);
    Displacement::new(11, 9, values.collect())
}

fn uniform(by: DVec2) -> Displacement {
    grid(|_| by)
}

/// Waves in both directions, without folds.
fn waves() -> Displacement {
    grid(|p| DVec2::new(5.0 * libm::sin(p.y / 25.0 + p.x / 60.0), 4.0 * libm::cos(p.x / 30.0)))
}

fn rgba() -> Vec<u8> {
    let pixel = |k: u32| [(k % 160) as u8, (2 * (k / 160)) as u8, (k * 7 % 256) as u8, 255];
    (0..160 * 120).flat_map(pixel).collect()
}

fn project(blend: Blend) -> Project {
    let mut project = Project::for_picture(160, 120).with_handles([
        Handle::point("left", [30.0, 60.0]).posed_at([[40.0, 50.0]]).turned(20.0),
        Handle::point("right", [130.0, 60.0]).posed_at([[120.0, 75.0]]).turned(-35.0),
        Handle::point("top", [80.0, 15.0]),
    ]);
    (project.samples, project.pose.blend) = (1500, blend);
    project
}

fn displaced(project: &Project, displacement: Option<Displacement>) -> Project {
    let mut project = project.clone();
    project.displacement = displacement;
    project
}

fn solved(project: &Project) -> (Solution, Pose) {
    let solution = solve(project, &Picture::new(160, 120, &rgba()).expect("a picture")).expect("a valid scene");
    let pose = solution.pose(project).expect("a valid scene");
    (solution, pose)
}

fn posed_picture(project: &Project, poser: Poser) -> PosedPicture {
    let (solution, _) = solved(project);
    PosedPicture::new(mesh_of(&solution), poser, project.handles.clone()).expect("parts of one solution")
}

fn pixels(solution: &Solution, pose: &Pose) -> Vec<u8> {
    let (rgba, options) = (rgba(), ResampleOptions { filter: Filter::Nearest, ..ResampleOptions::default() });
    solution.warped(&Picture::new(160, 120, &rgba).expect("a picture"), pose, options).expect("a valid scene").rgba
}

#[test]
fn a_displacement_of_zeros_changes_no_bit() {
    for blend in [Blend::Linear, Blend::Rigid] {
        let plain = project(blend);
        let zeros = displaced(&plain, Some(uniform(DVec2::ZERO)));
        let [(a, pose_a), (b, pose_b)] = [solved(&plain), solved(&zeros)];
        assert_eq!(a.posed_vertices(&pose_a), b.posed_vertices(&pose_b));
        assert_eq!(a.poser().to_bytes(), b.poser().to_bytes());
        assert_eq!(pixels(&a, &pose_a), pixels(&b, &pose_b));
    }
}

#[test]
fn single_handle_moves_a_uniform_displacement() {
    let by = DVec2::new(10.0, -5.0);
    for blend in [Blend::Linear, Blend::Rigid] {
        let handle = Handle::point("only", [70.0, 50.0]).posed_at([[90.0, 60.0]]).turned(90.0).scaled(1.5);
        let mut project = project(blend).with_handles([handle]);
        let (solution, pose) = solved(&project);
        let before: Vec<DVec2> = solution.posed_vertices(&pose);
        project.displacement = Some(uniform(by));
        let (solution, pose) = solved(&project);
        // A quarter turn with a scale of 1.5.
        let expected = 1.5 * DVec2::new(-by.y, by.x);
        for (before, after) in before.into_iter().zip(solution.posed_vertices(&pose)) {
            assert!((after - before).distance(expected) < 1e-9, "{before} to {after}");
        }
    }
}

#[test]
fn points_without_weights_are_displaced_and_the_background_stays() {
    let mut project = project(Blend::Linear).with_handles([]);
    project.displacement = Some(uniform(DVec2::new(10.0, 0.0)));
    let (solution, pose) = solved(&project);
    assert!(
        solution.map(&pose, DVec2::new(50.0, 50.0)).is_some_and(|at| at.posed.distance([60.0, 50.0].into()) < 1e-9)
    );
    let found = solution.rest_point(&pose, DVec2::new(60.0, 50.0)).expect("drawn");
    assert!(found.distance(DVec2::new(50.0, 50.0)) < 1e-6, "{found}");
}

#[test]
fn slopes_and_area_are_those_of_the_map() {
    for blend in [Blend::Linear, Blend::Rigid] {
        let project = displaced(&project(blend), Some(waves()));
        let (solution, pose) = solved(&project);
        let place = |p: DVec2| solution.map(&pose, p).expect("inside").posed;
        let step = 1e-5;
        for p in [[20.3, 31.7], [75.1, 66.2], [110.4, 90.9], [141.0, 20.2]].map(DVec2::from) {
            let slope = |axis: DVec2| (place(p + step * axis) - place(p - step * axis)) / (2.0 * step);
            let expected = DMat2::from_cols(slope(DVec2::X), slope(DVec2::Y)).determinant();
            let found = solution.map(&pose, p).expect("inside").det;
            assert!((found - expected).abs() < 1e-5, "{blend:?} at {p}: {found}, not {expected}");
        }
    }
}

#[test]
fn a_poser_keeps_its_displacement_in_its_bytes() {
    let project = displaced(&project(Blend::Rigid), Some(waves()));
    let (solution, pose) = solved(&project);
    let bytes = solution.poser().to_bytes();
    let poser = Poser::from_bytes(&bytes).expect("bytes of a poser");
    let again = poser.pose(&project.handles, Blend::Rigid).expect("a valid scene");
    assert_eq!(solution.posed_vertices(&again), solution.posed_vertices(&pose));
    for end in (0..bytes.len()).step_by(97) {
        assert!(Poser::from_bytes(&bytes[..end]).is_err(), "{end} bytes");
    }
}

#[test]
fn changed_displacement_needs_no_solve() {
    let rgba = rgba();
    let picture = Picture::new(160, 120, &rgba).expect("a picture");
    let mut solver = Solver::new();
    let mut stages = |project: &Project| {
        solver.begin(project, &picture).expect("a valid scene");
        let stages: Vec<Stage> = std::iter::from_fn(|| solver.advance().expect("a valid scene")).collect();
        assert!(solver.has_solved(project));
        let solution = solver.solution().expect("solved").clone();
        (stages, solution.posed_vertices(&solution.pose(project).expect("a valid scene")))
    };
    let plain = project(Blend::Rigid).with_editor_settings();
    assert_eq!(plain.pose.mode, PoseMode::Rigid);
    let (all, _) = stages(&plain);
    assert!(all.len() > 1);
    for displacement in [Some(waves()), Some(uniform(DVec2::ONE)), None] {
        let project = displaced(&plain, displacement);
        let (one, posed) = stages(&project);
        assert_eq!(one, [Stage::Weights]);
        let (solution, pose) = solved(&project);
        assert!(posed == solution.posed_vertices(&pose));
    }
}

#[test]
fn a_posed_picture_is_displaced_as_a_solution_of_the_project() {
    for blend in [Blend::Linear, Blend::Rigid] {
        let plain = project(blend);
        let [(of_plain, _), (of_displaced, pose)] = [solved(&plain), solved(&displaced(&plain, Some(waves())))];
        let expected = of_displaced.posed_vertices(&pose);
        let mut picture = posed_picture(&plain, of_plain.poser().clone());
        picture.set_displacement(Some(&waves())).expect("a grid");
        assert_eq!(picture.posed_vertices(), &*of_displaced.displaced_vertices());
        let poses: Vec<HandlePose> = plain.handles.iter().map(HandlePose::from).collect();
        picture.set_pose(&poses, blend).expect("a valid scene");
        assert_eq!(picture.posed_vertices(), expected);
        picture.set_displacement(None).expect("none");
        assert_eq!(picture.displaced_vertices(), of_plain.vertices());
        picture.set_displacement(Some(&waves())).expect("a grid");
        assert_eq!(picture.posed_vertices(), expected);
        let place = picture.map(DVec2::new(70.0, 50.0)).expect("inside").posed;
        assert!(picture.locate(place).expect("drawn").rest.distance(DVec2::new(70.0, 50.0)) < 1e-6);
        let wrong = picture.set_displacement(Some(&Displacement::new(5, 5, vec![0; 49]))).unwrap_err();
        assert_eq!(wrong.to_string(), "displacement.values: expected 5 × 5 × 2 numbers, found 49");
        assert_eq!(picture.posed_vertices(), expected);
        // The bytes of a poser bring their displacement.
        let again = posed_picture(&plain, of_displaced.poser().clone());
        assert_eq!(again.posed_vertices(), &*of_displaced.displaced_vertices());
    }
}

#[test]
fn a_sprite_mesh_is_displaced_and_its_background_stays() {
    let Scene { mut project, picture } = Scene::named("portrait");
    let size = [picture.width(), picture.height()].map(f64::from);
    project.displacement = Some(Displacement::new(4, 4, [2, 0].repeat(16)));
    let picture = Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene");
    let solution = solve(&project, &picture).expect("a valid scene");
    let mesh = SpriteMesh::new(&solution, &picture, 400).expect("enough vertices");
    let by = DVec2::new(2.0 / 256.0 * size[0], 0.0);
    let moved = mesh.displaced_vertices().iter().zip(mesh.vertices()).filter(|(a, b)| (**a - **b).distance(by) < 1e-9);
    let stayed = mesh.displaced_vertices().iter().zip(mesh.vertices()).filter(|(a, b)| a == b);
    let (moved, stayed) = (moved.count(), stayed.count());
    assert!(moved > 20 && moved + stayed == mesh.vertices().len(), "{moved} and {stayed}");
    assert_eq!(stayed > 0, !solution.static_background().triangles().is_empty());
}

#[test]
fn a_point_cloud_refuses_a_displacement() {
    let points: Vec<DVec2> = (0..100).map(|k| DVec2::new(f64::from(k % 10), f64::from(k / 10)) * 15.0).collect();
    let project = displaced(&project(Blend::Linear), Some(waves()));
    let error = solve_cloud(&project, &PointCloud::new(points, 8).expect("points")).unwrap_err();
    assert!(error.to_string().contains("displacement"), "{error}");
}

#[test]
fn warped_pixels_are_those_of_the_displaced_points() {
    let project = displaced(&project(Blend::Linear).with_handles([]), Some(uniform(DVec2::new(20.0, 0.0))));
    let (solution, pose) = solved(&project);
    let rgba = rgba();
    let options = ResampleOptions { filter: Filter::Nearest, ..ResampleOptions::default() };
    let picture = Picture::new(160, 120, &rgba).expect("a picture");
    let warped = solution.warped(&picture, &pose, options).expect("a valid scene");
    assert_eq!(warped.width, 160);
    let at = |pixels: &[u8], x: usize| pixels[4 * (60 * 160 + x)..][..4].to_vec();
    assert_eq!(at(&warped.rgba, 90), at(&rgba, 70));
}
