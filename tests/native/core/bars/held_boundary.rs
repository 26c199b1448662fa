//! Tests of held boundaries.

use std::f64::consts::TAU;

use c2warp::{
    project::{PoseMode, Support},
    site::SiteKind,
};
use glam::DVec2;

use super::{ON_BAR, map_point, parameters, solve_and_pose};
use crate::handles::{bar, point_handle, points};
use crate::scenes::project;

#[test]
fn held_boundary_stays() {
    for (support, mode, density) in [(Support::Paper, PoseMode::Harmonic, 0), (Support::Smooth, PoseMode::Rigid, 40)] {
        let rings = [
            points(&[(20.0, 20.0), (380.0, 20.0), (360.0, 200.0), (380.0, 380.0), (20.0, 380.0)]),
            points(&[(150.0, 150.0), (190.0, 150.0), (180.0, 180.0)]),
        ];
        let mut project = project(&rings, &[], support);
        project.fix_boundary = true;
        (project.pose.mode, project.pose.density) = (mode, density);
        project.handles = vec![
            point_handle(0, (100.0, 100.0).into(), (130.0, 110.0).into(), 30.0),
            point_handle(1, (30.0, 300.0).into(), (35.0, 310.0).into(), 0.0),
            // Touches the boundary, so its end is cut off.
            bar("bar", &[(250.0, 300.0), (250.0, 380.0)], &[(270.0, 290.0), (260.0, 380.0)]),
        ];
        let (solution, pose) = solve_and_pose(&project);
        for ring in &rings {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                for t in parameters() {
                    let p = a.lerp(*b, t);
                    assert!(map_point(&solution, &pose, p).distance(p) <= 1e-9, "{p}");
                }
            }
        }
        let outline = solution.vertices().iter().zip(solution.posed_vertices(&pose));
        let on_outline = |p: DVec2| p.x == 20.0 || p.y == 20.0 || p.y == 380.0;
        assert!(outline.filter(|(p, _)| on_outline(**p)).all(|(p, posed)| p.distance(posed) <= 1e-9));
        assert_eq!(solution.outside().len(), 1);
        assert!(map_point(&solution, &pose, (100.0, 100.0).into()).distance((130.0, 110.0).into()) <= ON_BAR);
        assert!(map_point(&solution, &pose, (250.0, 340.0).into()).distance((265.0, 335.0).into()) <= ON_BAR);
    }
}

#[test]
fn held_round_boundary_needs_few_sites() {
    let sites = [60, 1200].map(|corners| {
        let corner = |k: i32| 200.0 + 170.0 * DVec2::from_angle(f64::from(k) / f64::from(corners) * TAU);
        let ring: Vec<DVec2> = (0..corners).map(corner).collect();
        let mut project = project(std::slice::from_ref(&ring), &[], Support::Smooth);
        project.fix_boundary = true;
        let (left, right) = ((160.0, 200.0).into(), (250.0, 200.0).into());
        project.handles =
            vec![point_handle(0, left, left + DVec2::new(-10.0, 8.0), 0.0), point_handle(1, right, right, 20.0)];
        let (solution, pose) = solve_and_pose(&project);
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            for p in [*a, a.lerp(*b, 0.3)] {
                assert!(map_point(&solution, &pose, p).distance(p) <= 1e-9, "{p}");
            }
        }
        solution.sites().iter().filter(|site| site.kind == SiteKind::Boundary).count()
    });
    assert!(sites[1] < 100 && sites[1].abs_diff(sites[0]) < 20, "{sites:?}");
}

#[test]
fn bar_is_cut_where_it_touches_a_held_boundary() {
    let ring = [(0.0, 0.0), (190.0, 0.0), (200.0, 200.0), (210.0, 0.0), (400.0, 0.0), (400.0, 400.0), (0.0, 400.0)];
    // The bar touches the tip of the notch, comes near it, or passes it.
    for (y, is_cut) in [(200.0, true), (200.5, true), (202.0, false)] {
        let mut project = project(&[points(&ring)], &[], Support::Smooth);
        project.fix_boundary = true;
        project.handles = vec![bar("bar", &[(60.0, y), (340.0, y)], &[(60.0, y + 20.0), (340.0, y + 20.0)])];
        let (solution, pose) = solve_and_pose(&project);
        let outside: Vec<[f64; 2]> = solution.outside().iter().map(|part| [part.from.x, part.to.x]).collect();
        assert_eq!(outside.len(), usize::from(is_cut), "{outside:?}");
        assert!(
            outside.iter().all(|[from, to]| (from + to - 400.0).abs() < 1e-9 && (1.5..2.1).contains(&(to - from))),
            "{outside:?}"
        );
        let tip = DVec2::splat(200.0);
        assert!(map_point(&solution, &pose, tip).distance(tip) <= 1e-9);
        for x in [60.0, 150.0, 198.0, 202.0, 340.0] {
            assert!(map_point(&solution, &pose, (x, y).into()).distance((x, y + 20.0).into()) <= ON_BAR);
        }
    }
}
