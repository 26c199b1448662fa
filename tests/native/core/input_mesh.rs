//! Tests of input meshes.

use c2warp::{
    Error, InputMesh, Solution,
    project::{PoseMode, Rotation, Support},
    solve_mesh,
};
use glam::DVec2;
use proptest::prelude::*;

use crate::handles::{bar, point_handle};
use crate::scenes::{cases, project, scenes, solved, spread};

/// Tolerance for weights: the order of triangles and corners changes the rounding of virtual sites.
const ROUNDING: f64 = 1e-7;

type Triangles = Vec<[u32; 3]>;

/// Returns the vertices and triangles of a solution's mesh.
fn own_mesh(solution: &Solution) -> (Vec<DVec2>, Triangles) {
    (solution.vertices().to_vec(), solution.triangles().to_vec())
}

/// Returns a grid of quads of two triangles each. The orientation of the triangles varies.
fn grid(columns: u32, rows: u32, spacing: f64) -> (Vec<DVec2>, Triangles) {
    let vertices = (0..rows).flat_map(|y| (0..columns).map(move |x| spacing * DVec2::new(x.into(), y.into())));
    let quads = (0..rows - 1).flat_map(|y| (0..columns - 1).map(move |x| y * columns + x));
    let triangles = quads.flat_map(|a| [[a, a + 1, a + columns + 1], [a, a + columns + 1, a + columns]]);
    let turned = |(at, [a, b, c]): (usize, [u32; 3])| if at % 3 == 0 { [a, c, b] } else { [a, b, c] };
    (vertices.collect(), triangles.enumerate().map(turned).collect())
}

fn solved_on(mesh: (Vec<DVec2>, Triangles), positions: &[DVec2]) -> Solution {
    let mesh = InputMesh::new(mesh.0, mesh.1).expect("a mesh");
    solve_mesh(&project(&[], positions, Support::Paper), &mesh).expect("a scene that can be solved")
}

fn mesh_error(vertices: &[(f64, f64)], triangles: &[[u32; 3]]) -> Error {
    let vertices = vertices.iter().copied().map(DVec2::from).collect();
    let error = InputMesh::new(vertices, triangles.to_vec()).expect_err("no mesh");
    assert!(matches!(error.code(), "mesh" | "domain"));
    error
}

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn mesh_of_a_solution_gives_the_same_solution((rings, positions, support) in scenes()) {
        let project = project(&rings, &positions, support);
        let own = solved(&project).expect("a valid scene");
        let (vertices, triangles) = own_mesh(&own);
        let mesh = InputMesh::new(vertices, triangles).expect("a valid mesh");
        let given = solve_mesh(&project, &mesh).expect("solved before");
        prop_assert_eq!(given.vertices(), own.vertices());
        prop_assert_eq!(given.domain().rings().len(), own.domain().rings().len());
        prop_assert_eq!(given.sites().len(), own.sites().len());
        for p in spread(500) {
            let (Some(given), Some(own)) = (given.weights_at(p), own.weights_at(p)) else { continue };
            let weight = |of: &[(usize, f64)], site: usize| {
                of.iter().find(|entry| entry.0 == site).map_or(0.0, |entry| entry.1)
            };
            for &(site, _) in given.iter().chain(&own) {
                prop_assert!((weight(&given, site) - weight(&own, site)).abs() < ROUNDING, "site {site} at {p}");
            }
        }
    }
}

#[test]
fn handles_between_vertices_have_full_weight() {
    let positions = [(33.0, 41.0), (257.5, 120.25), (90.0, 180.0), (36.0, 44.5)].map(DVec2::from);
    let (vertices, triangles) = grid(33, 21, 10.0);
    let solution = solved_on((vertices.clone(), triangles), &positions);
    assert_eq!(solution.vertices(), vertices);
    assert_eq!(solution.samples(), vertices.len());
    assert_eq!(solution.weights().len(), vertices.len());
    for (v, &p) in vertices.iter().enumerate() {
        let row: Vec<(usize, f64)> = solution.weights().row(v).collect();
        assert!((row.iter().map(|entry| entry.1).sum::<f64>() - 1.0).abs() < 1e-12, "at {p}");
        assert!(row.iter().all(|entry| entry.1 >= 0.0), "at {p}");
        for (site, weight) in solution.weights_at(p).expect("a vertex") {
            let known = row.iter().find(|entry| entry.0 == site).map_or(0.0, |entry| entry.1);
            assert!((known - weight).abs() < 1e-12, "site {site} at {p}");
        }
    }
    for (site, real) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
        assert_eq!(solution.weights_at(real.rest), Some(vec![(site, 1.0)]));
    }
}

