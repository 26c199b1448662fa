//! Tests that weights with `"continuity": "c2"` have two continuous derivatives, and keep the other properties.

use c2warp::{
    Solution,
    project::{Continuity, Project, Support},
};
use c2warp_tests::{
    outlines,
    smoothness::{Line, crossings, greatest_derivatives, roughest},
};
use glam::DVec2;
use proptest::prelude::*;

use crate::scenes::{cases, project, scenes, solved, spread};

fn c2(mut project: Project) -> Project {
    project.weighting.continuity = Continuity::C2;
    project
}

/// A ring of 400 px: a square.
fn square() -> Vec<DVec2> {
    [(0.0, 0.0), (400.0, 0.0), (400.0, 400.0), (0.0, 400.0)].map(DVec2::from).to_vec()
}

/// A disc of 20 px radius as a polygon.
fn disc() -> Vec<DVec2> {
    (0..40)
        .map(|k| DVec2::splat(200.0) + 20.0 * DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 40.0))
        .collect()
}

fn ell() -> Vec<DVec2> {
    [(0.0, 0.0), (400.0, 0.0), (400.0, 400.0), (200.0, 400.0), (200.0, 200.0), (0.0, 200.0)].map(DVec2::from).to_vec()
}

/// Scenes of 400 px with corners or holes: name, rings and handles.
fn bent_scenes() -> Vec<(&'static str, outlines::Rings, Vec<DVec2>)> {
    let smaller = |rings: outlines::Rings| -> outlines::Rings {
        rings.into_iter().map(|ring| ring.into_iter().map(|p| p * 0.4).collect()).collect()
    };
    let at = |list: &[(f64, f64)]| list.iter().map(|&p| DVec2::from(p)).collect();
    vec![
        ("L", vec![ell()], at(&[(100.0, 150.0), (350.0, 50.0)])),
        ("disc as a hole", vec![square(), disc()], at(&[(100.0, 190.0), (330.0, 220.0)])),
        ("one handle beside a hole", vec![square(), disc()], at(&[(140.0, 190.0)])),
        ("star as a hole", smaller(outlines::holed_square()), at(&[(48.0, 200.0), (348.0, 200.0), (328.0, 180.0)])),
        ("gingerbread", smaller(outlines::gingerbread()), at(&[(200.0, 52.0), (68.0, 144.0), (276.0, 356.0)])),
        ("comb", smaller(outlines::comb()), at(&[(60.0, 60.0), (340.0, 60.0)])),
    ]
}

#[test]
fn second_derivatives_are_continuous_across_shadow_lines_and_no_support_is_cut() {
    for (name, rings, handles) in bent_scenes() {
        for support in [Support::Paper, Support::Smooth] {
            let project = project(&rings, &handles, support);
            let (exact, smooth) = (solved(&project).unwrap(), solved(&c2(project)).unwrap());
            let (kinks, _) = relative_jumps(&exact);
            let (shadows, cuts) = relative_jumps(&smooth);
            // A lone handle has weight 1 everywhere, unless a hole requires more sites.
            assert!(kinks[1] > 1e-3 || handles.len() == 1, "{name} {support:?}: a scene with jumps");
            assert!(shadows[1] < 0.02 * shadows[0].max(1e-3), "{name} {support:?}: {shadows:?}");
            assert_eq!(cuts, 0, "{name} {support:?}");
        }
    }
}

#[test]
fn second_derivatives_jump_only_in_exact_weights() {
    for (name, rings, handles) in bent_scenes() {
        let project = project(&rings, &handles, Support::Smooth);
        let solutions = [project.clone(), c2(project)].map(|project| solved(&project).unwrap());
        let [exact, smooth] = solutions.map(|solution| worst_of_ways(&solution, 25, 1e-5));
        assert!(exact > 0.01 || handles.len() == 1, "{name}: {exact}");
        assert!(smooth < 1e-4, "{name}: {smooth}");
    }
}

/// The greatest jump of second derivatives on ways across the picture, relative to the greatest second derivative.
fn worst_of_ways(solution: &Solution, count: usize, least: f64) -> f64 {
    let points: Vec<DVec2> = spread(400).collect();
    let greatest = greatest_derivatives(solution, &points, 1e-3).second.max(f64::MIN_POSITIVE);
    let ways = points.chunks(2).take(count);
    ways.map(|ends| roughest(solution, [ends[0], ends[1]], least)).fold(0.0, f64::max) / greatest
}

/// The greatest jumps of second derivatives across shadow lines, over steps of 1e-2 and 1e-4 px, relative to the
/// greatest second derivative. Also the number of places where supports are cut.
fn relative_jumps(solution: &Solution) -> ([f64; 2], usize) {
    let greatest = greatest_derivatives(solution, &spread(400).collect::<Vec<_>>(), 1e-3).second;
    let crossings = crossings(solution, 12);
    let jump = |step: f64| {
        let of_shadows = crossings.iter().filter(|crossing| crossing.line == Line::Shadow);
        of_shadows.filter_map(|crossing| crossing.jump(solution, step)).map(|jump| jump.second).fold(0.0, f64::max)
    };
    let cuts = crossings.iter().filter(|crossing| crossing.line == Line::Cut).count();
    ([1e-2, 1e-4].map(|step| jump(step) / greatest.max(f64::MIN_POSITIVE)), cuts)
}

