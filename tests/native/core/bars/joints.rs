//! Tests of bars that cross, touch or share an end.

use c2warp::project::{Handle, PoseMode, Support};
use glam::DVec2;

use super::{ON_BAR, check_lines, check_on_line, map_point, solve_and_pose, square};
use crate::handles::{bar, polygon};
use crate::scenes::spread;

#[test]
fn crossing_bars_bend_at_the_mean_of_their_crossings() {
    let first = bar("first", &[(100.0, 200.0), (300.0, 200.0)], &[(100.0, 220.0), (300.0, 220.0)]);
    let second = bar("second", &[(150.0, 100.0), (150.0, 300.0)], &[(160.0, 100.0), (160.0, 300.0)]);
    let (solution, pose) = solve_and_pose(&square(Support::Smooth, vec![first, second]));
    // The first bar moves the crossing to (150, 220), the second bar to (160, 200).
    let joint = DVec2::new(155.0, 210.0);
    let pieces = [
        ((100.0, 200.0), (100.0, 220.0)),
        ((300.0, 200.0), (300.0, 220.0)),
        ((150.0, 100.0), (160.0, 100.0)),
        ((150.0, 300.0), (160.0, 300.0)),
    ];
    for (rest, end) in pieces {
        check_on_line(&solution, &pose, &[DVec2::from(rest), DVec2::new(150.0, 200.0)], &[end.into(), joint], false);
    }
}

#[test]
fn touching_bars_are_joined() {
    let stem = bar("stem", &[(200.0, 200.0), (200.0, 330.0)], &[(210.0, 200.0), (230.0, 320.0)]);
    let beam = bar("beam", &[(100.0, 200.0), (300.0, 200.0)], &[(100.0, 190.0), (300.0, 230.0)]);
    let arm = bar("arm", &[(300.0, 200.0), (340.0, 120.0)], &[(304.0, 226.0), (340.0, 100.0)]);
    let (solution, pose) = solve_and_pose(&square(Support::Smooth, vec![stem, beam, arm]));
    // The beam moves its middle to (200, 210). The stem moves its top to (210, 200).
    let (middle, end) = (DVec2::new(205.0, 205.0), DVec2::new(302.0, 228.0));
    let at = |x: f64, y: f64| DVec2::new(x, y);
    check_on_line(&solution, &pose, &[at(200.0, 200.0), at(200.0, 330.0)], &[middle, at(230.0, 320.0)], false);
    check_on_line(&solution, &pose, &[at(100.0, 200.0), at(200.0, 200.0)], &[at(100.0, 190.0), middle], false);
    check_on_line(&solution, &pose, &[at(200.0, 200.0), at(300.0, 200.0)], &[middle, end], false);
    check_on_line(&solution, &pose, &[at(300.0, 200.0), at(340.0, 120.0)], &[end, at(340.0, 100.0)], false);
}

/// If a gap of 0.01 px kept its rest length, it would turn bones of a few hundredths, and the picture with them.
#[test]
fn nearly_touching_bars_follow_a_similarity() {
    let beam = [(100.0, 200.0), (300.0, 200.0)];
    let stem = [(200.0, 200.009), (220.0, 330.0)];
    let splinter = [(150.0, 200.008), (150.015, 200.03)];
    let eye = [(300.0, 200.006), (340.0, 240.0), (300.007, 260.0)];
    for (turn, scale) in [(0.9, 1.0), (-7.5, 1.0), (2.0, 1.3)] {
        let moved = |p: DVec2| DVec2::new(212.0, 185.0) + scale * DVec2::from_angle(turn).rotate(p - 200.0);
        let as_moved = |rest: &[(f64, f64)]| rest.iter().map(|&p| moved(p.into()).into()).collect::<Vec<(f64, f64)>>();
        let bars = [("beam", &beam), ("stem", &stem), ("splinter", &splinter)];
        let bars = bars.into_iter().map(|(id, rest)| bar(id, rest, &as_moved(rest)));
        let handles = bars.chain([polygon("eye", &eye, &as_moved(&eye))]);
        for mode in [PoseMode::Harmonic, PoseMode::Rigid] {
            let turned = |handle: Handle| handle.turned(turn.to_degrees()).scaled(scale);
            let mut project = square(Support::Smooth, handles.clone().map(turned).collect());
            project.pose.mode = mode;
            let (solution, pose) = solve_and_pose(&project);
            for p in spread(1000) {
                if let Some(mapped) = solution.map(&pose, p) {
                    let error = mapped.posed.distance(moved(p));
                    assert!(error <= ON_BAR, "{mode:?}, turned by {turn} and scaled by {scale}: {p} is {error} px off");
                }
            }
        }
    }
}

#[test]
fn crossing_bars_that_agree_stay_straight() {
    let shift = |corners: [(f64, f64); 2]| corners.map(|(x, y)| (x + 12.0, y - 9.0));
    let (first, second) = ([(100.0, 200.0), (300.0, 220.0)], [(150.0, 100.0), (190.0, 300.0)]);
    let handles = vec![bar("first", &first, &shift(first)), bar("second", &second, &shift(second))];
    let project = square(Support::Paper, handles);
    let (solution, pose) = solve_and_pose(&project);
    check_lines(&project, &solution, &pose);
}

/// The ends are close enough to be joined, but do not coincide. The joint must follow a common translation exactly.
#[test]
fn nearly_touching_bars_follow_a_translation() {
    for (x, y) in [(29.97, 0.009), (29.985, 0.009), (29.9, 0.004), (29.0, 0.009)] {
        for by in [DVec2::ZERO, DVec2::new(14.0, -9.0)] {
            let moved =
                |rest: &[(f64, f64)]| -> Vec<(f64, f64)> { rest.iter().map(|p| (p.0 + by.x, p.1 + by.y)).collect() };
            let (one, two) = ([(120.0, 150.0), (180.0, 150.0)], [(150.0, 120.0), (150.0 + x, 150.0 + y)]);
            let handles = vec![bar("one", &one, &moved(&one)), bar("two", &two, &moved(&two))];
            let (solution, pose) = solve_and_pose(&square(Support::Paper, handles));
            for p in spread(500).filter(|p| p.min_element() > 21.0 && p.max_element() < 379.0) {
                assert!(map_point(&solution, &pose, p).distance(p + by) <= ON_BAR, "{x} {y} {by}: {p}");
            }
        }
    }
}
