//! Baked rigs: accuracy, size, and damaged files.

use c2warp::{
    Picture, ResampleOptions, Solution,
    clip::Playback,
    deform::HandlePose,
    pose::Motion,
    project::{Blend, Clip, Displacement, Ease, Handle, Key, Looping, PoseMode, Project, Rotation, Track},
    raster,
    rig::{BakeError, Posable, Rig, RigClip, RigPicture},
    solve,
    weight::SparseWeights,
};
use c2warp_tests::{Random, Scene};
use glam::DVec2;

use crate::scenes::area_ratios;

/// Pixels.
const CLOSE: f64 = 0.1;

/// A scene whose handles go from rest to their pose and back.
fn moving(scene: &str, mode: PoseMode, blend: Blend) -> (Project, Solution) {
    moving_as(scene, mode, blend, false)
}

fn moving_as(scene: &str, mode: PoseMode, blend: Blend, fix_boundary: bool) -> (Project, Solution) {
    let Scene { mut project, picture } = Scene::named(scene);
    let track = |handle: &Handle| {
        let key = |time, posed: &[DVec2]| Key::new(time, Ease::Smooth).posed_at(posed.iter().copied());
        Track::new(&handle.id, [key(0.0, handle.shape.rest()), key(0.6, handle.shape.posed())])
    };
    let tracks: Vec<Track> = project.handles.iter().map(track).collect();
    let still = Clip::new("still", 2.0, Looping::None);
    project.clips = vec![Clip::new("wave", 1.2, Looping::Repeat).with_tracks(tracks), still];
    (project.pose.mode, project.pose.blend, project.fix_boundary) = (mode, blend, fix_boundary);
    let picture = Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene");
    let solution = solve(&project, &picture).expect("a valid scene");
    (project, solution)
}

fn baked(project: &Project, solution: &Solution) -> Rig {
    let picture = RigPicture { width: project.image.width, height: project.image.height, file: b"a picture".to_vec() };
    Rig::bake(project, solution, picture).expect("a valid scene")
}

/// The maximum distance of a corner of the rig from its place.
fn distance(solution: &Solution, rig: &Rig, found: &[DVec2], exact: &[DVec2]) -> f64 {
    let behind = solution.static_background().triangles().len();
    let corners = rig.triangles()[behind..].iter().flatten().zip(solution.triangles().iter().flatten());
    corners.map(|(&a, &b)| found[a as usize].distance(exact[b as usize])).fold(0.0, f64::max)
}

/// The same in all frames of a clip, which must be those of [`Playback`].
fn errors_along(project: &Project, solution: &Solution, rig: &Rig, clip: usize) -> Vec<f64> {
    let (known, played) = (&project.clips[clip], &rig.clips()[clip]);
    let mut playback = Playback::new(solution.poser().clone(), known.clone(), project.handles.clone());
    let mut error_at = |frame: u32| {
        let time = known.duration * f64::from(frame) / f64::from(played.last_frame);
        let exact = solution.posed_vertices(&playback.pose(time, project.pose.blend).expect("a valid scene"));
        distance(solution, rig, &rig.posed_vertices(clip, f64::from(frame)), &exact)
    };
    (0..=played.last_frame).map(&mut error_at).collect()
}

#[test]
fn vertices_of_a_displaced_picture_stay_close() {
    let Scene { mut project, picture } = Scene::named("portrait");
    project.displacement = Some(Displacement::new(5, 4, (0..40).map(|k| 9 * (k % 7) - 20).collect()));
    let picture = Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene");
    let solution = solve(&project, &picture).expect("a valid scene");
    let exact = solution.posed_vertices(&solution.pose(&project).expect("a valid scene"));
    let rig = baked(&project, &solution);
    let read = Rig::from_bytes(&rig.to_bytes().expect("a valid scene")).expect("a valid scene");
    assert!(read == rig);
    assert!(distance(&solution, &read, &read.posed_vertices(0, 0.0), &exact) <= CLOSE);
    assert!(distance(&solution, &read, &read.vertices(), solution.vertices()) <= CLOSE);
    assert!(distance(&solution, &read, &read.displaced_vertices(), &solution.displaced_vertices()) <= CLOSE);
}

