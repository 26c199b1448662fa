//! Property tests of section III-C of the paper on random scenes.

use c2warp::{Solution, project::Support, site::Site};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::point_handle;
use crate::scenes::{cases, project, scenes, solved, spread};

/// Tolerance for the sum of about a dozen weights, each rounded to 1e-16.
const SUM_TOLERANCE: f64 = 1e-12;

/// Checks that the weights at `p` are non-negative and sum to 1.
fn check_weights(weights: &[(usize, f64)], p: DVec2) -> Result<(), TestCaseError> {
    prop_assert!(weights.iter().all(|&(_, weight)| weight >= 0.0), "a negative weight at {p}");
    let sum: f64 = weights.iter().map(|&(_, weight)| weight).sum();
    prop_assert!(weights.is_empty() || (sum - 1.0).abs() <= SUM_TOLERANCE, "weights at {p} sum to {sum}");
    Ok(())
}

/// Returns whether the island of a sample has a handle. Then its sites must cover the sample.
fn is_reached(solution: &Solution, sample: usize) -> bool {
    solution.nearest_site(sample).is_some()
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn weights_are_non_negative_and_sum_to_one((rings, positions, support) in scenes()) {
        let solution = solved(&project(&rings, &positions, support)).expect("a valid scene");
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
    fn islands_with_a_handle_are_covered((rings, positions, support) in scenes()) {
        let solution = solved(&project(&rings, &positions, support)).expect("a valid scene");
        for sample in (0..solution.samples()).filter(|&sample| is_reached(&solution, sample)) {
            prop_assert!(solution.phi_sums()[sample] > 0.0);
            prop_assert!(solution.weights().row(sample).next().is_some());
        }
        // Points between samples have weights exactly if the samples of their island have weights.
        let islands_without_handles = (0..solution.samples()).any(|sample| !is_reached(&solution, sample));
        for p in spread(500) {
            if let Some(weights) = solution.weights_at(p) {
                prop_assert!(!weights.is_empty() || islands_without_handles, "nothing covers {p}");
            }
        }
    }

    #[test]
    fn handle_has_full_weight_at_its_rest_position((rings, positions, support) in scenes()) {
        let solution = solved(&project(&rings, &positions, support)).expect("a valid scene");
        for (site, real) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            prop_assert_eq!(solution.weights_at(real.rest), Some(vec![(site, 1.0)]));
        }
    }

    #[test]
    fn supports_cover_their_cells_and_avoid_real_sites((rings, positions, support) in scenes()) {
        let solution = solved(&project(&rings, &positions, support)).expect("a valid scene");
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

    /// Coordinates rounded to six digits move a handle by this much.
    #[test]
    fn handle_within_a_millionth_of_a_pixel_of_a_corner_is_on_it(
        (rings, positions, support) in scenes(),
        corner in 0..1000_usize,
        (away, angle) in (-10.0..-6.1_f64, 0.0..6.3_f64),
    ) {
        let corner = rings[0][corner % rings[0].len()];
        let nearby = corner + 10.0_f64.powf(away) * DVec2::from_angle(angle);
        let positions: Vec<DVec2> = positions.iter().copied().chain([nearby]).collect();
        let Ok(solution) = solved(&project(&rings, &positions, support)) else { return Ok(()) };
        let of_handle = |site: &Site| site.kind.handle() == Some(positions.len() - 1);
        let site = solution.sites().iter().position(of_handle).expect("a site for each handle");
        prop_assert_eq!(solution.weights_at(nearby), Some(vec![(site, 1.0)]));
        let points: Vec<DVec2> = spread(200).chain(positions).filter(|&p| solution.weights_at(p).is_some()).collect();
        let [from_corner, from_nearby] = [corner, nearby].map(|p| solution.distances(p, &points).expect("inside"));
        for ((a, b), p) in from_corner.into_iter().zip(from_nearby).zip(points) {
            let (a, b) = (a.unwrap_or(f64::INFINITY), b.unwrap_or(f64::INFINITY));
            prop_assert!(a == b || (a - b).abs() < 2e-6, "{p} is {a} from {corner}, and {b} from {nearby}");
        }
    }

    /// However few samples there are: cells are found on a few coarse samples, and many of them are narrower than those
    /// are apart.
    #[test]
    fn cell_radius_bounds_the_distance_of_every_point((rings, positions, support) in scenes()) {
        let mut project = project(&rings, &positions, support);
        (project.samples, project.pose.density) = (300, 30);
        let solution = solved(&project).expect("a valid scene");
        let around = |site: &Site| {
            let (rest, scale) = (site.rest, site.separation.min(100.0));
            spread(100).map(move |p| rest + (p / 200.0 - 1.0) * scale)
        };
        let positions = spread(2_000).chain(solution.sites().iter().flat_map(around)).chain(rings.iter().flatten().copied());
        let points: Vec<DVec2> = positions.filter(|&p| solution.weights_at(p).is_some()).collect();
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
    fn common_translation_moves_every_point(
        (rings, positions, support) in scenes(),
        shift in (-50.0..50.0_f64, -50.0..50.0_f64),
    ) {
        let shift = DVec2::from(shift);
        let mut project = project(&rings, &positions, support);
        let solution = solved(&project).expect("a valid scene");
        project.handles = positions.iter().enumerate().map(|(id, &p)| point_handle(id, p, p + shift, 0.0)).collect();
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
    fn order_of_handles_does_not_matter((rings, positions, support) in scenes(), by in 1..6_usize) {
        let there = project(&rings, &positions, support);
        let mut back = there.clone();
        back.handles.rotate_left(by % positions.len());
        let (there, back) = (solved(&there).expect("a valid scene"), solved(&back).expect("a valid scene"));
        prop_assert_eq!(there.weights(), back.weights());
        prop_assert_eq!(there.vertices(), back.vertices());
        for p in spread(50) {
            prop_assert_eq!(there.weights_at(p), back.weights_at(p));
        }
    }

    #[test]
    fn harmonic_weights_are_non_negative_and_sum_to_one((rings, positions, support) in scenes()) {
        let solution = solved(&project(&rings, &positions, support)).expect("a valid scene");
        for site in 0..solution.sites().len() {
            prop_assert!(solution.harmonic_weights(site).all(|(_, harmonic)| harmonic >= 0.0));
            prop_assert!((solution.harmonic_weights(site).map(|(_, harmonic)| harmonic).sum::<f64>() - 1.0).abs() <= SUM_TOLERANCE);
        }
        // Converged: at a virtual site each harmonic field is the weighted mean of its neighbours.
        let harmonic = |site: usize, real: usize| {
            solution.harmonic_weights(site).find(|&(of, _)| of == real).map_or(0.0, |(_, harmonic)| harmonic)
        };
        for (real, _) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
            let mut residual = vec![0.0; solution.sites().len()];
            for (i, j, weight) in solution.links() {
                let flow = weight * (harmonic(i, real) - harmonic(j, real));
                residual[i] += flow;
                residual[j] -= flow;
            }
            for (site, _) in solution.sites().iter().enumerate().filter(|(_, site)| !site.kind.is_real()) {
                prop_assert!(residual[site].abs() <= 1e-10);
            }
        }
    }

    #[test]
    fn single_handle_moves_everything_rigidly(
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
fn translated_scene_has_the_translated_result() {
    // Far from the origin coordinates have fewer digits: 1e-12 of 10,000 px.
    let ring = |shift: DVec2| -> Vec<DVec2> {
        let corners = [(20.0, 30.0), (180.0, 20.0), (190.0, 190.0), (120.0, 100.0), (30.0, 180.0)];
        corners.iter().map(|&corner| DVec2::from(corner) + shift).collect()
    };
    let positions = [DVec2::new(40.0, 50.0), DVec2::new(160.0, 60.0), DVec2::new(50.0, 150.0)];
    let posed_points = |shift: DVec2| -> Vec<DVec2> {
        let moved: Vec<DVec2> = positions.iter().map(|&p| p + shift).collect();
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
fn symmetric_scene_has_a_symmetric_result() {
    let mirror = |p: DVec2| DVec2::new(400.0 - p.x, p.y);
    let half =
        [(200.0, 30.0), (330.0, 60.0), (260.0, 150.0), (380.0, 220.0), (270.0, 260.0), (300.0, 380.0), (200.0, 300.0)];
    let right = half.iter().map(|&p| DVec2::from(p));
    let left = half.iter().rev().map(|&p| mirror(p.into())).filter(|p| p.x < 200.0);
    let ring: Vec<DVec2> = right.chain(left).collect();
    let positions = [(200.0, 60.0), (350.0, 215.0), (50.0, 215.0), (192.0, 290.0), (208.0, 290.0)].map(DVec2::from);
    let mut project = project(&[ring], &positions, Support::Paper);
    project.handles = vec![
        point_handle(0, positions[0], positions[0] + DVec2::new(0.0, -15.0), 0.0),
        point_handle(1, positions[1], positions[1] + DVec2::new(20.0, -60.0), -35.0),
        point_handle(2, positions[2], positions[2] + DVec2::new(-20.0, -60.0), 35.0),
        point_handle(3, positions[3], positions[3] + DVec2::new(-4.0, 3.0), 10.0),
        point_handle(4, positions[4], positions[4] + DVec2::new(4.0, 3.0), -10.0),
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
fn handles_at_the_smallest_allowed_distance_are_solved() {
    let ring = [(20.0, 20.0), (380.0, 20.0), (380.0, 380.0), (20.0, 380.0)].map(DVec2::from).to_vec();
    for x in [200.0, 333.3] {
        // The difference of these coordinates is slightly less than 0.01.
        let positions = [DVec2::new(x, 200.0), DVec2::new(x + 0.01, 200.0)];
        assert!(solved(&project(std::slice::from_ref(&ring), &positions, Support::Paper)).is_ok(), "at {x}");
    }
}
