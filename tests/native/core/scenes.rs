//! Random scenes for property tests: domains with handles, and projects for them.

use c2warp::{
    Error, Picture, Solution,
    deform::{PictureMesh, Pose},
    project::{DomainSpec, ImageRef, PoseMode, Project, Support},
    solve,
};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::point_handle;

/// Returns the configuration of a property test with `cases` cases. The seed is fixed, so every run is the same.
pub(crate) fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2016),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// Width and height of the pictures in pixels.
pub(crate) const SIZE: u32 = 400;

/// Returns a star-shaped ring about `centre` with one radius per direction.
fn star(centre: DVec2, radii: &[f64]) -> Vec<DVec2> {
    let turn = std::f64::consts::TAU / radii.len() as f64;
    radii.iter().enumerate().map(|(i, &radius)| centre + radius * DVec2::from_angle(turn * i as f64)).collect()
}

fn convex() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    (120.0..180.0_f64, 5..40_usize).prop_map(|(radius, n)| vec![star(DVec2::splat(200.0), &vec![radius; n])])
}

fn concave() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    proptest::collection::vec(60.0..190.0_f64, 6..30).prop_map(|radii| vec![star(DVec2::splat(200.0), &radii)])
}

fn with_holes() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let hole = || proptest::collection::vec(8.0..35.0_f64, 4..12);
    (proptest::collection::vec(150.0..190.0_f64, 12..30), hole(), hole()).prop_map(|(outer, first, second)| {
        vec![
            star(DVec2::splat(200.0), &outer),
            star(DVec2::new(150.0, 190.0), &first),
            star(DVec2::new(245.0, 215.0), &second),
        ]
    })
}

fn islands() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let island = || proptest::collection::vec(35.0..90.0_f64, 5..20);
    (island(), island())
        .prop_map(|(left, right)| vec![star(DVec2::new(100.0, 200.0), &left), star(DVec2::new(300.0, 200.0), &right)])
}

/// Rings of convex and concave domains, domains with holes, and domains of two islands.
pub(crate) fn domains() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    prop_oneof![convex(), concave(), with_holes(), islands()]
}

/// Positions of handles. The last one may be close to the first one.
pub(crate) fn positions() -> impl Strategy<Value = Vec<DVec2>> {
    let anywhere = || (10.0..390.0_f64, 10.0..390.0_f64).prop_map(DVec2::from);
    (proptest::collection::vec(anywhere(), 1..7), proptest::option::of((-2.0..1.5_f64, 0.0..6.0_f64))).prop_map(
        |(mut positions, close)| {
            if let Some((exponent, angle)) = close {
                // A gap of 0.01 to 30 px.
                let gap = 10.0_f64.powf(exponent) + 0.001;
                positions.push(positions[0] + gap * DVec2::from_angle(angle));
            }
            positions
        },
    )
}

/// Returns a project with point handles at rest. Without rings it has no domain of its own.
pub(crate) fn project(rings: &[Vec<DVec2>], positions: &[DVec2], support: Support) -> Project {
    let mut project = Project::new(ImageRef::new("white.png", SIZE, SIZE));
    project.domain = (!rings.is_empty()).then(|| DomainSpec::polygon(rings.to_vec()));
    project.samples = 1500;
    project.weighting.support = support;
    project.handles = positions.iter().enumerate().map(|(id, &p)| point_handle(id, p, p, 0.0)).collect();
    project
}

/// Solves a project with a white picture.
pub(crate) fn solved(project: &Project) -> Result<Solution, Error> {
    let (width, height) = (project.image.width, project.image.height);
    let rgba = vec![255; width as usize * height as usize * 4];
    solve(project, &Picture::new(width, height, &rgba).expect("a picture of fair size"))
}

/// Scenes that can be solved: rings, positions of handles and support. All handles are inside, and there is at least
/// one.
pub(crate) fn scenes() -> impl Strategy<Value = (Vec<Vec<DVec2>>, Vec<DVec2>, Support)> {
    let support = prop_oneof![Just(Support::Paper), Just(Support::Smooth)];
    (domains(), positions(), support).prop_filter_map("no handle in the domain", |(rings, positions, support)| {
        let positions: Vec<DVec2> = positions.into_iter().filter(|&p| is_inside(&rings, p)).collect();
        (!positions.is_empty()).then_some((rings, positions, support))
    })
}

/// Returns whether `p` is inside the rings, by the even-odd rule.
pub(crate) fn is_inside(rings: &[Vec<DVec2>], p: DVec2) -> bool {
    rings.iter().filter(|ring| contains(ring, p)).count() % 2 == 1
}

fn contains(ring: &[DVec2], p: DVec2) -> bool {
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    let crossings =
        edges.filter(|(a, b)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x));
    crossings.count() % 2 == 1
}

/// Returns points that are spread evenly over the picture.
pub(crate) fn spread(count: usize) -> impl Iterator<Item = DVec2> {
    // Roberts' R2 sequence: multiples of the powers of the plastic number.
    let at = |i: usize| {
        let i = i as f64;
        DVec2::new((0.754_877_666_246_692_7 * i).fract(), (0.569_840_290_998_053_2 * i).fract()) * f64::from(SIZE)
    };
    (1..=count).map(at)
}

/// The mesh that a page makes a posed picture of, without a static background.
pub(crate) fn mesh_of(solution: &Solution) -> PictureMesh {
    PictureMesh {
        vertices: solution.vertices().to_vec(),
        triangles: solution.triangles().to_vec(),
        samples: solution.samples(),
        weights: solution.weights().clone(),
        background: Vec::new(),
    }
}

/// The area of each triangle whose corners are samples, divided by its area at rest.
pub(crate) fn area_ratios(solution: &Solution, posed: &[DVec2]) -> Vec<f64> {
    let area = |triangle: &[u32; 3], places: &[DVec2]| {
        let [a, b, c] = triangle.map(|vertex| places[vertex as usize]);
        (b - a).perp_dot(c - a)
    };
    let is_between = |triangle: &&[u32; 3]| triangle.iter().all(|&vertex| (vertex as usize) < solution.samples());
    let ratio = |triangle: &[u32; 3]| area(triangle, posed) / area(triangle, solution.vertices());
    solution.triangles().iter().filter(is_between).map(ratio).collect()
}

/// The tolerance for a pose and its mirror image, in pixels. It allows for rounding. `None` in the rigid mode if a
/// triangle has lost half of its area. Such triangles enter the energy, but the mesh is not symmetric.
pub(crate) fn symmetric_within(mode: PoseMode, solution: &Solution, pose: &Pose) -> Option<f64> {
    let ratios = || area_ratios(solution, &solution.posed_vertices(pose)).into_iter();
    (mode == PoseMode::Harmonic || ratios().all(|ratio| ratio > 0.5)).then_some(1e-6)
}
