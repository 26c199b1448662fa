//! Robustness tests on noise of every grain and threshold. Nothing may panic, and all weights must sum to 1.

use c2warp::{
    Error, Picture, ResampleOptions,
    project::{DomainSpec, ImageRef, Project, Support},
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;

use crate::handles::point_handle;
use crate::scenes::{project, solved};

#[test]
fn noise_of_every_grain_is_solved_or_rejected() {
    let mut random = Random(7);
    let (mut solved, mut rejected) = (0, 0);
    for case in 0..160 {
        let (width, height) = (2 + random.below(90) as u32, 2 + random.below(90) as u32);
        // Blocks of a few pixels with hard or soft alpha. The fraction of opaque blocks varies.
        let (grain, is_hard, fraction) = (1 + random.below(9) as u32, random.below(2) == 0, random.unit());
        let columns = width.div_ceil(grain);
        let blocks: Vec<u8> = (0..columns * height.div_ceil(grain))
            .map(|_| match (is_hard, random.unit() < fraction) {
                (true, true) => 255,
                (true, false) => 0,
                (false, opaque) => (random.below(128) + if opaque { 128 } else { 0 }) as u8,
            })
            .collect();
        let alpha = |i: u32| blocks[(i / width / grain * columns + i % width / grain) as usize];
        let rgba: Vec<u8> = (0..width * height).flat_map(|i| [200, 100, 50, alpha(i)]).collect();
        let picture = Picture::new(width, height, &rgba).expect("a valid size");
        let mut project = Project::new(ImageRef::new("noise.png", width, height));
        project.samples = 100 + random.below(900) as u32;
        let threshold = [0.004, 0.1, 0.5, 0.502, 0.9, 1.0][random.below(6) as usize];
        project.domain = Some(DomainSpec::Alpha { threshold });
        // Handles stand on opaque pixels. Sometimes two of them are neighbours.
        let opaque: Vec<u32> = (0..width * height).filter(|&i| f64::from(alpha(i)) >= threshold * 255.0).collect();
        for id in 0..random.below(6) as usize {
            let Some(&at) = opaque.get(random.below(opaque.len().max(1) as u64) as usize) else { break };
            let rest = DVec2::new(f64::from(at % width), f64::from(at / width)) + 0.5;
            project.handles.push(point_handle(id, rest, rest + DVec2::new(3.0, -2.0), 30.0));
        }
        match solve(&project, &picture) {
            Ok(solution) => {
                solved += 1;
                for v in 0..solution.weights().len() {
                    let sum: f64 = solution.weights().row(v).map(|(_, w)| w).sum();
                    let reached = solution.weights().row(v).next().is_some();
                    assert!(!reached || (sum - 1.0).abs() <= 1e-12, "case {case}: {sum}");
                }
                let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
                assert!(solution.posed_vertices(&pose).iter().all(|p| p.is_finite()), "case {case}");
            }
            // A handle may be outside the outline or on another handle.
            Err(
                Error::NothingOpaque { .. }
                | Error::OnlySpecks { .. }
                | Error::HandleOutside { .. }
                | Error::HandlesTooClose { .. },
            ) => rejected += 1,
            Err(other) => panic!("case {case}: {other}"),
        }
    }
    eprintln!("{solved} solved, {rejected} rejected");
    assert!(solved > 60 && rejected > 5);
}

/// Sprites with hard pixels: single ones, lines, and pixels that touch at corners.
#[test]
fn sprite_at_rest_keeps_every_pixel() {
    let mut random = Random(5);
    for case in 0..60 {
        let (width, height) = (4 + random.below(30) as u32, 4 + random.below(30) as u32);
        let grain = 1 + random.below(4) as u32;
        let fraction = 0.1 + 0.8 * random.unit();
        let opaque: Vec<bool> = (0..width * height).map(|_| random.unit() < fraction).collect();
        let is_opaque = |i: u32| opaque[(i / width / grain * width + i % width / grain) as usize];
        let rgba: Vec<u8> =
            (0..width * height).flat_map(|i| if is_opaque(i) { [200, i as u8, 50, 255] } else { [0; 4] }).collect();
        let picture = Picture::new(width, height, &rgba).expect("a valid size");
        let Some(at) = (0..width * height).find(|&i| is_opaque(i)) else { continue };
        let rest = DVec2::new(f64::from(at % width), f64::from(at / width)) + 0.5;
        let project = Project::for_picture(width, height).with_handles([point_handle(0, rest, rest, 0.0)]);
        let solution = solve(&project, &picture).expect("a sprite");
        let pose = solution.pose(&project).expect("at rest");
        let warped = solution.warped(&picture, &pose, ResampleOptions::default()).expect("a picture");
        let changed = warped.rgba.iter().zip(&rgba).filter(|(now, before)| now != before).count();
        assert_eq!(changed, 0, "case {case}: {width} × {height}, grain {grain}");
    }
}

/// Corners close to edges and other corners, and needles. The gaps range from rounding errors to a pixel.
#[test]
fn nearly_touching_rings_are_solved_or_rejected() {
    let mut random = Random(23);
    let (mut solved_ones, mut rejected) = (0, 0);
    for case in 0..300 {
        let gap = 10.0_f64.powi(-(random.below(17) as i32)) * [1.0, -1.0, 0.0][case % 3];
        let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
        // The edge from a to b is the upper side of a ring.
        let (a, b) = (
            DVec2::new(between(20.0, 90.0), between(80.0, 160.0)),
            DVec2::new(between(300.0, 380.0), between(80.0, 160.0)),
        );
        let ring = vec![a, b, DVec2::new(380.0, 390.0), DVec2::new(20.0, 390.0)];
        let apex = a.lerp(b, between(0.1, 0.9)) + DVec2::new(0.0, gap);
        let rings = match case / 3 % 3 {
            0 => vec![ring, vec![apex, DVec2::new(260.0, 20.0), DVec2::new(140.0, 20.0)]],
            1 => vec![vec![a, b, apex, ring[2], ring[3]]],
            _ => vec![vec![a, apex, b, ring[2], ring[3], a + DVec2::new(gap, gap)]],
        };
        let project = project(&rings, &[DVec2::new(200.0, 300.0)], Support::Paper);
        match solved(&project) {
            Ok(_) => solved_ones += 1,
            Err(error) => {
                assert_eq!(error.code(), "domain", "case {case}: {error}");
                rejected += 1;
            }
        }
    }
    assert!(solved_ones > 50 && rejected > 50, "{solved_ones} solved, {rejected} rejected");
}
