//! The rigid pose mode: it needs no rotations, keeps handles in place, and bends with little distortion.

use c2warp::{
    Error, Solution,
    deform::Pose,
    project::{Blend, PoseMode, Project, Rotation, Shape, Support},
};
use glam::{DMat2, DVec2};

use crate::{
    handles::{bar, point_handle},
    scenes::{project, solved, spread},
};

/// A project whose handles rest and go, with rotations left to the solver.
fn posed(rings: &[Vec<DVec2>], moves: &[(DVec2, DVec2)], mode: PoseMode) -> Project {
    let places: Vec<DVec2> = moves.iter().map(|&(rest, _)| rest).collect();
    let mut project = project(rings, &places, Support::Smooth);
    (project.pose.mode, project.pose.density) = (mode, 60);
    project.handles = moves.iter().enumerate().map(|(id, &(rest, posed))| point_handle(id, rest, posed, 0.0)).collect();
    for handle in &mut project.handles {
        handle.rotation = Rotation::Auto;
    }
    project
}

fn pose_of(project: &Project) -> (Solution, Pose) {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    (solution, pose)
}

/// A strip of 320 by 80 px, bent upwards in the middle by three pins.
fn bent_strip(mode: PoseMode) -> Project {
    let ring = [(40.0, 160.0), (360.0, 160.0), (360.0, 240.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let moves = [((60.0, 200.0), (90.0, 250.0)), ((200.0, 200.0), (200.0, 150.0)), ((340.0, 200.0), (310.0, 250.0))];
    posed(&[ring], &moves.map(|(rest, to)| (rest.into(), to.into())), mode)
}

/// What the energy of a point counts for at most, as where a point is squeezed to a tenth, and that of one that is turned over.
const MOST_ENERGY: f64 = 100.0;

/// |J|² + |J⁻¹|² − 4 all over the domain, ascending: the symmetric Dirichlet energy, 0 for a rigid motion.
fn distortion(solution: &Solution, pose: &Pose) -> Vec<f64> {
    let step = 1e-3;
    let at = |p: DVec2| solution.map(pose, p).map(|mapped| mapped.posed);
    let mut energies: Vec<f64> = spread(4000)
        .filter_map(|p| {
            let [right, left, down, up] =
                [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|axis| at(p + step * axis));
            let jacobian = DMat2::from_cols((right? - left?) / (2.0 * step), (down? - up?) / (2.0 * step));
            let square = |m: DMat2| m.x_axis.length_squared() + m.y_axis.length_squared();
            let energy = square(jacobian) + square(jacobian.inverse()) - 4.0;
            Some(if jacobian.determinant() > 0.0 { energy.min(MOST_ENERGY) } else { MOST_ENERGY })
        })
        .collect();
    assert!(energies.len() > 300);
    energies.sort_by(f64::total_cmp);
    energies
}

fn mean(energies: &[f64]) -> f64 {
    energies.iter().sum::<f64>() / energies.len() as f64
}

#[test]
fn a_strip_bends_by_three_pins_with_a_fraction_of_the_harmonic_modes_distortion() {
    let [harmonic, rigid] = [PoseMode::Harmonic, PoseMode::Rigid].map(|mode| {
        let (solution, pose) = pose_of(&bent_strip(mode));
        let energies = distortion(&solution, &pose);
        [mean(&energies), energies[energies.len() / 2], energies[energies.len() * 9 / 10], energies[energies.len() - 1]]
    });
    eprintln!("symmetric Dirichlet energy, mean, median, 90 % and most: harmonic {harmonic:.3?}, rigid {rigid:.3?}");
    assert!(rigid[0] < 0.18 && rigid[1] < 0.09 && rigid[2] < 0.4, "{rigid:?}");
    assert!(rigid[0] < harmonic[0] / 7.0 && rigid[2] < harmonic[2] / 5.0, "{rigid:?} and {harmonic:?}");
    assert!(rigid[3] < MOST_ENERGY, "folds, or nearly: {rigid:?}");
}

/// A cross of 320 px with its ends held and its middle, four handles, turned by 90°.
fn twisted_cross(mode: PoseMode) -> Project {
    let middle = DVec2::splat(200.0);
    let quarter = |k: usize| DVec2::from_angle(std::f64::consts::FRAC_PI_2 * k as f64);
    let arm = [(-40.0, -40.0), (-40.0, -160.0), (40.0, -160.0)].map(DVec2::from);
    let ring = (0..4).flat_map(|k| arm.map(|p| (middle + quarter(k).rotate(p)).round())).collect();
    let place = |k: usize, far: f64| (middle + quarter(k).rotate(DVec2::new(0.0, -far))).round();
    let ends = (0..4).map(|k| (place(k, 145.0), place(k, 145.0)));
    let turned = (0..4).map(|k| (place(k, 30.0), place(k + 1, 30.0)));
    posed(&[ring], &ends.chain(turned).collect::<Vec<_>>(), mode)
}

#[test]
fn a_cross_is_twisted_by_90_degrees_without_folds() {
    let [harmonic, rigid] = [PoseMode::Harmonic, PoseMode::Rigid].map(|mode| {
        let mut project = twisted_cross(mode);
        project.pose.density = 100;
        let (solution, pose) = pose_of(&project);
        distortion(&solution, &pose)
    });
    eprintln!("mean symmetric Dirichlet energy: harmonic {:.3}, rigid {:.3}", mean(&harmonic), mean(&rigid));
    assert!(rigid[rigid.len() - 1] < MOST_ENERGY, "{}", rigid[rigid.len() - 1]);
    assert!(mean(&rigid) < 1.0 && mean(&rigid) < mean(&harmonic) / 5.0, "{} and {}", mean(&rigid), mean(&harmonic));
}

fn point(shape: &Shape) -> (DVec2, DVec2) {
    let Shape::Point { rest, posed } = shape else { unreachable!("all are points") };
    (*rest, *posed)
}

#[test]
fn a_drag_is_followed_without_jumps() {
    const STEP: f64 = 0.05;
    for density in [0, 100] {
        let mut project = bent_strip(PoseMode::Rigid);
        project.pose.density = density;
        let solution = solved(&project).expect("a valid scene");
        let places = |project: &Project| -> Vec<DVec2> {
            let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
            solution.sites().iter().enumerate().map(|(at, site)| pose.moved(at, site.rest)).collect()
        };
        let mut before = places(&project);
        let mut worst = 0.0_f64;
        for _ in 0..100 {
            let Shape::Point { posed, .. } = &mut project.handles[1].shape else { unreachable!("all are points") };
            *posed += STEP * DVec2::new(0.6, -0.8);
            let after = places(&project);
            worst = after.iter().zip(&before).map(|(after, before)| after.distance(*before)).fold(worst, f64::max);
            before = after;
        }
        eprintln!("what moves most moves {:.1} times as far as the handle", worst / STEP);
        // A part that is bent by a lever moves farther than the handle; a jump would be of pixels, not of hundredths.
        assert!(worst < 0.5, "{worst} px");
    }
}

#[test]
fn a_cross_is_followed_without_jumps_to_its_last_degree() {
    let mut project = twisted_cross(PoseMode::Rigid);
    project.pose.density = 100;
    let solution = solved(&project).expect("a valid scene");
    let ends: Vec<(DVec2, DVec2)> = project.handles.iter().map(|handle| point(&handle.shape)).collect();
    let mut before = Vec::new();
    let (mut worst, mut farthest) = (0.0_f64, 0.0_f64);
    for step in 0..=200 {
        for (handle, &(rest, to)) in project.handles.iter_mut().zip(&ends) {
            handle.shape = Shape::Point { rest, posed: rest.lerp(to, f64::from(step) / 200.0) };
            farthest = farthest.max(rest.distance(to) / 200.0);
        }
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
        let after = solution.posed_vertices(&pose);
        worst = after.iter().zip(&before).map(|(after, before)| after.distance(*before)).fold(worst, f64::max);
        before = after;
    }
    eprintln!("what moves most moves {:.1} times as far as the handles", worst / farthest);
    // Twice as far is what it takes; a jump is of tens.
    assert!(worst < 5.0 * farthest, "{worst} px");
}

#[test]
fn handles_go_where_they_are_taken() {
    let project = bent_strip(PoseMode::Rigid);
    let (solution, pose) = pose_of(&project);
    for (rest, to) in [((60.0, 200.0), (90.0, 250.0)), ((200.0, 200.0), (200.0, 150.0))] {
        let mapped = solution.map(&pose, rest.into()).expect("inside");
        assert!(mapped.posed.distance(to.into()) <= 1e-6);
    }
}

#[test]
fn a_turned_scene_is_turned_whole() {
    let turn = |p: DVec2| DVec2::splat(200.0) + DVec2::from_angle(0.9).rotate(p - 200.0) + DVec2::new(5.0, -9.0);
    let ring = [(40.0, 160.0), (360.0, 160.0), (330.0, 300.0), (200.0, 220.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let places = [(60.0, 200.0), (200.0, 200.0), (320.0, 270.0)].map(DVec2::from);
    let (solution, pose) = pose_of(&posed(&[ring], &places.map(|p| (p, turn(p))), PoseMode::Rigid));
    for p in spread(500) {
        if let Some(mapped) = solution.map(&pose, p) {
            assert!(mapped.posed.distance(turn(p)) < 1e-3, "{p} goes to {}", mapped.posed);
        }
    }
}

#[test]
fn what_its_handles_turn_over_half_a_turn_goes_on_turning_in_both_modes() {
    const STEP: f64 = 0.1;
    for (mode, blend) in [PoseMode::Harmonic, PoseMode::Rigid].into_iter().zip([Blend::Linear, Blend::Rigid]) {
        let mut project = bent_strip(mode);
        project.pose.blend = blend;
        project.handles.push(bar("bar", &[(260.0, 180.0), (300.0, 180.0)], &[(240.0, 160.0), (275.0, 180.0)]));
        let solution = solved(&project).expect("a valid scene");
        let bent = project.handles.clone();
        let mut before = Vec::new();
        // Bent as the strip is, each handle passes half a turn at another step.
        for step in 0..=600 {
            let turn = DVec2::from_angle((150.0 + STEP * f64::from(step)).to_radians());
            for (handle, bent) in project.handles.iter_mut().zip(&bent) {
                handle.shape = bent.shape.clone();
                let posed = match &mut handle.shape {
                    Shape::Point { posed, .. } => std::slice::from_mut(posed),
                    Shape::Bar { posed, .. } | Shape::Polygon { posed, .. } => &mut posed[..],
                };
                posed.iter_mut().for_each(|p| *p = DVec2::splat(200.0) + turn.rotate(*p - 200.0));
            }
            let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
            let after = solution.posed_vertices(&pose);
            let farthest = after.iter().zip(&before).map(|(after, before): (&DVec2, &DVec2)| after.distance(*before));
            // A tenth of a degree is a third of a pixel at the ends; the rigid mode's descent may end a little sooner or later.
            let farthest = farthest.fold(0.0, f64::max);
            assert!(farthest < 0.6, "{farthest} px at step {step} in the mode {mode:?}");
            before = after;
        }
    }
}

#[test]
fn a_symmetric_pose_is_symmetric() {
    let (solution, pose) = pose_of(&bent_strip(PoseMode::Rigid));
    let mirror = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    for p in spread(2000) {
        if let (Some(here), Some(there)) = (solution.map(&pose, p), solution.map(&pose, mirror(p))) {
            assert!(mirror(here.posed).distance(there.posed) <= 1e-6, "{p}");
        }
    }
}

#[test]
fn a_set_rotation_is_kept() {
    let mut project = bent_strip(PoseMode::Rigid);
    project.handles[1].rotation = Rotation::Degrees(25.0);
    let (solution, pose) = pose_of(&project);
    let site = solution.sites().iter().position(|site| site.kind.handle() == Some(1)).expect("a real site");
    assert_eq!(pose.motions()[site].angle, 25.0_f64.to_radians());
    assert!(pose.motions().iter().any(|motion| motion.angle.abs() > 0.3));
}

#[test]
fn whatever_handles_ask_for_motions_are_finite_or_it_is_refused_by_name() {
    let ring = [(40.0, 160.0), (360.0, 160.0), (360.0, 240.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let rest = DVec2::new(100.0, 200.0);
    let mut project = posed(&[ring], &[(rest, rest)], PoseMode::Rigid);
    let places = [(250.0, 180.0), (250.0, 220.0)];
    project.handles.push(bar("bar", &places, &places));
    let solution = solved(&project).expect("a valid scene");
    for scale in [f64::NAN, -1.0, 0.0, 1e-300, 1e-9, 1e9, 1e12, 1e300] {
        for far in [0.0, 1e9, 1e11, 1e300] {
            for which in 0..2 {
                let mut handles = project.handles.clone();
                handles[which].scale = scale;
                match &mut handles[which].shape {
                    Shape::Point { posed, .. } => posed.x += far,
                    Shape::Bar { posed, .. } | Shape::Polygon { posed, .. } => posed[0].x += far,
                }
                match solution.poser().pose(&handles, project.pose.blend) {
                    Ok(pose) => {
                        assert!(scale > 0.0 && scale < 1e300 && far < 1e300, "{scale} and {far} px are taken");
                        let posed = solution.posed_vertices(&pose);
                        assert!(posed.iter().all(|p| p.is_finite()), "{which} by {scale} and {far} px");
                    }
                    Err(Error::PoseNotFinite { id }) => assert_eq!(id, handles[which].id),
                    Err(Error::Project(reason)) => {
                        assert_eq!(reason.path, format!("handles[{which}].scale"));
                        assert!(scale.is_nan() || scale <= 0.0, "{scale} is refused");
                    }
                    Err(other) => panic!("{other}"),
                }
            }
        }
    }
}
