//! Tests of stiff places: they keep their form, handles are still reached, and a symmetric scene stays symmetric.

use c2warp::{
    Picture, Solution, Solver, Stage,
    cloud::PointCloud,
    deform::Pose,
    fit::Fitter,
    project::{Handle, Project, Rotation, Stiffness, Support},
    solve_cloud,
};
use glam::DVec2;

use crate::{
    energy::energy_at,
    handles::polygon,
    scenes::{SIZE, project, solved, spread, symmetric_within},
};

/// Cells along each side of the masks, as the editor has them.
const CELLS: u32 = 128;

/// Returns a mask with a stiffness for each place of the picture.
fn mask(stiffness: impl Fn(DVec2) -> f64) -> Stiffness {
    let centre = |cell: u32| (f64::from(cell) + 0.5) * f64::from(SIZE) / f64::from(CELLS);
    let cells = (0..CELLS).flat_map(|row| (0..CELLS).map(move |column| DVec2::new(centre(column), centre(row))));
    Stiffness::new(CELLS, CELLS, cells.map(|at| (255.0 * stiffness(at)).round() as u8).collect())
}

/// Returns a mask that is stiff in a disc.
fn disc(middle: DVec2, radius: f64) -> Stiffness {
    mask(|at| if at.distance(middle) <= radius { 1.0 } else { 0.0 })
}

/// Returns a strip of 380 by 200 px with the editor's settings that its handles bend upwards in the middle.
fn bent_strip(bend: f64) -> Project {
    let ring = [(10.0, 100.0), (390.0, 100.0), (390.0, 300.0), (10.0, 300.0)].map(DVec2::from).to_vec();
    let moves = [
        ((40.0, 150.0), (80.0, 250.0)),
        ((40.0, 250.0), (20.0, 340.0)),
        ((200.0, 200.0), (200.0, 140.0)),
        ((360.0, 150.0), (320.0, 250.0)),
        ((360.0, 250.0), (380.0, 340.0)),
    ];
    let mut project = project(&[ring], &[], Support::Smooth);
    project.samples = 10_000;
    let handle = |(id, (rest, to))| {
        let [rest, to] = [rest, to].map(DVec2::from);
        Handle::point(format!("h{id}"), rest).posed_at([rest.lerp(to, bend)]).turned(Rotation::Auto)
    };
    project.handles = moves.into_iter().enumerate().map(handle).collect();
    project.with_editor_settings()
}

fn pose_of(project: &Project) -> (Solution, Pose) {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    (solution, pose)
}

/// Returns the mean symmetric Dirichlet energy |J|² + |J⁻¹|² − 4 at the points of a region.
fn energy(solution: &Solution, pose: &Pose, is_in: impl Fn(DVec2) -> bool) -> f64 {
    let energies: Vec<f64> =
        spread(60_000).filter(|&p| is_in(p)).filter_map(|p| energy_at(solution, pose, p)).collect();
    assert!(energies.len() > 100, "{}", energies.len());
    energies.iter().sum::<f64>() / energies.len() as f64
}

fn assert_reached(solution: &Solution, pose: &Pose, project: &Project) {
    for handle in &project.handles {
        for (&rest, &to) in handle.shape.rest().iter().zip(handle.shape.posed()) {
            let mapped = solution.map(pose, rest).expect("inside");
            assert!(mapped.posed.distance(to) <= 1e-6, "{}: {} px", handle.id, mapped.posed.distance(to));
        }
    }
}

