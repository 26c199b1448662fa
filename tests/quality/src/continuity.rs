//! Jumps of the derivatives of weights, for exact distances and for `"continuity": "c2"`, with the cost of the latter.

use std::hint::black_box;

use c2warp::{
    Error, Picture, Solution,
    project::{Continuity, DomainSpec, Handle, ImageRef, Project},
    solve,
};
use c2warp_bench::{
    clock::native_ms,
    measure::{Effort, min_ms},
};
use c2warp_tests::{
    Scene, outlines,
    smoothness::{Crossing, Jump, Line, crossings, greatest_derivatives},
};
use glam::DVec2;

use crate::{distances::greatest, poses::standard_poses, random_poses::poses_beside_optimum};

const EFFORT: Effort = Effort { warm_up_ms: 0.0, measured_ms: 200.0, min_runs: 3 };
/// The scenes of the tests with a bent domain.
const SCENES: [&str; 7] = ["fold", "gingerbread", "moth", "ring", "road", "strip", "tower"];
/// The figures of which one random pose is measured.
const FIGURES: [&str; 6] = ["salamander 1", "cat 1", "octopus 1", "lattice 1", "face 1", "bars 1"];
/// Walks through each support, in search of lines.
const WALKS: usize = 8;
/// Steps over which jumps are measured, in pixels. A jump stays from the first to the last; otherwise the last is a
/// thousandth of the first.
pub const STEPS_PX: [f64; 2] = [1e-2, 1e-5];
/// Points of the grid, per side, at which the greatest derivatives are found.
const GRID: u32 = 40;

/// The weights of one scene with one continuity.
#[derive(Debug, Clone)]
pub struct SceneContinuity {
    /// The name of the scene.
    pub scene: String,
    /// The continuity.
    pub continuity: Continuity,
    /// The number of sites.
    pub sites: usize,
    /// The number of sites whose supports are cut: they reach points with two shortest paths.
    pub cut_sites: usize,
    /// The greatest jump of a gradient across a line of cut, relative to the greatest gradient.
    pub crease: f64,
    /// The greatest jump of second derivatives across shadow lines over each step, relative to the greatest second
    /// derivative.
    pub shadows: [f64; 2],
    /// Time of a solve, in ms.
    pub solve_ms: f64,
}

/// Measures all scenes with both continuities.
///
/// # Errors
/// If a scene cannot be read or solved.
pub fn continuity() -> Result<Vec<SceneContinuity>, Box<dyn std::error::Error>> {
    let mut all = Vec::new();
    for (name, project, rgba) in measured_scenes()? {
        let (width, height) = (project.image.width, project.image.height);
        let picture = Picture::new(width, height, &rgba)?;
        for continuity in [Continuity::Exact, Continuity::C2] {
            let mut project = project.clone();
            project.weighting.continuity = continuity;
            match of_scene(&name, &project, &picture) {
                Ok(measured) => all.push(measured),
                Err(reason) => eprintln!("    {name}: {reason}"),
            }
        }
    }
    Ok(all)
}

/// A name, the project, and the pixels of the picture.
type NamedScene = (String, Project, Vec<u8>);
/// A name, rings, and the handles.
type DrawnScene = (&'static str, outlines::Rings, &'static [(f64, f64)]);