#[test]
fn vertices_stay_close_in_all_frames_and_files_are_small() {
    for (scene, mode, blend) in [
        ("strip", PoseMode::Harmonic, Blend::Linear),
        ("gingerbread", PoseMode::Rigid, Blend::Rigid),
        ("gingerbread", PoseMode::Harmonic, Blend::Rigid),
        ("moth", PoseMode::Rigid, Blend::Linear),
        ("road", PoseMode::Harmonic, Blend::Linear),
        ("portrait", PoseMode::Rigid, Blend::Rigid),
        ("islands", PoseMode::Rigid, Blend::Rigid),
        ("fold", PoseMode::Rigid, Blend::Rigid),
    ] {
        let (project, solution) = moving(scene, mode, blend);
        let rig = baked(&project, &solution);
        let file = rig.to_bytes().expect("a valid scene");
        assert!(Rig::from_bytes(&file).expect("a valid scene") == rig, "{scene}");
        for clip in 0..rig.clips().len() {
            for (frame, error) in errors_along(&project, &solution, &rig, clip).into_iter().enumerate() {
                assert!(error <= CLOSE, "{scene}: {error} px at frame {frame}");
            }
        }
        let keys: usize = rig.clips().iter().map(RigClip::keys).sum();
        let bar = rig.picture().file.len() * 13 / 10 + 20 * rig.vertices().len() + 24 * rig.sites() * keys;
        assert!(
            file.len() <= bar,
            "{scene}: {} bytes, not {bar}: {} vertices, {} sites, {keys} keys",
            file.len(),
            rig.vertices().len(),
            rig.sites()
        );
    }
}

/// Handles posed at random: up to half the longer side away, a quarter turn, and half or twice the size.
fn posed_at_random(handles: &[Handle], reach: f64, random: &mut Random) -> Vec<Handle> {
    let mut between = |least: f64, most: f64| least + (most - least) * random.unit();
    let pose = |handle: &Handle| {
        let mut posed = handle.clone();
        for (place, rest) in posed.shape.posed_mut().iter_mut().zip(handle.shape.rest()) {
            *place = rest + between(0.0, reach) * DVec2::from_angle(between(0.0, 7.0));
        }
        posed.rotation = between(-90.0, 90.0).into();
        posed.scale = between(-1.0, 1.0).exp2();
        posed
    };
    handles.iter().map(pose).collect()
}

#[test]
fn handles_are_posed_without_a_solver_in_the_harmonic_mode() {
    let mut random = Random(7);
    for (scene, blend, fix_boundary) in [
        ("strip", Blend::Linear, false),
        ("gingerbread", Blend::Rigid, false),
        ("gingerbread", Blend::Linear, true),
        ("islands", Blend::Linear, false),
        ("fold", Blend::Rigid, false),
        ("tower", Blend::Linear, false),
        ("portrait", Blend::Rigid, false),
        ("road", Blend::Linear, false),
    ] {
        let (mut project, solution) = moving_as(scene, PoseMode::Harmonic, blend, fix_boundary);
        let rig = baked(&project, &solution);
        let rig = Rig::from_bytes(&rig.to_bytes().expect("a valid scene")).expect("a valid scene");
        let handles = rig.handles().expect("the harmonic mode").to_vec();
        assert_eq!(handles, project.handles, "{scene}");
        let reach = f64::from(project.image.width.max(project.image.height)) / 2.0;
        for pose in 0..12 {
            project.handles = posed_at_random(&handles, reach, &mut random);
            if pose == 0 {
                // Bars without a length do not collapse the parts that they move.
                project.handles.iter_mut().for_each(|handle| {
                    let [first, others @ ..] = handle.shape.posed_mut() else {
                        unreachable!("every handle has a place")
                    };
                    others.fill(*first);
                });
            }
            let exact = solution.posed_vertices(&solution.pose(&project).expect("a valid scene"));
            let found = rig.vertices_posed_by(&project.handles).expect("the same handles");
            let error = distance(&solution, &rig, &found, &exact);
            assert!(error <= CLOSE, "{scene}: {error} px in pose {pose}");
        }
        assert_eq!(rig.vertices_posed_by(&handles[1..]), None);
    }
}

