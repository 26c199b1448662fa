//! Properties of the mesh over samples.

use std::collections::{BTreeSet, HashMap};

use glam::DVec2;
use proptest::prelude::*;

use super::{CoarseSamples, base::BaseSamples, samples::Samples};
use crate::{
    domain::Domain,
    picture::Picture,
    prepared_domain::PreparedDomain,
    triangulation::{NONE, OUTLINE_TOLERANCE, Triangulation, signed_depth},
};

const SIZE: (u32, u32) = (96, 64);

/// Polygons of a mesh, each by its vertices. Triangles of an ambiguous triangulation form one polygon.
fn polygons(mesh: &Triangulation) -> BTreeSet<Vec<u32>> {
    let mut polygons = BTreeSet::new();
    mesh.visit_polygons(
        |_| true,
        |edges| {
            let mut corners: Vec<u32> = edges.iter().map(|[a, _]| *a).collect();
            corners.sort_unstable();
            polygons.insert(corners);
        },
    );
    polygons
}

/// Checks that a mesh is the constrained Delaunay mesh of the domain.
fn check(samples: &Samples, domain: &Domain) {
    let Samples { mesh, outline, .. } = samples;
    let mut area = 0.0;
    let mut walls = BTreeSet::new();
    for (t, (corners, neighbours)) in mesh.triangles.iter().zip(&mesh.neighbours).enumerate() {
        let [a, b, c] = mesh.corners(t);
        let twice = (b - a).perp_dot(c - a);
        assert!(twice > 0.0, "triangle {t} is inverted: {twice}");
        area += twice / 2.0;
        for k in 0..3 {
            let edge = [corners[k], corners[(k + 1) % 3]];
            if neighbours[k] == NONE {
                walls.insert(edge);
                continue;
            }
            let other = neighbours[k] as usize;
            let back = mesh.neighbours[other].iter().position(|&n| n as usize == t).expect("neighbours are mutual");
            assert_eq!([mesh.triangles[other][(back + 1) % 3], mesh.triangles[other][back]], edge);
        }
    }
    assert!((area / domain.area() - 1.0).abs() < 1e-9, "{area} of {}", domain.area());
    let edges = |ring: &Vec<u32>| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect::<Vec<_>>();
    let segments: BTreeSet<[u32; 2]> = outline.iter().flat_map(edges).collect();
    assert_eq!(walls, segments, "the outline bounds the mesh");
    let segments = segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    let whole = Triangulation::constrained_delaunay(mesh.vertices.clone(), segments);
    assert_eq!(polygons(mesh), polygons(&whole));
}

/// Checks the samples of a domain with bones and sites at some of its points. `seeds` are positions in its bounding
/// box.
fn check_samples(domain: Domain, count: usize, seeds: &[(f64, f64)]) {
    let (low, high) = domain.bounds();
    let prepared = PreparedDomain::without_picture(domain);
    let places = seeds.iter().map(|&(x, y)| low + (high - low) * DVec2::new(x, y));
    let inside: Vec<DVec2> = places.filter(|&p| prepared.navigation.triangle_at(p).is_some()).collect();
    let is_clear = |&[a, b]: &[DVec2; 2]| {
        (0..=200).all(|i| prepared.navigation.triangle_at(a.lerp(b, f64::from(i) / 200.0)).is_some())
    };
    let bones: Vec<[DVec2; 2]> = inside.windows(2).step_by(2).map(|pair| [pair[0], pair[1]]).filter(is_clear).collect();
    let base = BaseSamples::new(&prepared, &bones, count);
    check(&base.with_sites(&prepared, &[]), &prepared.domain);
    check(&base.with_sites(&prepared, &inside), &prepared.domain);
    let samples = base.with_sites(&prepared, &[]);
    for (p, triangle) in samples.mesh.vertices.iter().zip(&samples.nav_triangles) {
        let own = prepared.navigation.triangle_at(*p).expect("samples lie in the domain");
        let is_tie = prepared.navigation.is_on_edge(own, *p);
        assert!(own == *triangle || is_tie, "{p} lies in {own:?}, not in {triangle:?}");
    }
}

/// A domain of discs, without other discs: it has holes, necks and specks.
fn blobs() -> impl Strategy<Value = Domain> {
    let disc = |radius: std::ops::Range<f64>| (0.0..96.0, 0.0..64.0, radius);
    let discs = (prop::collection::vec(disc(2.0..25.0), 1..7), prop::collection::vec(disc(1.0..9.0), 0..7));
    discs.prop_filter_map("nothing is visible", |(filled, empty)| {
        let within = |discs: &[(f64, f64, f64)], p: DVec2| discs.iter().any(|&(x, y, r)| p.distance((x, y).into()) < r);
        let alpha = |i: u32| {
            let p = DVec2::new(f64::from(i % SIZE.0) + 0.5, f64::from(i / SIZE.0) + 0.5);
            if within(&filled, p) && !within(&empty, p) { 255 } else { 0 }
        };
        let rgba: Vec<u8> = (0..SIZE.0 * SIZE.1).flat_map(|i| [0, 0, 0, alpha(i)]).collect();
        Domain::bounded(None, &Picture::new(SIZE.0, SIZE.1, &rgba).ok()?, false).ok()
    })
}

