//! Tests of the number of sites that bars need.

use std::f64::consts::TAU;

use c2warp::{Error, project::Support, site::SiteKind};
use glam::DVec2;

use super::random::check_weights_around_bars;
use super::{check_lines, solve_and_pose, square};
use crate::handles::{bar, point_handle, points};
use crate::scenes::{project, solved};

#[test]
fn bar_with_a_short_segment_stays_one_body() {
    let sites = |short: f64| {
        let rest = [(140.0 - short, 210.0), (140.0, 210.0), (200.0, 130.0)];
        let mut project = square(Support::Smooth, vec![bar("bent", &rest, &rest)]);
        let close = DVec2::new(150.0, 300.0);
        project.handles.push(point_handle(0, close, close, 0.0));
        solved(&project).expect("a valid scene").sites().len()
    };
    let long = sites(3.0);
    for short in [0.02, 0.1, 0.3, 0.49, 0.6] {
        assert!(sites(short) <= long + 5, "{short}: {} sites, {long} at three pixels", sites(short));
    }
}

/// Each segment crosses nearly all others, so there are more parts between crossings than the limit of sites.
#[test]
fn star_with_too_many_crossings_is_rejected() {
    let corner = |i: u32| {
        let angle = f64::from(i * 250) / 501.0 * TAU;
        (200.0 + 150.0 * angle.cos(), 200.0 + 150.0 * angle.sin())
    };
    let star: Vec<(f64, f64)> = (0..501).map(corner).collect();
    let refused = solved(&square(Support::Smooth, vec![bar("star", &star, &star)])).map(|_| ());
    assert!(matches!(refused, Err(Error::TooManySites)), "{refused:?}");
}

#[test]
fn close_point_adds_bar_sites_only_nearby() {
    let long = bar("long", &[(40.0, 200.0), (360.0, 200.0)], &[(40.0, 200.0), (360.0, 200.0)]);
    let sites = |gap: f64, samples: u32| {
        let close = point_handle(1, (200.0, 200.0 - gap).into(), (200.0, 200.0 - gap).into(), 0.0);
        let mut project = square(Support::Paper, vec![long.clone(), close]);
        project.samples = samples;
        let (solution, _) = solve_and_pose(&project);
        let on_bar = |site: &&c2warp::site::Site| matches!(site.kind, SiteKind::Bone { .. });
        (solution.sites().iter().filter(on_bar).count(), solution.sites().len())
    };
    // The paper divides a bar uniformly into parts as long as the gap: 32, 320 and 3,200.
    let [wide, narrow, hair] = [10.0, 1.0, 0.1].map(|gap| sites(gap, 1_500));
    eprintln!("sites of the bar, and all: {wide:?}, {narrow:?}, {hair:?}");
    assert!(narrow.0 < wide.0 + 40 && hair.0 < narrow.0 + 45, "{wide:?}, {narrow:?}, {hair:?}");
    for samples in [500, 10_000] {
        let others = [10.0, 1.0, 0.1].map(|gap| sites(gap, samples));
        assert_eq!(others, [wide, narrow, hair], "{samples} samples");
    }
}

/// Sites between the bars once caused further sites, all the way to the joint.
#[test]
fn close_point_between_shallow_bars_adds_few_sites() {
    let first = [(100.0, 40.0), (100.0, 200.0)];
    let crossing = |x: f64| [(100.0 - (x - 100.0) / 2.0, 80.0), (x, 200.0)];
    for (second, x) in [
        (crossing(108.0), 99.5),
        (crossing(108.0), 99.93),
        (crossing(108.0), 101.0),
        (crossing(102.0), 99.9),
        (crossing(130.0), 99.5),
        ([(100.0, 40.0), (104.0, 200.0)], 99.5),
    ] {
        for (support, samples) in [(Support::Paper, 200), (Support::Smooth, 1_500)] {
            let moved = |line: [(f64, f64); 2]| line.map(|(x, y)| (x + 6.0, y - 4.0));
            let close = point_handle(2, (x, 160.0).into(), (x + 6.0, 156.0).into(), 0.0);
            let lines = [("first", first), ("second", second)].map(|(id, line)| bar(id, &line, &moved(line)));
            let mut project = square(support, lines.into_iter().chain([close]).collect());
            project.samples = samples;
            let (solution, pose) = solve_and_pose(&project);
            eprintln!("{second:?}, {x}: {} sites", solution.sites().len());
            assert!(solution.sites().len() < 1_000, "{second:?}, {x}: {} sites", solution.sites().len());
            check_lines(&project, &solution, &pose);
            check_weights_around_bars(project, 1).expect("the weights are valid");
        }
    }
    // This scene once caused sites without end.
    let first = [(57.09918809525068, 211.65161324896727), (22.11396171583384, 19.478821835391827)];
    let second = [(48.49909316177254, 216.27039147002156), (29.83652842485062, 38.51629562275062)];
    let rest = DVec2::new(40.42195441235248, 138.6979416358756);
    let ring = points(&[(0.0, 0.0), (190.0, 0.0), (190.0, 208.0), (0.0, 208.0)]);
    let mut project = project(&[ring], &[], Support::Paper);
    project.samples = 200;
    project.handles =
        vec![bar("first", &first, &first), bar("second", &second, &second), point_handle(2, rest, rest, 0.0)];
    let (solution, _) = solve_and_pose(&project);
    assert!(solution.sites().len() < 1_000, "{} sites", solution.sites().len());
    check_weights_around_bars(project, 1).expect("the weights are valid");
}