#[test]
fn rigs_of_the_rigid_mode_are_posable_only_if_wanted() {
    let (mut project, solution) = moving("gingerbread", PoseMode::Rigid, Blend::Linear);
    assert_eq!(baked(&project, &solution).handles(), None);
    let rig = baked_posable(&project, &solution);
    assert_eq!((rig.handles(), rig.vertices_posed_by(&project.handles)), (Some(&project.handles[..]), None));
    // A point with automatic rotation also needs the solver.
    let (_, solution) = moving("gingerbread", PoseMode::Harmonic, Blend::Linear);
    assert!(baked(&project, &solution).handles().is_some());
    assert!(baked_posable(&project, &solution).poser().is_none());
    project.handles[0].rotation = Rotation::Auto;
    assert_eq!(baked(&project, &solution).handles(), None);
    assert!(baked_posable(&project, &solution).poser().is_some());
}

fn baked_posable(project: &Project, solution: &Solution) -> Rig {
    let picture = RigPicture { width: project.image.width, height: project.image.height, file: b"a picture".to_vec() };
    let rig = Rig::bake_with_progress(project, solution, picture, Posable::Always, &mut |_| {}).expect("a valid scene");
    let read = Rig::from_bytes(&rig.to_bytes().expect("a valid scene")).expect("a valid scene");
    assert!(read == rig);
    read
}

/// The number of triangles that a pose turns over.
fn folded(solution: &Solution, posed: &[DVec2]) -> usize {
    area_ratios(solution, posed).into_iter().filter(|&ratio| ratio < 0.0).count()
}

/// Drags of each handle by a fraction of the longer side that hardly fold anything: the greatest errors, in pixels,
/// from the largest.
fn errors_of_drags(project: &mut Project, solution: &Solution, rig: &Rig, reach: f64) -> Vec<f64> {
    let poser = rig.poser().expect("a rig with a solver");
    let handles = rig.handles().expect("a rig that is posable").to_vec();
    assert_eq!(handles, project.handles);
    let reach = reach * f64::from(project.image.width.max(project.image.height));
    let known = folded(solution, &solution.posed_vertices(&solution.pose(project).expect("a valid scene")));
    let mut errors = Vec::new();
    for handle in 0..handles.len() {
        for direction in 0..4 {
            project.handles = handles.clone();
            let by = reach * DVec2::from_angle(f64::from(direction) * 1.6 + 0.3);
            project.handles[handle].shape.posed_mut().iter_mut().for_each(|place| *place += by);
            let exact = solution.posed_vertices(&solution.pose(project).expect("a valid scene"));
            // A picture that is forced to fold has many poses of nearly the same energy.
            if folded(solution, &exact) > known + 10 {
                continue;
            }
            let poses: Vec<HandlePose> = project.handles.iter().map(HandlePose::from).collect();
            let motions = poser.motions(&poses).expect("the same handles");
            errors.push(distance(solution, rig, &rig.vertices_posed_with(&motions), &exact));
        }
    }
    project.handles = handles;
    assert!(
        errors.len() >= 2 * project.handles.len(),
        "{} px: {} drags fold hardly anything: {errors:?}",
        project.image.width,
        errors.len()
    );
    errors.sort_by(|a, b| b.total_cmp(a));
    errors
}

#[test]
fn handles_are_posed_by_the_solver_in_the_rigid_mode() {
    for (scene, blend, fix_boundary, reach, most) in [
        ("gingerbread", Blend::Rigid, false, 0.1, 0.5),
        ("strip", Blend::Linear, false, 0.1, 0.5),
        ("islands", Blend::Rigid, false, 0.1, 0.5),
        ("tower", Blend::Linear, false, 0.1, 0.5),
        // Its handles are close to one another, and to the held outline.
        ("portrait", Blend::Rigid, false, 0.02, 0.5),
        // Its handles force folds even before they are dragged.
        ("road", Blend::Linear, true, 0.05, 1.0),
    ] {
        let (mut project, solution) = moving_as(scene, PoseMode::Rigid, blend, fix_boundary);
        let rig = baked_posable(&project, &solution);
        // Next to where the pose from rest jumps, or a triangle is nearly flat, it may end a little elsewhere.
        let errors = errors_of_drags(&mut project, &solution, &rig, reach);
        assert!(errors[0] <= most && errors[errors.len() / 4] <= CLOSE, "{scene}: {errors:?}");
    }
}