/// A star-shaped ring with corners in random directions around a centre, by their distances.
fn star(centre: DVec2, radii: &[f64], scale: DVec2) -> Vec<DVec2> {
    let corner = |(i, radius): (usize, &f64)| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * i as f64 / radii.len() as f64);
        centre + *radius * DVec2::new(cos, sin) * scale
    };
    radii.iter().enumerate().map(corner).collect()
}

/// A star-shaped ring with a star-shaped hole: long spikes and thin necks between both.
fn stars() -> impl Strategy<Value = Domain> {
    let radii = |from: f64, to: f64| prop::collection::vec(from..to, 3..24);
    (radii(8.0, 60.0), radii(0.5, 7.5), 0.05..1.0).prop_filter_map("rings cross", |(outer, hole, flat)| {
        let rings = [outer, hole].map(|radii| star(DVec2::new(64.0, 64.0), &radii, DVec2::new(1.0, flat)));
        Domain::from_polygon(&rings, 128, 128).ok()
    })
}

fn seeds() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((0.0..1.0, 0.0..1.0), 0..8)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn mesh_of_blobs_is_constrained_delaunay(domain in blobs(), count in 20..2500_usize, seeds in seeds()) {
        check_samples(domain, count, &seeds);
    }

    #[test]
    fn mesh_of_stars_is_constrained_delaunay(domain in stars(), count in 20..2500_usize, seeds in seeds()) {
        check_samples(domain, count, &seeds);
    }

    #[test]
    fn mesh_of_a_mirrored_domain_mirrors_itself(
        half in prop::collection::vec(3.0..60.0, 3..12),
        flat in 0.2..1.0,
        count in 50..2500_usize,
    ) {
        // The first and the last corner of the half lie on the axis.
        let radii: Vec<f64> = half.iter().chain(half[1..half.len() - 1].iter().rev()).copied().collect();
        let ring = star(DVec2::splat(64.0), &radii, DVec2::new(1.0, flat));
        let Ok(domain) = Domain::from_polygon(&[ring], 128, 128) else { return Ok(()) };
        let prepared = PreparedDomain::without_picture(domain);
        let samples = BaseSamples::new(&prepared, &[], count).with_sites(&prepared, &[]);
        let middle = (prepared.domain.bounds().0.y + prepared.domain.bounds().1.y) / 2.0;
        // Mirrored places differ by rounding.
        let key = |p: DVec2| [p.x, p.y - middle].map(|x| (x * 1e6).round() as i64);
        let known: HashMap<_, u32> = samples.mesh.vertices.iter().map(|&p| key(p)).zip(0..).collect();
        let mirrored = |v: &u32| {
            let [x, y] = key(samples.mesh.vertices[*v as usize]);
            let near = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [x + dx, -y + dy]));
            near.into_iter().find_map(|key| known.get(&key)).copied()
        };
        let own = polygons(&samples.mesh);
        for polygon in &own {
            let mut other: Vec<u32> = polygon.iter().map(|v| mirrored(v).expect("samples mirror themselves")).collect();
            other.sort_unstable();
            prop_assert!(own.contains(&other), "{polygon:?}");
        }
    }
}

/// Walks between the rays get stuck.
#[test]
fn coarse_triangles_of_a_star_contain_their_points() {
    let corner = |at: u32| {
        let radius = if at.is_multiple_of(2) { 100.0 } else { 40.0 };
        let (sin, cos) = libm::sincos(f64::from(at) * std::f64::consts::PI / 60.0);
        DVec2::splat(100.0) + radius * DVec2::new(cos, sin)
    };
    let outline: Vec<DVec2> = (0..120).map(corner).collect();
    let prepared =
        PreparedDomain::without_picture(Domain::from_rings(std::slice::from_ref(&outline)).expect("a domain"));
    let base = BaseSamples::new(&prepared, &[], 500);
    let coarse = CoarseSamples::new(&base, &prepared, &[]);
    for (at, &corner) in outline.iter().enumerate() {
        let next = outline[(at + 1) % outline.len()];
        for step in 0..8 {
            let p = corner.lerp(next, f64::from(step) / 8.0);
            let depth = signed_depth(coarse.mesh.corners(coarse.triangle_at(p)), p);
            assert!(depth >= -OUTLINE_TOLERANCE, "{p} is {depth} px outside");
        }
    }
}
