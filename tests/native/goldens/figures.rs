//! Tests of the paper's statements about figures 8 (d) and 10.

use c2warp::{
    Solution,
    deform::Pose,
    project::{PoseMode, Rotation, Support},
    solve,
};
use c2warp_tests::Scene;
use glam::DVec2;

fn posed(scene: &Scene) -> (Solution, Pose) {
    let solution = solve(&scene.project, &scene.solver_picture()).expect("a valid scene");
    let pose = solution
        .poser()
        .pose(&scene.project.handles, scene.project.pose.blend)
        .expect("as many handles as were solved");
    (solution, pose)
}

/// Returns the moth in a pose mode. With `auto`, the rotations are left to the solver.
fn moth(mode: PoseMode, auto: bool) -> Scene {
    let mut scene = Scene::named("moth");
    if mode == PoseMode::Rigid {
        (scene.project.weighting.support, scene.project.pose.density) = (Support::Smooth, 30);
    }
    scene.project.pose.mode = mode;
    if auto {
        scene.project.handles.iter_mut().for_each(|handle| handle.rotation = Rotation::Auto);
    }
    scene
}

/// The scene has a ring as its outline. An outline from alpha is simplified, and differs slightly between the sides.
#[test]
fn symmetric_pose_of_a_symmetric_domain_is_symmetric() {
    let mirror = |p: DVec2| DVec2::new(220.0 - p.x, p.y);
    for (mode, auto) in [PoseMode::Harmonic, PoseMode::Rigid].into_iter().flat_map(|mode| [(mode, false), (mode, true)])
    {
        let (solution, pose) = posed(&moth(mode, auto));
        let (mut worst, mut count) = (0.0_f64, 0);
        for (x, y) in (0..220).flat_map(|x| (0..180).map(move |y| (x, y))).filter(|(x, y)| (x + y) % 3 == 0) {
            let p = DVec2::new(f64::from(x) + 0.3125, f64::from(y) + 0.78125);
            let (here, there) = (solution.map(&pose, p), solution.map(&pose, mirror(p)));

            assert_eq!(here.is_some(), there.is_some(), "{p} and its mirror image");
            if let (Some(here), Some(there)) = (here, there) {
                worst = worst.max(mirror(here.posed).distance(there.posed));
                count += 1;
            }
        }
        eprintln!("{mode:?}, automatic rotations: {auto}: {worst:.1e} px over {count} points");
        assert!(count > 3000 && worst <= 1e-6, "{mode:?}, automatic rotations: {auto}: {worst} px");
    }
}

#[test]
fn handles_dragged_past_each_other_fold_the_picture() {
    for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
        let mut scene = Scene::named("fold");
        scene.project.pose.mode = mode;
        let (solution, pose) = posed(&scene);
        assert!(solution.report(&pose).folded_triangles > 0);
        for handle in &scene.project.handles {
            let c2warp::project::Shape::Point { rest, posed } = handle.shape else { continue };
            let mapped = solution.map(&pose, rest).expect("inside");
            assert!(mapped.posed.distance(posed) <= 1e-6, "{}: {}", handle.id, mapped.posed);
        }
    }
}