#[test]
fn drags_of_a_rig_are_those_of_its_project() {
    let (mut project, solution) = moving("gingerbread", PoseMode::Rigid, Blend::Linear);
    let rig = baked_posable(&project, &solution);
    let poser = rig.poser().expect("the rigid mode");
    let rest = project.handles[0].shape.rest()[0];
    let numbers = |project: &Project| project.handles.iter().map(HandlePose::from).collect::<Vec<_>>();
    let mut exact = solution.pose(&project).expect("a valid scene");
    let mut found = poser.motions(&numbers(&project)).expect("the same handles");
    for step in 0..20 {
        project.handles[0].shape.posed_mut()[0] = rest + 2.0 * f64::from(step) * DVec2::new(0.8, 0.6);
        exact = solution.poser().follow(&exact, &project.handles).expect("a valid scene");
        found = poser.followed(&found, &numbers(&project)).expect("the same handles");
        let error = distance(&solution, &rig, &rig.vertices_posed_with(&found), &solution.posed_vertices(&exact));
        assert!(error <= CLOSE, "{error} px in step {step}");
    }
    let exact = solution.poser().settle(&exact, &project.handles).expect("a valid scene");
    let settled = poser.settled(&found, &numbers(&project)).expect("the same handles");
    let error = distance(&solution, &rig, &rig.vertices_posed_with(&settled), &solution.posed_vertices(&exact));
    assert!(error <= CLOSE, "{error} px at rest");
}

#[test]
fn frames_before_of_another_rig_are_refused() {
    let (project, solution) = moving("gingerbread", PoseMode::Rigid, Blend::Rigid);
    let poser = baked_posable(&project, &solution).poser().expect("the rigid mode");
    let poses: Vec<HandlePose> = project.handles.iter().map(HandlePose::from).collect();
    let before = poser.motions(&poses).expect("the same handles");
    assert!(poser.followed(&before[1..], &poses).is_err() && poser.settled(&[], &poses).is_err());
    let both = |number: usize, value: f64| {
        let mut before = before.clone();
        let mut numbers = before[0].numbers();
        numbers[number] = value;
        before[0] = Motion::from_numbers(&numbers);
        [poser.followed(&before, &poses), poser.settled(&before, &poses)]
    };
    for number in 0..7 {
        assert!(
            [f64::NAN, f64::INFINITY].into_iter().flat_map(|value| both(number, value)).all(|found| found.is_err())
        );
        let mut found = both(number, 1e300).into_iter().chain(both(number, -1e300)).flatten().flatten();
        assert!(
            found.all(|motion| motion.numbers().into_iter().all(f64::is_finite)),
            "motion component {number} is not finite"
        );
    }
}

#[test]
fn meshes_of_another_rig_are_refused() {
    let (project, solution) = moving("gingerbread", PoseMode::Rigid, Blend::Rigid);
    let mut poser = baked_posable(&project, &solution).poser().expect("the rigid mode");
    let places = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let weights = |site, weight| SparseWeights::from_parts(vec![0, 1, 2, 3], vec![site; 3], vec![weight; 3]);
    let weights = |site, weight| weights(site, weight).expect("three rows");
    assert!(poser.set_mesh(&places, &[[0, 1, 2]], &weights(0, 1.0)).is_ok());
    assert!(poser.set_mesh(&places[1..], &[], &weights(0, 1.0)).is_err());
    assert!(poser.set_mesh(&places, &[[0, 1, 3]], &weights(0, 1.0)).is_err());
    assert!(poser.set_mesh(&places, &[[0, 1, 2]], &weights(9999, 1.0)).is_err());
    assert!(poser.set_mesh(&places, &[[0, 1, 2]], &weights(0, f64::NAN)).is_err());
    assert!(poser.set_mesh(&[DVec2::NAN; 3], &[[0, 1, 2]], &weights(0, 1.0)).is_err());
}

#[test]
fn automatic_rotations_are_posed_by_the_solver() {
    for (scene, mode) in
        [("gingerbread", PoseMode::Harmonic), ("gingerbread", PoseMode::Rigid), ("tower", PoseMode::Rigid)]
    {
        let (mut project, solution) = moving(scene, mode, Blend::Rigid);
        project.handles.iter_mut().for_each(|handle| handle.rotation = Rotation::Auto);
        let rig = baked_posable(&project, &solution);
        let errors = errors_of_drags(&mut project, &solution, &rig, 0.1);
        assert!(errors[0] <= CLOSE, "{scene}: {errors:?}");
    }
}

