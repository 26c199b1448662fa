//! Tests of the quality of weights: smoothness, secondary maxima and dependence on the samples.

use std::collections::BTreeSet;

use c2warp::{Solution, project::Support};
use c2warp_tests::{outlines, secondary_maxima::SecondaryMaxima};
use glam::DVec2;

use crate::handles::point_handle;
use crate::scenes::{project, solved, spread};

/// The rest position of a handle and its displacement, as plain numbers.
type Move = ((f64, f64), (f64, f64));
/// The rest position and the posed position of each handle.
type Moves = Vec<(DVec2, DVec2)>;

/// Scenes of 1,000 px: name, rings and handles.
fn posed_scenes() -> Vec<(&'static str, outlines::Rings, Moves)> {
    let moves = |list: &[Move]| -> Moves {
        list.iter().map(|&(rest, shift)| (rest.into(), DVec2::from(rest) + DVec2::from(shift))).collect()
    };
    vec![
        (
            "gingerbread",
            outlines::gingerbread(),
            moves(&[
                ((500.0, 130.0), (0.0, 0.0)),
                ((170.0, 360.0), (60.0, -150.0)),
                ((830.0, 360.0), (0.0, 40.0)),
                ((310.0, 890.0), (0.0, 0.0)),
                ((690.0, 890.0), (40.0, -40.0)),
                ((500.0, 450.0), (0.0, 0.0)),
                ((530.0, 470.0), (5.0, 0.0)),
            ]),
        ),
        (
            "hole",
            outlines::holed_square(),
            moves(&[((120.0, 500.0), (0.0, -60.0)), ((870.0, 500.0), (0.0, 0.0)), ((820.0, 450.0), (30.0, 20.0))]),
        ),
        (
            "disc",
            outlines::disc(),
            moves(&[((430.0, 500.0), (-40.0, 0.0)), ((520.0, 480.0), (40.0, 0.0)), ((500.0, 800.0), (0.0, 0.0))]),
        ),
    ]
}

fn scene(
    rings: &outlines::Rings,
    moves: &[(DVec2, DVec2)],
    samples: u32,
    support: Support,
) -> (c2warp::project::Project, Solution) {
    let positions: Vec<DVec2> = moves.iter().map(|&(rest, _)| rest).collect();
    let mut project = project(rings, &positions, support);
    (project.image.width, project.image.height, project.samples) = (outlines::SIZE, outlines::SIZE, samples);
    project.handles = moves.iter().enumerate().map(|(id, &(rest, posed))| point_handle(id, rest, posed, 0.0)).collect();
    let solution = solved(&project).expect("a valid scene");
    (project, solution)
}

#[test]
fn ten_times_the_samples_change_little() {
    for (name, rings, moves) in posed_scenes() {
        let [(coarse_sites, coarse), (fine_sites, fine)] = [8_000, 80_000].map(|samples| {
            let (project, solution) = scene(&rings, &moves, samples, Support::Smooth);
            let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
            let points = spread(2_500).map(|p| p * 2.5).filter_map(|p| solution.map(&pose, p)).take(1_000);
            (solution.sites().len() as f64, points.map(|mapped| mapped.posed).collect::<Vec<DVec2>>())
        });
        assert!((coarse_sites / fine_sites - 1.0).abs() <= 0.1, "{name}: {coarse_sites} and {fine_sites} sites");
        let largest = moves.iter().map(|(rest, posed)| rest.distance(*posed)).fold(0.0, f64::max);
        let differences: Vec<f64> = coarse.iter().zip(&fine).map(|(a, b)| a.distance(*b) / largest).collect();
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        let worst = differences.iter().copied().fold(0.0, f64::max);
        eprintln!("{name}: sites {coarse_sites}/{fine_sites}, mean {mean:.4}, worst {worst:.4}");
        assert!(mean <= 0.01, "{name}: mean difference {mean}");
        assert!(worst <= 0.05, "{name}: worst difference {worst}");
    }
}

#[test]
fn second_derivatives_are_continuous_in_a_convex_domain() {
    let moves = [(430.0, 500.0), (520.0, 480.0), (500.0, 800.0)].map(|p| (p.into(), p.into()));
    for support in [Support::Paper, Support::Smooth] {
        let (_, solution) = scene(&outlines::disc(), &moves, 8_000, support);
        // Jumps of the second difference along a line, at one step size and at a quarter of it. If the second
        // derivative is continuous, they shrink in proportion to the step. At a discontinuity they stay.
        let worst_jump = |step: f64| {
            let (from, along) = (DVec2::new(200.0, 430.0), DVec2::new(0.95, 0.312_25));
            let count = (500.0 / step) as usize;
            let fields: Vec<Vec<(usize, f64)>> = (0..count)
                .map(|i| solution.weights_at(from + along * (step * i as f64)).expect("inside the disc"))
                .collect();
            let weight = |i: usize, site: usize| fields[i].iter().find(|w| w.0 == site).map_or(0.0, |w| w.1);
            let sites: BTreeSet<usize> = fields.iter().flatten().map(|w| w.0).collect();
            let second = |i: usize, site: usize| {
                (weight(i - 1, site) - 2.0 * weight(i, site) + weight(i + 1, site)) / (step * step)
            };
            let jumps = sites
                .iter()
                .flat_map(|&site| (1..count - 2).map(move |i| (second(i + 1, site) - second(i, site)).abs()));
            jumps.fold(0.0, f64::max)
        };
        let (coarse, fine) = (worst_jump(0.4), worst_jump(0.1));
        eprintln!("{support:?}: jumps {coarse:.2e} at 0.4 px, {fine:.2e} at 0.1 px");
        assert!(fine <= coarse / 3.0, "{support:?}: jumps {coarse} at 0.4 px, {fine} at 0.1 px");
    }
}

#[test]
fn secondary_maxima_are_rare_and_low() {
    for (name, rings, moves) in posed_scenes() {
        for support in [Support::Paper, Support::Smooth] {
            let (_, solution) = scene(&rings, &moves, 8_000, support);
            let SecondaryMaxima { of_sites, of_handles, .. } = SecondaryMaxima::of(&solution);
            eprintln!("{name} {support:?}, secondary maxima: of sites {of_sites:.3?}, of handles {of_handles:.3?}");
            assert!(
                of_sites.len() <= MAX_COUNT && of_sites.iter().all(|&persistence| persistence < MAX_PERSISTENCE),
                "{name} {support:?}"
            );
            let highest = if support == Support::Smooth { 0.0 } else { MAX_PERSISTENCE_OF_HANDLES };
            assert!(of_handles.iter().all(|&persistence| persistence < highest), "{name} {support:?}");
        }
    }
}

/// Largest number of secondary maxima in one scene of about 30 weight fields, as found on these scenes.
///
/// The paper saw no secondary maximum in its examples and could not prove that none exists. They occur where two
/// supports end close to a point: one weight may grow again where the other one ends. `npm run quality` counts them on
/// other scenes.
const MAX_COUNT: usize = 2;
/// Largest persistence of a secondary maximum, as found on these scenes.
const MAX_PERSISTENCE: f64 = 0.2;
/// Largest persistence in the field of a handle (eq. 4). Smooth supports leave none. The paper's supports leave 0.013
/// where two paths around the hole meet.
const MAX_PERSISTENCE_OF_HANDLES: f64 = 0.02;
