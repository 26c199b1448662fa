//! The properties of section III-C, on random scenes.

use c2warp::{Solution, project::Support, site::Site};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, project, scenes, solved, spread};

/// Sums of a dozen weights, each rounded to 1e-16.
const UNITY: f64 = 1e-12;

fn check_weights(weights: &[(usize, f64)], p: DVec2) -> Result<(), TestCaseError> {
    prop_assert!(weights.iter().all(|&(_, weight)| weight >= 0.0), "a negative weight at {p}");
    let sum: f64 = weights.iter().map(|&(_, weight)| weight).sum();
    prop_assert!(weights.is_empty() || (sum - 1.0).abs() <= UNITY, "weights at {p} sum to {sum}");
    Ok(())
}

/// Islands on which a handle stands must be covered everywhere.
fn is_reached(solution: &Solution, sample: usize) -> bool {
    solution.nearest_site(sample).is_some()
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn weights_sum_to_one_and_none_is_negative((rings, places, support) in scenes()) {
        let solution = solved(&project(&rings, &places, support)).expect("a valid scene");
        for vertex in 0..solution.weights().len() {
            let row: Vec<(usize, f64)> = solution.weights().row(vertex).collect();
            check_weights(&row, solution.vertices()[vertex])?;
        }
        for p in spread(500) {
            if let Some(weights) = solution.weights_at(p) {
                check_weights(&weights, p)?;
            }
        }
    }

    #[test]
    fn every_point_of_an_island_with_a_handle_is_covered((rings, places, support) in scenes()) {
        let solution = solved(&project(&rings, &places, support)).expect("a valid scene");
        for sample in (0..solution.samples()).filter(|&sample| is_reached(&solution, sample)) {
            prop_assert!(solution.phi_sums()[sample] > 0.0);
            prop_assert!(solution.weights().row(sample).next().is_some());
        }
        // Between the samples: a point has weights exactly where the corners of its island have.
        let islands_without_handles = (0..solution.samples()).any(|sample| !is_reached(&solution, sample));
        for p in spread(500) {
            if let Some(weights) = solution.weights_at(p) {
                prop_assert!(!weights.is_empty() || islands_without_handles, "nothing covers {p}");
            }
        }
    }

    #[test]
    fn a_handle_has_all_the_weight_at_its_own_place((rings, places, support) in scenes()) {
        let solution = solved(&project(&rings, &places, support)).expect("a valid scene");
        for (site, real) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            prop_assert_eq!(solution.weights_at(real.rest), Some(vec![(site, 1.0)]));
        }
    }

    #[test]
    fn every_support_is_clear_of_other_real_sites_and_covers_its_cell((rings, places, support) in scenes()) {
        let solution = solved(&project(&rings, &places, support)).expect("a valid scene");
        let reals: Vec<DVec2> = solution.sites().iter().filter(|s| s.kind.is_real()).map(|s| s.rest).collect();
        for site in solution.sites() {
            prop_assert!(site.cell_radius < site.support_radius);
            let others: Vec<DVec2> = reals.iter().copied().filter(|&real| real != site.rest).collect();
            let distances = solution.distances(site.rest, &others).expect("sites lie in the domain");
            for d in distances.into_iter().flatten() {
                prop_assert!(site.support_radius <= d);
            }
        }
    }

    /// As coordinates are that were rounded, to six digits say.
    #[test]
    fn a_handle_beside_a_corner_by_less_than_a_millionth_of_a_pixel_counts_as_on_it(
        (rings, places, support) in scenes(),
        corner in 0..1000_usize,
        (away, angle) in (-10.0..-6.1_f64, 0.0..6.3_f64),
    ) {
        let corner = rings[0][corner % rings[0].len()];
        let beside = corner + 10.0_f64.powf(away) * DVec2::from_angle(angle);
        let places: Vec<DVec2> = places.iter().copied().chain([beside]).collect();
        let Ok(solution) = solved(&project(&rings, &places, support)) else { return Ok(()) };
        let of_handle = |site: &Site| site.kind.handle() == Some(places.len() - 1);
        let site = solution.sites().iter().position(of_handle).expect("a site for each handle");
        prop_assert_eq!(solution.weights_at(beside), Some(vec![(site, 1.0)]));
        let points: Vec<DVec2> = spread(200).chain(places).filter(|&p| solution.weights_at(p).is_some()).collect();
        let [from_corner, from_beside] = [corner, beside].map(|p| solution.distances(p, &points).expect("inside"));
        for ((a, b), p) in from_corner.into_iter().zip(from_beside).zip(points) {
            let (a, b) = (a.unwrap_or(f64::INFINITY), b.unwrap_or(f64::INFINITY));
            prop_assert!(a == b || (a - b).abs() < 2e-6, "{p} is {a} from {corner}, and {b} from {beside}");
        }
    }

    /// However few samples there are: cells are found on a few coarse samples, and many of them are narrower than those are apart.
    #[test]
    fn no_point_of_a_cell_is_farther_than_its_radius((rings, places, support) in scenes()) {
        let mut project = project(&rings, &places, support);
        (project.samples, project.pose.density) = (300, 30);
        let solution = solved(&project).expect("a valid scene");
        let around = |site: &Site| {
            let (rest, scale) = (site.rest, site.separation.min(100.0));
            spread(100).map(move |p| rest + (p / 200.0 - 1.0) * scale)
        };
        let places = spread(2_000).chain(solution.sites().iter().flat_map(around)).chain(rings.iter().flatten().copied());
        let points: Vec<DVec2> = places.filter(|&p| solution.weights_at(p).is_some()).collect();
        let mut nearest = vec![(f64::INFINITY, 0); points.len()];
        for (at, site) in solution.sites().iter().enumerate() {
            let distances = solution.distances(site.rest, &points).expect("sites lie in the domain");
            for (nearest, distance) in nearest.iter_mut().zip(distances) {
                let distance = distance.unwrap_or(f64::INFINITY);
                if distance < nearest.0 { *nearest = (distance, at) }
            }
        }
        for (&(distance, site), p) in nearest.iter().zip(&points).filter(|((distance, _), _)| distance.is_finite()) {
            let Site { rest, cell_radius, .. } = solution.sites()[site];
            prop_assert!(distance <= cell_radius * (1.0 + 1e-9) + 1e-9, "{p} is {distance} from {rest}, not {cell_radius}");
        }
    }

    #[test]
    fn one_motion_of_all_handles_moves_every_point_by_it(
        (rings, places, support) in scenes(),
        shift in (-50.0..50.0_f64, -50.0..50.0_f64),
    ) {
        let shift = DVec2::from(shift);
        let mut project = project(&rings, &places, support);
        let solution = solved(&project).expect("a valid scene");
        project.handles = places.iter().enumerate().map(|(id, &p)| point_handle(id, p, p + shift, 0.0)).collect();
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
        for p in spread(300) {
            let moved = solution.weights_at(p).is_some_and(|weights| !weights.is_empty());
            if let Some(mapped) = solution.map(&pose, p).filter(|_| moved) {
                prop_assert!((mapped.posed - p - shift).length() <= 1e-9);
                prop_assert!((mapped.det - 1.0).abs() <= 1e-6);
            }
        }
    }

    #[test]
    fn the_order_of_handles_does_not_matter((rings, places, support) in scenes(), by in 1..6_usize) {
        let there = project(&rings, &places, support);
        let mut back = there.clone();
        back.handles.rotate_left(by % places.len());
        let (there, back) = (solved(&there).expect("a valid scene"), solved(&back).expect("a valid scene"));
        prop_assert_eq!(there.weights(), back.weights());
        prop_assert_eq!(there.vertices(), back.vertices());
        for p in spread(50) {
            prop_assert_eq!(there.weights_at(p), back.weights_at(p));
        }
    }

    #[test]
    fn harmonic_shares_are_none_negative_and_sum_to_one((rings, places, support) in scenes()) {
        let solution = solved(&project(&rings, &places, support)).expect("a valid scene");
        for site in 0..solution.sites().len() {
            prop_assert!(solution.harmonic_weights(site).all(|(_, share)| share >= 0.0));
            prop_assert!((solution.harmonic_weights(site).map(|(_, share)| share).sum::<f64>() - 1.0).abs() <= UNITY);
        }
        // Converged: at a virtual site each share is the mean of its neighbours'.
        let share = |site: usize, real: usize| {
            solution.harmonic_weights(site).find(|&(of, _)| of == real).map_or(0.0, |(_, share)| share)
        };
        for (real, _) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            let mut residual = vec![0.0; solution.sites().len()];
            for (i, j, weight) in solution.links() {
                let flow = weight * (share(i, real) - share(j, real));
                residual[i] += flow;
                residual[j] -= flow;
            }
            for (site, _) in solution.sites().iter().enumerate().filter(|(_, site)| !site.kind.is_real()) {
                prop_assert!(residual[site].abs() <= 1e-10);
            }
        }
    }

    #[test]
    fn one_handle_alone_moves_everything_rigidly(
        rings in crate::scenes::domains(),
        degrees in -400.0..400.0_f64,
    ) {
        let rest = rings[0].iter().sum::<DVec2>() / rings[0].len() as f64;
        let mut project = project(&rings, &[rest], Support::Paper);
        let Ok(solution) = solved(&project) else { return Ok(()) };
        let posed = rest + DVec2::new(12.0, -7.0);
        project.handles = vec![point_handle(0, rest, posed, degrees)];
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
        for p in spread(100) {
            let weights = solution.weights_at(p);
            if weights.is_some_and(|weights| !weights.is_empty()) {
                let expected = posed + DVec2::from_angle(degrees.to_radians()).rotate(p - rest);
                let mapped = solution.map(&pose, p).expect("inside");
                prop_assert!(mapped.posed.distance(expected) <= 1e-9);
            }
        }
    }
}