/// Published rigs stay readable. Their poses are those of the present solver.
fn expect_published(file: &[u8], places: &str) {
    let rig = Rig::from_bytes(file).expect("a rig");
    let poser = rig.poser().expect("the rigid mode");
    let mut poses: Vec<HandlePose> = poser.handles().iter().map(HandlePose::from).collect();
    assert_eq!(poses.iter().map(|pose| pose.posed.len()).collect::<Vec<_>>(), [1, 3, 4]);
    assert_eq!(poses[0].rotation, Rotation::Auto);
    poses[0].posed = vec![[7.0, 12.0].into()];
    poses[1].posed = [[14.0, 4.0], [20.0, 3.0], [26.0, 4.0]].map(DVec2::from).to_vec();
    let found = rig.vertices_posed_with(&poser.motions(&poses).expect("a pose"));
    let place = |line: &str| {
        let (x, y) = line.split_once(',').expect("two numbers");
        DVec2::new(x.parse().expect("a number"), y.parse().expect("a number"))
    };
    let expected: Vec<DVec2> = places.lines().skip(1).map(place).collect();
    assert_eq!(found.len(), expected.len());
    let errors: Vec<f64> = found.iter().zip(&expected).map(|(a, b)| a.distance(*b)).collect();
    assert!(errors.iter().all(|&error| error <= CLOSE), "{errors:?}");
}

#[test]
fn published_rig_of_format_1_is_posed() {
    // Its solver has changed since it was baked. The places are those of the present one.
    expect_published(
        include_bytes!("../../../web/src/player/fixtures/solved.c2rig"),
        include_str!("../../../web/src/player/fixtures/solved.csv"),
    );
}

#[test]
fn published_rig_of_format_2_is_posed_as_its_project() {
    // Inside the outline, the places are within 0.02 px of those of its project by `c2warp map`.
    expect_published(
        include_bytes!("../../../web/src/player/fixtures/solved_2.c2rig"),
        include_str!("../../../web/src/player/fixtures/solved_2.csv"),
    );
}

#[test]
fn poses_of_other_handles_are_refused() {
    let (project, solution) = moving("gingerbread", PoseMode::Rigid, Blend::Rigid);
    let poser = baked_posable(&project, &solution).poser().expect("the rigid mode");
    let mut poses: Vec<HandlePose> = project.handles.iter().map(HandlePose::from).collect();
    assert!(poser.motions(&poses[1..]).is_err());
    poses[0].posed.push(DVec2::ZERO);
    assert!(poser.motions(&poses).is_err());
    poses[0].posed = vec![DVec2::NAN];
    assert!(poser.motions(&poses).is_err());
}

/// The mean difference of the rig's picture from that of the solution, in steps of 255.
fn mean_difference(project: &Project, solution: &Solution, rig: &Rig, frame: u32) -> f64 {
    let picture = Scene::named("gingerbread").picture;
    let picture = Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene");
    let (known, played) = (&project.clips[0], &rig.clips()[0]);
    let mut project = project.clone();
    known.apply(known.duration * f64::from(frame) / f64::from(played.last_frame), &mut project.handles);
    let options = ResampleOptions { edges: false, ..ResampleOptions::default() };
    let exact =
        solution.warped(&picture, &solution.pose(&project).expect("a valid scene"), options).expect("a valid scene");
    let order = rig.drawing_order(0, f64::from(frame));
    let triangles: Vec<[u32; 3]> = order.iter().map(|&t| rig.triangles()[t as usize]).collect();
    let posed = rig.posed_vertices(0, f64::from(frame));
    let drawn = raster::warp(&picture, &rig.vertices(), &posed, &triangles, options).expect("a valid scene");
    let difference = |(a, b): (&u8, &u8)| f64::from(a.abs_diff(*b));
    exact.rgba.iter().zip(&drawn.rgba).map(difference).sum::<f64>() / exact.rgba.len() as f64
}

