//! Tests of polygons, and of lines with many corners.

use c2warp::project::{PoseMode, Support};
use glam::DVec2;

use super::{ON_BAR, check_lines, map_point, solve_and_pose, square};
use crate::handles::{bar, point_handle, polygon};
use crate::scenes::spread;

#[test]
fn polygon_keeps_its_inside_rigid() {
    let eye = [(260.0, 200.0), (320.0, 190.0), (330.0, 240.0), (280.0, 260.0), (250.0, 230.0)];
    let turn = |p: DVec2| DVec2::from_angle(0.7).rotate(p - 290.0) + DVec2::new(282.0, 301.0);
    let turned: Vec<(f64, f64)> = eye.iter().map(|&p| turn(p.into()).into()).collect();
    for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
        let others = [point_handle(1, (60.0, 60.0).into(), (60.0, 60.0).into(), 0.0)];
        let mut project = square(Support::Smooth, [polygon("eye", &eye, &turned)].into_iter().chain(others).collect());
        (project.pose.mode, project.pose.density) = (mode, 120);
        let (solution, pose) = solve_and_pose(&project);
        let mut inside = 0;
        for p in spread(20_000) {
            let edges = eye.iter().zip(eye.iter().cycle().skip(1));
            let is_inside =
                edges.map(|(&a, &b)| (DVec2::from(a), DVec2::from(b))).all(|(a, b)| (b - a).perp_dot(p - a) > 0.0);
            if is_inside {
                inside += 1;
                assert!(map_point(&solution, &pose, p).distance(turn(p)) <= ON_BAR, "{p}");
            }
        }
        assert!(inside > 300);
    }
}

/// All corners of the round polygon are equally far from its centre, so their cells meet there.
#[test]
fn round_polygon_and_long_zigzag_are_solved() {
    let corner = |i: i32| DVec2::splat(200.0) + 120.0 * DVec2::from_angle(f64::from(i).to_radians() * 4.0);
    let round: Vec<(f64, f64)> = (0..90).map(|i| corner(i).into()).collect();
    let zigzag: Vec<(f64, f64)> =
        (0..120).map(|i| (40.0 + 2.5 * f64::from(i), if i % 2 == 0 { 150.0 } else { 260.0 })).collect();
    for (rest, closed) in [(round, true), (zigzag, false)] {
        let posed: Vec<(f64, f64)> = rest.iter().map(|&(x, y)| (1.02 * x - 0.1 * y, y + 0.05 * x)).collect();
        let handle = if closed { polygon("round", &rest, &posed) } else { bar("zigzag", &rest, &posed) };
        let project = square(Support::Smooth, vec![handle]);
        let (solution, pose) = solve_and_pose(&project);
        check_lines(&project, &solution, &pose);
        let bones: Vec<_> = solution.sites().iter().filter(|site| site.kind.is_real()).collect();
        assert!(bones.len() < 2 * rest.len(), "{} sites on {} corners", bones.len(), rest.len());
        if closed {
            assert!(bones.iter().all(|site| site.cell_radius > 119.9), "a cell ends before the middle");
        }
    }
}