#[test]
fn stiff_disc_has_a_hundredth_of_its_energy() {
    for middle in [(120.0, 190.0), (150.0, 240.0), (200.0, 200.0)].map(DVec2::from) {
        // A twentieth, a tenth and nearly a fifth of the picture. A larger disc has handles at its rim.
        for radius in [20.0, 40.0, 70.0] {
            let soft = bent_strip(0.5);
            let mut stiff = soft.clone();
            stiff.stiffness = Some(disc(middle, radius));
            let [before, after] = [&soft, &stiff].map(|project| {
                let (solution, pose) = pose_of(project);
                assert_reached(&solution, &pose, project);
                [energy(&solution, &pose, |p| p.distance(middle) <= radius), energy(&solution, &pose, |_| true)]
            });
            let left = 100.0 * after[0] / before[0];
            eprintln!(
                "{middle}, radius {radius}: {left:.2} % of the energy; of all {:.3} to {:.3}",
                before[1], after[1]
            );
            assert!(left <= 1.0, "{middle}, radius {radius}: {} to {}", before[0], after[0]);
        }
    }
}

/// Mirrors a point left to right.
fn mirrored(p: DVec2) -> DVec2 {
    DVec2::new(400.0 - p.x, p.y)
}

#[test]
fn mirrored_scene_has_the_mirrored_pose() {
    let stiff = |at: DVec2| (1.5 - at.distance(DVec2::new(120.0, 190.0)) / 40.0).clamp(0.0, 1.0);
    let mut left = bent_strip(0.5);
    // Not symmetric itself.
    left.handles[0].shape.posed_mut()[0] += DVec2::new(12.0, -5.0);
    let mut right = left.clone();
    for handle in &mut right.handles {
        let [rest, posed] = [handle.shape.rest()[0], handle.shape.posed()[0]].map(mirrored);
        *handle = Handle::point(handle.id.clone(), rest).posed_at([posed]).turned(Rotation::Auto);
    }
    left.stiffness = Some(mask(stiff));
    right.stiffness = Some(mask(|at| stiff(mirrored(at))));
    let [(one, one_pose), (other, other_pose)] = [&left, &right].map(pose_of);
    let within = symmetric_within(left.pose.mode, &one, &one_pose).unwrap_or(0.1);
    for p in spread(2000) {
        if let (Some(here), Some(there)) = (one.map(&one_pose, p), other.map(&other_pose, mirrored(p))) {
            assert!(mirrored(here.posed).distance(there.posed) <= within, "{p}: {} and {}", here.posed, there.posed);
        }
    }
}

#[test]
fn uniformly_stiff_picture_poses_like_a_soft_one() {
    let soft = bent_strip(1.0);
    let (solution, pose) = pose_of(&soft);
    for stiffness in [1.0, 0.4] {
        let mut stiff = soft.clone();
        stiff.stiffness = Some(mask(|_| stiffness));
        let (other, other_pose) = pose_of(&stiff);
        for p in spread(500) {
            if let (Some(here), Some(there)) = (solution.map(&pose, p), other.map(&other_pose, p)) {
                assert!(here.posed.distance(there.posed) <= 1e-3, "{p}: {} and {}", here.posed, there.posed);
            }
        }
    }
}

#[test]
fn more_stiffness_leaves_less_energy() {
    let middle = DVec2::new(150.0, 200.0);
    let energies = [0.0, 0.25, 0.5, 1.0].map(|stiffness| {
        let mut project = bent_strip(0.5);
        project.stiffness = Some(mask(|at| if at.distance(middle) <= 40.0 { stiffness } else { 0.0 }));
        let (solution, pose) = pose_of(&project);
        energy(&solution, &pose, |p| p.distance(middle) <= 40.0)
    });
    assert!(energies.windows(2).all(|pair| pair[1] < 0.6 * pair[0]), "{energies:?}");
}

#[test]
fn handles_pulled_apart_in_a_stiff_area_are_reached() {
    for far in [40.0, 150.0, 1e4] {
        let mut project = bent_strip(0.0);
        for (at, by) in [(1, -far), (3, far)] {
            project.handles[at].shape.posed_mut()[0].x += by;
        }
        for stiffness in [disc(DVec2::splat(200.0), 195.0), disc(DVec2::new(200.0, 200.0), 60.0)] {
            project.stiffness = Some(stiffness);
            let (solution, pose) = pose_of(&project);
            assert_reached(&solution, &pose, &project);
            assert!(solution.posed_vertices(&pose).iter().all(|p| p.is_finite()));
        }
    }
}