#[test]
fn parts_that_cross_are_drawn_in_order() {
    let Scene { mut project, picture } = Scene::named("gingerbread");
    let swing = |hand: &str, across: [f64; 2], depth: [f64; 2]| {
        let rest = project.handles.iter().find(|handle| handle.id == hand).expect("a valid scene").shape.rest()[0];
        let key = |time, place: DVec2, depth| Key::new(time, Ease::Smooth).posed_at([place]).at_depth(depth);
        Track::new(hand, [key(0.0, rest, depth[0]), key(0.5, across.into(), depth[1])])
    };
    for depths in [[1.0, 1.0], [1.0, -1.0]] {
        let tracks = [swing("left-hand", [110.0, 110.0], depths), swing("right-hand", [70.0, 112.0], [0.0; 2])];
        project.clips = vec![Clip::new("cross", 1.0, Looping::Alternate).with_tracks(tracks)];
        (project.pose.mode, project.pose.blend) = (PoseMode::Rigid, Blend::Rigid);
        let solution =
            solve(&project, &Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene"))
                .expect("a valid scene");
        let rig = baked(&project, &solution);
        let bytes = rig.to_bytes().expect("a valid scene").len();
        assert!(bytes < 20 * rig.vertices().len() + 24 * rig.sites() * rig.clips()[0].keys(), "{bytes} bytes");
        for frame in 0..=rig.clips()[0].last_frame {
            let difference = mean_difference(&project, &solution, &rig, frame);
            assert!(difference < 0.25, "{depths:?}: {difference} at frame {frame}");
        }
    }
}

#[test]
fn a_project_without_clips_has_its_pose() {
    let Scene { project, .. } = Scene::named("gingerbread");
    let (_, solution) = moving("gingerbread", PoseMode::Harmonic, Blend::Linear);
    let rig = baked(&project, &solution);
    let [still] = rig.clips() else { panic!("{} clips", rig.clips().len()) };
    assert_eq!((still.name.as_str(), still.duration, still.last_frame), ("", 0.0, 0));
    let exact = solution.posed_vertices(&solution.pose(&project).expect("a valid scene"));
    let found = rig.posed_vertices(0, 0.0);
    let corners = rig.triangles().iter().flatten().zip(solution.triangles().iter().flatten());
    corners.for_each(|(&a, &b)| assert!(found[a as usize].distance(exact[b as usize]) <= CLOSE));
}

#[test]
fn a_project_without_handles_is_its_picture() {
    let Scene { project, picture } = Scene::named("untouched");
    let picture = Picture::new(picture.width(), picture.height(), picture.as_raw()).expect("a valid scene");
    let rig = baked(&project, &solve(&project, &picture).expect("a valid scene"));
    assert_eq!((rig.triangles().len(), rig.sites()), (2, 0));
    assert_eq!(rig.posed_vertices(0, 0.0), rig.vertices());
    assert_eq!(Rig::from_bytes(&rig.to_bytes().expect("a valid scene")).expect("a valid scene"), rig);
}

#[test]
fn clips_that_cannot_be_baked_are_named() {
    let (mut project, solution) = moving("strip", PoseMode::Harmonic, Blend::Linear);
    let bake = |project: &Project| {
        let picture = RigPicture { width: 96, height: 48, file: Vec::new() };
        Rig::bake(project, &solution, picture).unwrap_err()
    };
    project.clips[1].duration = 601.0;
    assert!(matches!(bake(&project), BakeError::ClipTooLong { clip, .. } if clip == "still"));
    project.clips = (0..300).map(|k| Clip::new(format!("{k}"), 600.0, Looping::None)).collect();
    assert!(matches!(bake(&project), BakeError::TooManyMotions { frames: 10_800_300, .. }));
    let (mut project, solution) = moving("strip", PoseMode::Harmonic, Blend::Linear);
    let bake = |project: &Project| {
        let picture = RigPicture { width: 96, height: 48, file: Vec::new() };
        Rig::bake(project, &solution, picture).unwrap_err()
    };
    project.clips[1].duration = 1.0;
    project.clips[0].tracks[0].keys[1].posed = Some(vec![DVec2::splat(1e11)]);
    assert_eq!(bake(&project).to_string(), "clip \"wave\": handles move too far for a rig");
    project.clips[0].tracks[0].keys[1].posed = Some(vec![DVec2::splat(1e13)]);
    assert!(matches!(bake(&project), BakeError::Pose { clip, .. } if clip == "wave"));
}