#[test]
fn position_of_a_mesh_does_not_change_its_deformation() {
    let moves = [((0.06, 0.2), (0.1, 0.3)), ((0.52, 0.21), (0.52, 0.02)), ((0.94, 0.2), (0.9, 0.34))];
    let bent = |by: DVec2| {
        let (vertices, triangles) = grid(41, 17, 0.025);
        let mesh = InputMesh::new(vertices.iter().map(|&p| p + by).collect(), triangles).expect("a mesh");
        let mut project = project(&[], &[], Support::Smooth);
        // With 40, two cells tie for the next site, and rounding decides between them.
        (project.pose.mode, project.pose.density) = (PoseMode::Rigid, 44);
        for (id, (rest, posed)) in moves.into_iter().enumerate() {
            let handle = point_handle(id, DVec2::from(rest) + by, DVec2::from(posed) + by, 0.0);
            project.handles.push(handle.turned(Rotation::Auto));
        }
        let solution = solve_mesh(&project, &mesh).expect("a scene that can be solved");
        let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
        (solution.sites().len(), solution.posed_vertices(&pose).iter().map(|&p| p - by).collect::<Vec<_>>())
    };
    let ((sites, here), (far_sites, there)) = (bent(DVec2::ZERO), bent(DVec2::new(999_999.0, -1e6)));
    assert_eq!(sites, far_sites);
    let difference = here.iter().zip(&there).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
    // Gradients are finite differences over 1e-5 of a part, so rounding errors grow accordingly.
    assert!(difference < 1e-4, "{difference}");
}

#[test]
fn distances_go_around_a_notch_of_the_boundary() {
    // Remove the quads in columns 4 and 5 of the upper three rows.
    let (vertices, triangles) = grid(11, 6, 10.0);
    let middle = |t: &[u32; 3]| t.iter().map(|&v| vertices[v as usize]).sum::<DVec2>() / 3.0;
    let kept = |t: &&[u32; 3]| !((40.0..60.0).contains(&middle(t).x) && middle(t).y < 30.0);
    let mut kept: Triangles = triangles.iter().filter(kept).copied().collect();
    // Remove the vertices inside the notch and renumber the others.
    let mut used: Vec<u32> = kept.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    for v in kept.iter_mut().flatten() {
        *v = used.binary_search(v).expect("used") as u32;
    }
    let vertices = used.iter().map(|&v| vertices[v as usize]).collect();
    let solution = solved_on((vertices, kept), &[(20.0, 10.0).into(), (80.0, 10.0).into()]);
    assert_eq!(
        solution.domain().rings(),
        [[(0, 0), (40, 0), (40, 30), (60, 30), (60, 0), (100, 0), (100, 50), (0, 50)]
            .map(|(x, y)| DVec2::new(x.into(), y.into()))]
    );
    let far = solution.distances((20.0, 10.0).into(), &[(80.0, 10.0).into()]).expect("inside")[0].expect("one part");
    assert!((far - (20.0 + 2.0 * 800.0_f64.sqrt())).abs() < 1e-12);
}

#[test]
fn holes_and_islands_follow_from_the_boundary() {
    let (vertices, triangles) = grid(4, 4, 10.0);
    let ring: Triangles = triangles.iter().enumerate().filter(|&(t, _)| t / 2 != 4).map(|(_, &t)| t).collect();
    let island = [(14.0, 14.0), (16.0, 14.0), (15.0, 16.0)].map(DVec2::from);
    let vertices: Vec<DVec2> = vertices.into_iter().chain(island).collect();
    let solution = solved_on((vertices, ring.into_iter().chain([[16, 17, 18]]).collect()), &[(5.0, 5.0).into()]);
    assert_eq!((solution.domain().islands(), solution.domain().holes()), (2, 1));
    assert_eq!(solution.weights().row(16).count(), 0);
    assert_eq!(solution.weights().row(0).count(), 1);
}