#[test]
fn stiff_polygon_keeps_the_picture_around_it_in_form() {
    let ring = [(160.0, 160.0), (240.0, 160.0), (240.0, 240.0), (160.0, 240.0)];
    let mut project = bent_strip(0.5);
    project.handles[2] = polygon("shell", &ring, &ring.map(|(x, y)| (x, y - 30.0)));
    let around = |p: DVec2| {
        let away = (p - 200.0).abs().max_element();
        (42.0..46.0).contains(&away)
    };
    let [soft, stiff] = [0.0, 1.0].map(|stiffness| {
        project.handles[2].stiffness = stiffness;
        let (solution, pose) = pose_of(&project);
        assert_reached(&solution, &pose, &project);
        [energy(&solution, &pose, around), energy(&solution, &pose, |p| (p - 200.0).abs().max_element() < 39.0)]
    });
    eprintln!("energy around and inside a polygon: {soft:?}, {stiff:?} if it is stiff");
    assert!(stiff[0] < 0.2 * soft[0], "around: {} and {}", soft[0], stiff[0]);
    assert!(stiff[1] <= soft[1] + 1e-3, "inside: {} and {}", soft[1], stiff[1]);
}

#[test]
fn stiffness_alone_takes_one_stage_and_gives_the_pose_of_a_whole_solve() {
    let rgba = vec![255; (SIZE * SIZE * 4) as usize];
    let picture = Picture::new(SIZE, SIZE, &rgba).unwrap();
    let mut project = bent_strip(0.5);
    let mut solver = Solver::new();
    let mut stages = |project: &Project| {
        solver.begin(project, &picture).unwrap();
        let mut stages = Vec::new();
        while let Some(stage) = solver.advance().unwrap() {
            stages.push(stage);
        }
        let pose = solver.solution().unwrap().pose(project).unwrap();
        (stages, pose.motions().to_vec())
    };
    let soft = stages(&project);
    assert_eq!(soft.0.len(), 4);
    project.stiffness = Some(disc(DVec2::new(150.0, 200.0), 40.0));
    let (few, motions) = stages(&project);
    assert_eq!(few, [Stage::Weights]);
    assert_eq!(motions, pose_of(&project).1.motions());
    assert_ne!(motions, soft.1);
    project.stiffness = None;
    assert_eq!(stages(&project), (vec![Stage::Weights], soft.1));
}

#[test]
fn harmonic_mode_has_no_stiffness_and_a_cloud_refuses_it() {
    let mut project = bent_strip(0.5);
    project.pose = Project::for_picture(2, 2).pose;
    let soft = pose_of(&project).1;
    project.stiffness = Some(mask(|_| 1.0));
    assert_eq!(soft.motions(), pose_of(&project).1.motions());

    let mut project = bent_strip(0.5);
    project.domain = None;
    project.stiffness = Some(mask(|_| 1.0));
    let cloud = PointCloud::new(spread(500).collect(), 6).unwrap();
    let refused = solve_cloud(&project, &cloud).unwrap_err().to_string();
    assert!(refused.contains("stiffness"), "{refused}");
}

#[test]
fn mask_is_mapped_to_a_picture_of_another_size() {
    let mut project = bent_strip(0.0);
    project.domain = None;
    project.stiffness = Some(disc(DVec2::new(150.0, 200.0), 40.0));
    let rgba = vec![255; (2 * SIZE * SIZE * 4) as usize];
    let fitted = Fitter::by_box(project.clone()).fit(&Picture::new(2 * SIZE, SIZE, &rgba).unwrap()).unwrap();
    assert_eq!(fitted.project.stiffness, project.stiffness);
}