#[test]
fn the_scene_moves_and_the_result_moves_with_it() {
    // Far from the origin, where digits are fewer: 1e-12 of 10,000 px.
    let ring = |shift: DVec2| -> Vec<DVec2> {
        let corners = [(20.0, 30.0), (180.0, 20.0), (190.0, 190.0), (120.0, 100.0), (30.0, 180.0)];
        corners.iter().map(|&corner| DVec2::from(corner) + shift).collect()
    };
    let places = [DVec2::new(40.0, 50.0), DVec2::new(160.0, 60.0), DVec2::new(50.0, 150.0)];
    let posed_points = |shift: DVec2| -> Vec<DVec2> {
        let moved: Vec<DVec2> = places.iter().map(|&p| p + shift).collect();
        let mut project = project(&[ring(shift)], &moved, Support::Paper);
        (project.image.width, project.image.height) = (10_300, 300);
        project.handles[0] = point_handle(0, moved[0], moved[0] + DVec2::new(5.0, 25.0), 40.0);
        let solution = solved(&project).expect("a valid scene");
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
        let inside = spread(2000).filter_map(|p| solution.map(&pose, p + shift));
        inside.map(|mapped| mapped.posed - shift).collect()
    };
    let (near, far) = (posed_points(DVec2::ZERO), posed_points(DVec2::new(10_000.0, 100.0)));
    assert!(near.len() > 100 && near.len() == far.len());
    for (a, b) in near.iter().zip(&far) {
        assert!(a.distance(*b) < 1e-6, "{a} and {b}");
    }
}