#[test]
fn coarse_and_needle_like_meshes_are_solved() {
    let square = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)].map(DVec2::from);
    let positions = [(20.0, 20.0), (20.02, 20.0), (70.0, 60.0), (100.0, 100.0)].map(DVec2::from);
    let solution = solved_on((square.to_vec(), vec![[0, 1, 2], [0, 2, 3]]), &positions);
    assert!((0..4).all(|v| solution.weights().row(v).next().is_some()));
    let (vertices, triangles) = grid(30, 30, 1.0);
    let squeezed: Vec<DVec2> = vertices.iter().map(|p| DVec2::new(p.x * 10.0, p.y * 1e-3)).collect();
    let solution = solved_on((squeezed, triangles.clone()), &[(100.0, 0.01).into(), (200.0, 0.02).into()]);
    assert!((0..900).all(|v| solution.weights().row(v).next().is_some()));
    // Coordinates of 32 bits: a boundary that is almost straight.
    let turned: Vec<DVec2> =
        vertices.iter().map(|p| (DVec2::from_angle(0.3).rotate(*p) * 9.0).as_vec2().as_dvec2()).collect();
    let solution = solved_on((turned.clone(), triangles), &[turned[100], turned[420], turned[0]]);
    assert!((0..900).all(|v| solution.weights().row(v).next().is_some()));
}

#[test]
fn handles_outside_or_on_a_held_boundary_are_rejected() {
    let (vertices, triangles) = grid(4, 4, 10.0);
    let mesh = InputMesh::new(vertices, triangles).expect("a mesh");
    let mut outside = project(&[], &[(5.0, 5.0).into(), (30.5, 5.0).into()], Support::Paper);
    let expected = Error::HandleOutside { id: "h1".into(), x: 30.5, y: 5.0 };
    assert_eq!(solve_mesh(&outside, &mesh).expect_err("a handle outside"), expected);
    outside.handles = [0, 1].map(|id| point_handle(id, DVec2::splat(5.0), DVec2::splat(5.0), 0.0)).to_vec();
    assert_eq!(solve_mesh(&outside, &mesh).expect_err("two handles at the same point").code(), "handles-too-close");
    outside.fix_boundary = true;
    outside.handles = vec![point_handle(0, DVec2::new(5.0, 0.0), DVec2::new(5.0, 2.0), 0.0)];
    assert_eq!(solve_mesh(&outside, &mesh).expect_err("a handle on the boundary").code(), "on-held-boundary");
}

#[test]
fn bars_and_held_boundary_are_interpolated() {
    let (vertices, triangles) = grid(21, 21, 10.0);
    let mesh = InputMesh::new(vertices, triangles).expect("a mesh");
    let mut project = project(&[], &[], Support::Smooth);
    project.fix_boundary = true;
    project.handles = vec![bar("bar", &[(60.0, 100.0), (140.0, 100.0)], &[(60.0, 110.0), (140.0, 90.0)])];
    let solution = solve_mesh(&project, &mesh).expect("a valid scene");
    let posed = solution.posed_vertices(&solution.poser().pose(&project.handles, project.pose.blend).expect("finite"));
    for (p, posed) in solution.vertices().iter().zip(posed) {
        if p.x == 0.0 || p.y == 0.0 || p.x == 200.0 || p.y == 200.0 {
            assert!(p.distance(posed) <= 1e-9);
        } else if p.y == 100.0 && (60.0..=140.0).contains(&p.x) {
            assert!(posed.distance(DVec2::new(p.x, 110.0 - (p.x - 60.0) / 4.0)) <= 1e-6);
        }
    }
}

