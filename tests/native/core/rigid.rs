//! Tests of the rigid pose mode. It needs no rotations, interpolates handles, and bends with little distortion.

use c2warp::{
    Error, Solution,
    deform::Pose,
    project::{Blend, PoseMode, Project, Rotation, Shape, Support},
};
use glam::DVec2;

use crate::{
    energy::{MAX_ENERGY, energy_at},
    handles::{bar, point_handle},
    scenes::{project, solved, spread, symmetric_within},
};

/// Returns a project with posed handles whose rotations are left to the solver.
fn posed(rings: &[Vec<DVec2>], moves: &[(DVec2, DVec2)], mode: PoseMode) -> Project {
    let positions: Vec<DVec2> = moves.iter().map(|&(rest, _)| rest).collect();
    let mut project = project(rings, &positions, Support::Smooth);
    (project.pose.mode, project.pose.density) = (mode, 60);
    project.handles = moves.iter().enumerate().map(|(id, &(rest, posed))| point_handle(id, rest, posed, 0.0)).collect();
    for handle in &mut project.handles {
        handle.rotation = Rotation::Auto;
    }
    project
}

/// Solves a project and poses it.
fn pose_of(project: &Project) -> (Solution, Pose) {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    (solution, pose)
}

/// Returns a strip of 320 by 80 px that three pins bend upwards in the middle.
fn bent_strip(mode: PoseMode) -> Project {
    let ring = [(40.0, 160.0), (360.0, 160.0), (360.0, 240.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let moves = [((60.0, 200.0), (90.0, 250.0)), ((200.0, 200.0), (200.0, 150.0)), ((340.0, 200.0), (310.0, 250.0))];
    posed(&[ring], &moves.map(|(rest, to)| (rest.into(), to.into())), mode)
}

/// Returns the symmetric Dirichlet energy |J|² + |J⁻¹|² − 4 over the domain, sorted. It is 0 for a rigid motion.
fn energies(solution: &Solution, pose: &Pose) -> Vec<f64> {
    let mut energies: Vec<f64> = spread(4000).filter_map(|p| energy_at(solution, pose, p)).collect();
    assert!(energies.len() > 300);
    energies.sort_by(f64::total_cmp);
    energies
}

fn mean(energies: &[f64]) -> f64 {
    energies.iter().sum::<f64>() / energies.len() as f64
}

#[test]
fn bent_strip_has_far_less_energy_than_in_the_harmonic_mode() {
    let [harmonic, rigid] = [PoseMode::Harmonic, PoseMode::Rigid].map(|mode| {
        let (solution, pose) = pose_of(&bent_strip(mode));
        let energies = energies(&solution, &pose);
        [mean(&energies), energies[energies.len() / 2], energies[energies.len() * 9 / 10], energies[energies.len() - 1]]
    });
    eprintln!("symmetric Dirichlet energy, mean, median, 90 % and largest: harmonic {harmonic:.3?}, rigid {rigid:.3?}");
    assert!(rigid[0] < 0.18 && rigid[1] < 0.09 && rigid[2] < 0.4, "{rigid:?}");
    assert!(rigid[0] < harmonic[0] / 7.0 && rigid[2] < harmonic[2] / 5.0, "{rigid:?} and {harmonic:?}");
    assert!(rigid[3] < MAX_ENERGY, "folded or nearly folded: {rigid:?}");
}

/// Returns a cross of 320 px with fixed ends, whose middle is rotated by 90° with four handles.
fn twisted_cross(mode: PoseMode) -> Project {
    let middle = DVec2::splat(200.0);
    let quarter = |k: usize| DVec2::from_angle(std::f64::consts::FRAC_PI_2 * k as f64);
    let arm = [(-40.0, -40.0), (-40.0, -160.0), (40.0, -160.0)].map(DVec2::from);
    let ring = (0..4).flat_map(|k| arm.map(|p| (middle + quarter(k).rotate(p)).round())).collect();
    let position = |k: usize, far: f64| (middle + quarter(k).rotate(DVec2::new(0.0, -far))).round();
    let ends = (0..4).map(|k| (position(k, 145.0), position(k, 145.0)));
    let turned = (0..4).map(|k| (position(k, 30.0), position(k + 1, 30.0)));
    posed(&[ring], &ends.chain(turned).collect::<Vec<_>>(), mode)
}

#[test]
fn cross_twisted_by_90_degrees_does_not_fold() {
    let [harmonic, rigid] = [PoseMode::Harmonic, PoseMode::Rigid].map(|mode| {
        let mut project = twisted_cross(mode);
        project.pose.density = 100;
        let (solution, pose) = pose_of(&project);
        energies(&solution, &pose)
    });
    eprintln!("mean symmetric Dirichlet energy: harmonic {:.3}, rigid {:.3}", mean(&harmonic), mean(&rigid));
    assert!(rigid[rigid.len() - 1] < MAX_ENERGY, "{}", rigid[rigid.len() - 1]);
    assert!(mean(&rigid) < 1.0 && mean(&rigid) < mean(&harmonic) / 5.0, "{} and {}", mean(&rigid), mean(&harmonic));
}

/// Returns the rest and posed positions of a point handle.
fn point(shape: &Shape) -> (DVec2, DVec2) {
    let Shape::Point { rest, posed } = shape else { unreachable!("all are points") };
    (*rest, *posed)
}

#[test]
fn drag_is_continuous() {
    const STEP: f64 = 0.05;
    for density in [0, 100] {
        let mut project = bent_strip(PoseMode::Rigid);
        project.pose.density = density;
        let solution = solved(&project).expect("a valid scene");
        let site_positions = |project: &Project| -> Vec<DVec2> {
            let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
            solution.sites().iter().enumerate().map(|(at, site)| pose.moved(at, site.rest)).collect()
        };
        let mut before = site_positions(&project);
        let mut worst = 0.0_f64;
        for _ in 0..100 {
            let Shape::Point { posed, .. } = &mut project.handles[1].shape else { unreachable!("all are points") };
            *posed += STEP * DVec2::new(0.6, -0.8);
            let after = site_positions(&project);
            worst = after.iter().zip(&before).map(|(after, before)| after.distance(*before)).fold(worst, f64::max);
            before = after;
        }
        eprintln!("largest displacement: {:.1} times that of the handle", worst / STEP);
        // A lever moves farther than the handle. A jump would be of pixels, not of hundredths.
        assert!(worst < 0.5, "{worst} px");
    }
}

#[test]
fn twist_of_the_cross_is_continuous() {
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
    eprintln!("largest displacement: {:.1} times that of the handles", worst / farthest);
    // The continuous twist needs a factor of 2. A jump would have a factor of tens.
    assert!(worst < 5.0 * farthest, "{worst} px");
}

#[test]
fn handles_reach_their_posed_positions() {
    let project = bent_strip(PoseMode::Rigid);
    let (solution, pose) = pose_of(&project);
    for (rest, to) in [((60.0, 200.0), (90.0, 250.0)), ((200.0, 200.0), (200.0, 150.0))] {
        let mapped = solution.map(&pose, rest.into()).expect("inside");
        assert!(mapped.posed.distance(to.into()) <= 1e-6);
    }
}

#[test]
fn rigid_motion_of_all_handles_moves_every_point() {
    let turn = |p: DVec2| DVec2::splat(200.0) + DVec2::from_angle(0.9).rotate(p - 200.0) + DVec2::new(5.0, -9.0);
    let ring = [(40.0, 160.0), (360.0, 160.0), (330.0, 300.0), (200.0, 220.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let positions = [(60.0, 200.0), (200.0, 200.0), (320.0, 270.0)].map(DVec2::from);
    let (solution, pose) = pose_of(&posed(&[ring], &positions.map(|p| (p, turn(p))), PoseMode::Rigid));
    for p in spread(500) {
        if let Some(mapped) = solution.map(&pose, p) {
            assert!(mapped.posed.distance(turn(p)) < 1e-3, "{p} is mapped to {}", mapped.posed);
        }
    }
}

#[test]
fn rotation_past_180_degrees_is_continuous_in_both_modes() {
    const STEP: f64 = 0.1;
    for (mode, blend) in [PoseMode::Harmonic, PoseMode::Rigid].into_iter().zip([Blend::Linear, Blend::Rigid]) {
        let mut project = bent_strip(mode);
        project.pose.blend = blend;
        project.handles.push(bar("bar", &[(260.0, 180.0), (300.0, 180.0)], &[(240.0, 160.0), (275.0, 180.0)]));
        let solution = solved(&project).expect("a valid scene");
        let bent = project.handles.clone();
        let mut before = Vec::new();
        // The strip is bent, so each handle passes 180° at another step.
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
            // 0.1° is a third of a pixel at the ends. The descent of the rigid mode may stop slightly earlier or later.
            let farthest = farthest.fold(0.0, f64::max);
            assert!(farthest < 0.6, "{farthest} px at step {step} in the mode {mode:?}");
            before = after;
        }
    }
}

#[test]
fn symmetric_pose_has_a_symmetric_result() {
    let (solution, pose) = pose_of(&bent_strip(PoseMode::Rigid));
    let within = symmetric_within(PoseMode::Rigid, &solution, &pose).unwrap_or(0.1);
    let mirror = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    for p in spread(2000) {
        if let (Some(here), Some(there)) = (solution.map(&pose, p), solution.map(&pose, mirror(p))) {
            assert!(mirror(here.posed).distance(there.posed) <= within, "{p}");
        }
    }
}

#[test]
fn rotation_of_a_handle_is_kept() {
    let mut project = bent_strip(PoseMode::Rigid);
    project.handles[1].rotation = Rotation::Degrees(25.0);
    let (solution, pose) = pose_of(&project);
    let site = solution.sites().iter().position(|site| site.kind.handle() == Some(1)).expect("a real site");
    assert_eq!(pose.motions()[site].angle, 25.0_f64.to_radians());
    assert!(pose.motions().iter().any(|motion| motion.angle.abs() > 0.3));
}

#[test]
fn extreme_poses_are_finite_or_rejected_by_name() {
    let ring = [(40.0, 160.0), (360.0, 160.0), (360.0, 240.0), (40.0, 240.0)].map(DVec2::from).to_vec();
    let rest = DVec2::new(100.0, 200.0);
    let mut project = posed(&[ring], &[(rest, rest)], PoseMode::Rigid);
    let positions = [(250.0, 180.0), (250.0, 220.0)];
    project.handles.push(bar("bar", &positions, &positions));
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
                        assert!(scale > 0.0 && scale < 1e300 && far < 1e300, "scale {scale} and {far} px are accepted");
                        let posed = solution.posed_vertices(&pose);
                        assert!(posed.iter().all(|p| p.is_finite()), "handle {which}, scale {scale}, {far} px");
                    }
                    Err(Error::PoseNotFinite { id }) => assert_eq!(id, handles[which].id),
                    Err(Error::Project(reason)) => {
                        assert_eq!(reason.path, format!("handles[{which}].scale"));
                        assert!(scale.is_nan() || scale <= 0.0, "scale {scale} is rejected");
                    }
                    Err(other) => panic!("{other}"),
                }
            }
        }
    }
}