#[test]
fn a_symmetric_scene_has_a_symmetric_result() {
    let mirror = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    let half =
        [(200.0, 30.0), (330.0, 60.0), (260.0, 150.0), (380.0, 220.0), (270.0, 260.0), (300.0, 380.0), (200.0, 300.0)];
    let right = half.iter().map(|&p| DVec2::from(p));
    let left = half.iter().rev().map(|&p| mirror(p.into())).filter(|p| p.x < 200.0);
    let ring: Vec<DVec2> = right.chain(left).collect();
    let places = [(200.0, 60.0), (350.0, 215.0), (50.0, 215.0), (192.0, 290.0), (208.0, 290.0)].map(DVec2::from);
    let mut project = project(&[ring], &places, Support::Paper);
    project.handles = vec![
        point_handle(0, places[0], places[0] + DVec2::new(0.0, -15.0), 0.0),
        point_handle(1, places[1], places[1] + DVec2::new(20.0, -60.0), -35.0),
        point_handle(2, places[2], places[2] + DVec2::new(-20.0, -60.0), 35.0),
        point_handle(3, places[3], places[3] + DVec2::new(-4.0, 3.0), 10.0),
        point_handle(4, places[4], places[4] + DVec2::new(4.0, 3.0), -10.0),
    ];
    let solution = solved(&project).expect("a valid scene");
    assert!(solution.sites().len() > 8);
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    let mut compared = 0;
    for p in spread(4000) {
        let (Some(here), Some(there)) = (solution.map(&pose, p), solution.map(&pose, mirror(p))) else { continue };
        assert!(mirror(here.posed).distance(there.posed) <= 1e-6, "{p}");
        compared += 1;
    }
    assert!(compared > 1000);
}

#[test]
fn handles_that_are_placed_as_far_apart_as_they_must_be_are_solved() {
    let ring = [(20.0, 20.0), (380.0, 20.0), (380.0, 380.0), (20.0, 380.0)].map(DVec2::from).to_vec();
    for x in [200.0, 333.3] {
        // Differences of coordinates are a hair less than what was meant.
        let places = [DVec2::new(x, 200.0), DVec2::new(x + 0.01, 200.0)];
        assert!(solved(&project(std::slice::from_ref(&ring), &places, Support::Paper)).is_ok(), "at {x}");
    }
}