#[test]
fn errors_name_the_triangle_or_vertex() {
    let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
    assert_eq!(mesh_error(&square, &[]), Error::MeshEmpty);
    assert_eq!(mesh_error(&square, &[[0, 1, 2], [0, 2, 4]]), Error::MeshTriangle { triangle: 1, vertices: 4 });
    assert_eq!(mesh_error(&square, &[[0, 1, 2], [0, 2, 2]]), Error::MeshTriangle { triangle: 1, vertices: 4 });
    assert_eq!(mesh_error(&square, &[[0, 1, 2]]), Error::MeshVertexLoose { vertex: 3 });
    for wrong in [f64::NAN, f64::INFINITY, -1e7] {
        let vertices = [square[0], square[1], (10.0, wrong), square[3]];
        assert_eq!(mesh_error(&vertices, &[[0, 1, 2], [0, 2, 3]]), Error::MeshVertex { vertex: 2 });
    }
    let flat = [square[0], square[1], square[2], (5.0, 5.0)];
    assert_eq!(mesh_error(&flat, &[[0, 1, 2], [0, 2, 3]]), Error::MeshTriangleFlat { triangle: 1 });
    // A vertex of the second triangle lies on the same side of the shared edge as the first triangle.
    let folded = [square[0], square[1], square[2], (8.0, 3.0)];
    assert_eq!(mesh_error(&folded, &[[0, 1, 2], [0, 2, 3]]), Error::MeshEdge { triangle: 1, other: 0, from: 2, to: 0 });
    assert_eq!(
        mesh_error(&square, &[[0, 1, 2], [0, 2, 3], [0, 1, 2]]),
        Error::MeshEdge { triangle: 2, other: 0, from: 0, to: 1 }
    );
    let bow = [(0.0, 0.0), (10.0, 0.0), (5.0, 5.0), (10.0, 10.0), (0.0, 10.0)];
    assert_eq!(mesh_error(&bow, &[[0, 1, 2], [2, 3, 4]]), Error::MeshPinched { vertex: 2 });
}

#[test]
fn self_overlapping_meshes_are_rejected() {
    let two = |b: [(f64, f64); 3]| {
        let a = [(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)];
        mesh_error(&[a, b].concat(), &[[0, 1, 2], [3, 4, 5]])
    };
    assert_eq!(two([(1.0, -1.0), (3.0, 4.0), (-9.0, 4.0)]), Error::MeshCrosses { vertex: 4, other: 2 });
    assert_eq!(two([(1.0, 1.0), (3.0, 1.0), (1.0, 3.0)]), Error::MeshCovered { vertex: 3 });
    assert_eq!(two([(0.0, 0.0), (-3.0, 0.0), (0.0, -3.0)]), Error::MeshCrosses { vertex: 3, other: 0 });
    // A strip that winds more than once about a point, so its end overlaps its beginning.
    let spoke = |i: u32| (10.0 + f64::from(i), DVec2::from_angle(f64::from(i) * 0.5));
    let vertices: Vec<(f64, f64)> =
        (0..16).map(spoke).flat_map(|(r, d)| [d * r, d * (r + 30.0)]).map(|p| (p.x, p.y)).collect();
    let strip: Vec<[u32; 3]> = (0..30).map(|i| [i, i + 1, i + 2]).collect();
    assert!(matches!(mesh_error(&vertices, &strip), Error::MeshCrosses { .. }));
}

#[test]
fn boundary_with_too_many_corners_is_rejected() {
    let n = 11_000;
    let at = |i: u32| 1000.0 + 500.0 * DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / f64::from(n));
    let ring = |i: u32| [at(i), at(i) * 0.5 + 500.0];
    let vertices: Vec<(f64, f64)> = (0..n).flat_map(ring).map(|p| (p.x, p.y)).collect();
    let strip: Vec<[u32; 3]> = (0..2 * n).map(|i| [i, (i + 1) % (2 * n), (i + 2) % (2 * n)]).collect();
    assert_eq!(mesh_error(&vertices, &strip), Error::MeshTooFine { corners: 22_000 });
    let (vertices, triangles) = grid(n, 2, 1.0);
    let solution = solved_on((vertices, triangles), &[(1.0, 0.5).into(), (9000.0, 0.5).into()]);
    assert_eq!(solution.domain().rings()[0].len(), 4);
}