#[test]
fn a_disc_as_a_hole_creases_exact_weights_and_not_c2_weights() {
    let project = project(&[square(), disc()], &[(100.0, 190.0).into(), (330.0, 220.0).into()], Support::Paper);
    let crease = |solution: &Solution| {
        let cut = crossings(solution, 200).into_iter().filter(|crossing| crossing.line == Line::Cut);
        cut.filter_map(|crossing| crossing.jump(solution, 1e-4)).map(|jump| jump.first).fold(0.0, f64::max)
    };
    let (exact, smooth) = (solved(&project).unwrap(), solved(&c2(project)).unwrap());
    let greatest = greatest_derivatives(&exact, &spread(400).collect::<Vec<_>>(), 1e-3).first;
    assert!(crease(&exact) > 0.1 * greatest, "{} of {greatest}", crease(&exact));
    assert_eq!(crease(&smooth), 0.0);
}

#[test]
fn weights_equal_exact_ones_away_from_shadow_lines() {
    let weights = |rings: &[Vec<DVec2>], handles: &[DVec2], p: DVec2| {
        let project = project(rings, handles, Support::Smooth);
        [project.clone(), c2(project)].map(|project| solved(&project).unwrap().weights_at(p))
    };
    let handles = [(60.0, 120.0), (340.0, 60.0)].map(DVec2::from);
    for p in spread(60) {
        let [exact, smooth] = weights(&[square()], &handles, p);
        assert_eq!(exact, smooth, "{p}");
    }
    // Above the corner of the L, all of its sites see each other.
    let [exact, smooth] = weights(&[ell()], &handles, DVec2::new(150.0, 30.0));
    assert_eq!(exact, smooth);
}

#[test]
fn symmetric_scenes_have_symmetric_weights() {
    let mirrored = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    let tee = [
        (20.0, 20.0),
        (380.0, 20.0),
        (380.0, 120.0),
        (260.0, 120.0),
        (260.0, 380.0),
        (140.0, 380.0),
        (140.0, 120.0),
        (20.0, 120.0),
    ];
    for rings in [vec![square(), disc()], vec![tee.map(DVec2::from).to_vec()]] {
        let handles = [(80.0, 60.0), (320.0, 60.0), (200.0, 320.0)].map(DVec2::from);
        let solution = solved(&c2(project(&rings, &handles, Support::Smooth))).unwrap();
        let sites = solution.sites();
        for p in spread(200) {
            let Some(weights) = solution.weights_at(p) else { continue };
            let other = solution.weights_at(mirrored(p)).expect("the domain is symmetric");
            for (site, weight) in weights {
                let beyond = mirrored(sites[site].rest);
                let twin = sites.iter().position(|other| other.rest.distance(beyond) < 1e-6).expect("a mirrored site");
                let its = other.iter().find(|one| one.0 == twin).map_or(0.0, |one| one.1);
                assert!((weight - its).abs() < 1e-8, "{p}: {weight} and {its}");
            }
        }
    }
}

#[test]
fn samples_have_the_weights_of_their_points() {
    for (name, rings, handles) in bent_scenes() {
        let solution = solved(&c2(project(&rings, &handles, Support::Smooth))).unwrap();
        for sample in (0..solution.samples()).step_by(7) {
            let p = solution.vertices()[sample];
            let at = solution.weights_at(p).expect("samples lie in the domain");
            for (site, weight) in solution.weights().row(sample) {
                let its = at.iter().find(|one| one.0 == site).map_or(0.0, |one| one.1);
                assert!((weight - its).abs() < 1e-12, "{name} {p}: {weight} and {its}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn c2_weights_interpolate_sum_to_one_and_have_no_jumps((rings, handles, support) in scenes()) {
        let project = c2(project(&rings, &handles, support));
        let Ok(solution) = solved(&project) else { return Ok(()) };
        for (site, at) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            prop_assert_eq!(solution.weights_at(at.rest), Some(vec![(site, 1.0)]));
        }
        for p in spread(300) {
            let Some(weights) = solution.weights_at(p).filter(|weights| !weights.is_empty()) else { continue };
            let sum: f64 = weights.iter().map(|one| one.1).sum();
            prop_assert!((sum - 1.0).abs() < 1e-12 && weights.iter().all(|one| one.1 >= 0.0), "{}: {}", p, sum);
        }
        let pose = solution.pose(&project).expect("at rest");
        // An island without a handle stays.
        prop_assert!(rings.len() > 1 || solution.report(&pose).min_phi_sum > 0.0);
        let coarse = worst_of_ways(&solution, 6, 1e-5);
        // Beside handles half a pixel apart, third derivatives are large. Then a finer step tells.
        prop_assert!(coarse < 1e-4 || worst_of_ways(&solution, 6, 1e-6) < 0.2 * coarse, "{}", coarse);
    }
}
