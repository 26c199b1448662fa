//! Tests of intrinsic distances against exact geodesics from a visibility graph.

use c2warp::{distance::Navigation, domain::Domain};
use c2warp_tests::{
    outlines::{self, scattered},
    visibility::{Viewpoint, VisibilityGraph},
};
use glam::DVec2;

/// Returns the largest relative error from several sources to many points, with points close to corners among them.
fn worst_error(domain: &Domain) -> f64 {
    let graph = VisibilityGraph::new(domain.rings());
    let navigation = Navigation::new(domain);
    let mut targets = scattered(&graph, 1000, 400);
    // Shadow lines meet at corners, so errors are largest there.
    for ring in domain.rings() {
        let near = ring.iter().flat_map(|&corner| (0..6).map(move |k| corner + 0.7 * DVec2::from_angle(f64::from(k))));
        targets.extend(near.filter(|&p| graph.contains(p)).step_by(7));
    }
    let targets: Vec<Viewpoint> = targets.into_iter().map(|p| graph.viewpoint(p)).collect();
    let mut sources = scattered(&graph, 0, 5);
    // One source on the outline, and one on a corner.
    sources.push((domain.rings()[0][0] + domain.rings()[0][1]) / 2.0);
    sources.push(domain.rings()[0][3]);
    let mut worst = 0.0_f64;
    for source in sources {
        let distances = navigation.distances_from(source).expect("the source lies in the domain");
        let expected = graph.distances(source, &targets);
        for (&Viewpoint { at: p, .. }, expected) in targets.iter().zip(expected) {
            assert!(expected.is_finite());
            let found = distances.to(p).expect("the point lies in the domain");
            let error = (found - expected).abs() / expected.max(1.0);
            if error > 1e-6 {
                eprintln!("{source} → {p}: {found} for {expected}");
            }
            worst = worst.max(error);
        }
    }
    worst
}

/// Both computations sum the same square roots, so they differ by rounding: about 1e-15 per corner of the path. Points
/// within the tolerance of a shadow line (1e-9 px) may differ by that tolerance.
const EXACT: f64 = 1e-9;

#[test]
fn distances_are_exact_in_a_gingerbread_figure() {
    assert!(worst_error(&outlines::polygon(&outlines::gingerbread())) < EXACT);
}

#[test]
fn distances_are_exact_in_a_spiral() {
    assert!(worst_error(&outlines::polygon(&outlines::spiral())) < EXACT);
}

#[test]
fn distances_are_exact_around_a_hole() {
    assert!(worst_error(&outlines::polygon(&outlines::holed_square())) < EXACT);
}

#[test]
fn distances_are_exact_in_a_comb() {
    assert!(worst_error(&outlines::polygon(&outlines::comb())) < EXACT);
}

#[test]
fn distances_are_exact_in_the_outline_of_a_picture() {
    let domain = outlines::alpha();
    assert!(domain.rings().iter().map(Vec::len).sum::<usize>() > 500);
    assert_eq!(domain.holes(), 2);
    assert!(worst_error(&domain) < EXACT);
}

/// A point on an edge is on it within rounding only. The closer the corner, the more rounding turns the direction to
/// it.
#[test]
fn paths_along_an_edge_turn_around_close_corners() {
    let domain = outlines::alpha();
    let navigation = Navigation::new(&domain);
    let mut count = 0;
    for ring in domain.rings() {
        let n = ring.len();
        let ends = (0..n).flat_map(|i| [(i, (i + 1) % n), (i, (i + n - 1) % n)]).map(|(i, j)| (ring[i], ring[j]));
        for ((corner, other), away) in ends.flat_map(|ends| [1.0, 0.1, 0.01, 1e-3, 1e-4].map(|away| (ends, away))) {
            let source = corner.lerp(other, (away / corner.distance(other)).min(0.5));
            let distances = navigation.distances_within(source, 4.0).expect("a point of the outline");
            for p in (0..6).map(|k| corner + 0.2 * DVec2::from_angle(f64::from(k))) {
                if let Some(located) = navigation.located(p) {
                    let longest = source.distance(corner) + corner.distance(p);
                    let found = distances.to_located(located).unwrap_or(f64::INFINITY);
                    assert!(found <= longest + EXACT, "{source} → {p} via {corner}: {found} for {longest}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 10_000, "{count}");
}

#[test]
fn distances_in_a_convex_domain_are_euclidean() {
    let domain = outlines::polygon(&outlines::disc());
    let graph = VisibilityGraph::new(domain.rings());
    let navigation = Navigation::new(&domain);
    let source = DVec2::new(333.0, 444.0);
    let distances = navigation.distances_from(source).expect("inside");
    for p in scattered(&graph, 0, 2000) {
        let found = distances.to(p).expect("inside");
        assert!((found - source.distance(p)).abs() <= 1e-12 * source.distance(p));
    }
}