fn measured_scenes() -> Result<Vec<NamedScene>, Box<dyn std::error::Error>> {
    let square = |side: f64| [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(DVec2::from).to_vec();
    let on_circle = |k: i32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 48.0);
    let disc: Vec<DVec2> = (0..48).map(|k| DVec2::splat(400.0) + 20.0 * on_circle(k)).collect();
    let ell = [(0.0, 0.0), (800.0, 0.0), (800.0, 800.0), (400.0, 800.0), (400.0, 400.0), (0.0, 400.0)];
    let small = |centre: DVec2| -> Vec<DVec2> { (0..16).map(|k| centre + 6.0 * on_circle(3 * k)).collect() };
    let lace = (0..25).map(|k| small(DVec2::new(f64::from(80 + 160 * (k % 5)), f64::from(80 + 160 * (k / 5)))));
    let drawn: [DrawnScene; 4] = [
        ("disc of 20 px", vec![square(800.0), disc], &[(250.0, 390.0), (650.0, 430.0), (400.0, 100.0)]),
        ("L", vec![ell.map(DVec2::from).to_vec()], &[(200.0, 300.0), (700.0, 100.0), (600.0, 700.0)]),
        ("comb", outlines::comb(), &[(100.0, 150.0), (900.0, 150.0), (500.0, 180.0)]),
        ("25 discs of 6 px", [square(800.0)].into_iter().chain(lace).collect(), &[(160.0, 160.0), (640.0, 640.0)]),
    ];
    let on_rings = |(name, rings, handles): DrawnScene| {
        let mut project = Project::new(ImageRef::new("drawn.png", outlines::SIZE, outlines::SIZE));
        project.domain = Some(DomainSpec::polygon(rings));
        project.handles = handles.iter().enumerate().map(|(id, &at)| Handle::point(id.to_string(), at)).collect();
        (name.to_owned(), project, vec![255; 4 * outlines::SIZE as usize * outlines::SIZE as usize])
    };
    let mut scenes: Vec<NamedScene> = drawn.into_iter().map(on_rings).collect();
    let as_in_editor = |project: Project| project.with_editor_settings();
    let holed = scenes.iter().filter(|(name, ..)| name.contains("disc"));
    let holed: Vec<NamedScene> = holed
        .map(|(name, project, rgba)| (format!("{name}, editor"), as_in_editor(project.clone()), rgba.clone()))
        .collect();
    scenes.extend(holed);
    scenes.extend(SCENES.map(|name| {
        let Scene { project, picture } = Scene::named(name);
        (name.to_owned(), project, picture.into_raw())
    }));
    let figures =
        poses_beside_optimum()?.into_iter().filter(|pose| FIGURES.iter().any(|name| pose.name.ends_with(name)));
    scenes.extend(standard_poses()?.into_iter().chain(figures).map(|mut pose| {
        pose.project.samples = Project::for_picture(1, 1).samples;
        (pose.name, as_in_editor(pose.project), pose.picture.into_raw())
    }));
    Ok(scenes)
}

fn of_scene(name: &str, project: &Project, picture: &Picture<'_>) -> Result<SceneContinuity, Error> {
    let solution = solve(project, picture)?;
    let (width, height) = (project.image.width, project.image.height);
    let size = DVec2::new(width.into(), height.into());
    let grid = |k: u32| (f64::from(k) + 0.37) / f64::from(GRID);
    let points: Vec<DVec2> = (0..GRID * GRID).map(|k| size * DVec2::new(grid(k % GRID), grid(k / GRID))).collect();
    let most = greatest_derivatives(&solution, &points, 1e-3);
    let found = crossings(&solution, WALKS);
    let cuts: Vec<&Crossing> = found.iter().filter(|crossing| crossing.line == Line::Cut).collect();
    let mut cut_sites: Vec<usize> = cuts.iter().map(|crossing| crossing.site).collect();
    cut_sites.dedup();
    Ok(SceneContinuity {
        scene: name.to_owned(),
        continuity: project.weighting.continuity,
        sites: solution.sites().len(),
        cut_sites: cut_sites.len(),
        crease: worst(&solution, cuts.into_iter(), STEPS_PX[1], |jump| jump.first) / most.first,
        shadows: STEPS_PX.map(|step| {
            let shadows = found.iter().filter(|crossing| crossing.line == Line::Shadow);
            worst(&solution, shadows, step, |jump| jump.second) / most.second
        }),
        solve_ms: min_ms(native_ms, EFFORT, || drop(black_box(solve(project, picture)))),
    })
}

fn worst<'a>(
    solution: &Solution,
    crossings: impl Iterator<Item = &'a Crossing>,
    step: f64,
    derivative: impl Fn(Jump) -> f64,
) -> f64 {
    let jumps = crossings.filter_map(|crossing| crossing.jump(solution, step)).map(derivative);
    greatest(jumps.chain([0.0]))
}
