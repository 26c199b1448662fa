//! Tests of the static background: the picture outside a domain of rings stays, without a seam.

use c2warp::{
    Picture, ResampleOptions, Solution, Warped,
    project::{DomainSpec, Handle, Project},
    solve,
};
use glam::DVec2;

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

/// Returns a round ring inside the picture, with a hole.
fn rings() -> Vec<Vec<DVec2>> {
    let circle = |centre: DVec2, radius: f64, count: u32| {
        let corner = |k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / f64::from(count)) * radius + centre;
        (0..count).map(corner).collect()
    };
    vec![circle(DVec2::new(70.3, 60.1), 40.7, 31), circle(DVec2::new(60.0, 50.0), 8.0, 7)]
}

/// Returns opaque pixels that differ from their neighbours.
fn pixels() -> Vec<u8> {
    (0..WIDTH * HEIGHT).flat_map(|i| [(i % 251) as u8, (i / WIDTH * 2) as u8, (i % 7 * 30) as u8, 255]).collect()
}

fn project(rings: Vec<Vec<DVec2>>, posed: [f64; 2]) -> Project {
    let mut project = Project::for_picture(WIDTH, HEIGHT).with_editor_settings();
    project.domain = Some(DomainSpec::polygon(rings));
    project.handles = vec![Handle::point("nose", [80.0, 70.0]).posed_at([posed])];
    project
}

fn warped(project: &Project, rgba: &[u8]) -> (Solution, Warped) {
    let picture = Picture::new(WIDTH, HEIGHT, rgba).expect("a picture");
    let solution = solve(project, &picture).expect("a solution");
    let pose = solution.pose(project).expect("a pose");
    let warped = solution.warped(&picture, &pose, ResampleOptions::default()).expect("a picture");
    (solution, warped)
}

/// Returns the distance of a pixel's centre from a point.
fn distance(pixel: usize, from: [f64; 2]) -> f64 {
    let at = DVec2::new((pixel % WIDTH as usize) as f64 + 0.5, (pixel / WIDTH as usize) as f64 + 0.5);
    at.distance(DVec2::from(from))
}

#[test]
fn picture_at_rest_is_unchanged() {
    let rgba = pixels();
    let frame = [(0.0, 0.0), (160.0, 0.0), (160.0, 120.0), (0.0, 120.0)].map(DVec2::from).to_vec();
    let half = [(0.0, 0.0), (80.0, 0.0), (80.0, 120.0), (0.0, 120.0)].map(DVec2::from).to_vec();
    for rings in [rings(), vec![frame], vec![half]] {
        for held in [false, true] {
            let mut project = project(rings.clone(), [70.0, 70.0]);
            project.handles[0] = Handle::point("nose", [70.0, 70.0]);
            project.fix_boundary = held;
            assert_eq!(warped(&project, &rgba).1.rgba, rgba, "held: {held}");
        }
    }
}

#[test]
fn held_ring_bends_without_a_seam() {
    let rgba = pixels();
    let mut project = project(rings(), [88.0, 64.0]);
    project.fix_boundary = true;
    let (_, warped) = warped(&project, &rgba);
    let mut changed = 0;
    for (pixel, (now, before)) in warped.rgba.chunks(4).zip(rgba.chunks(4)).enumerate() {
        assert_eq!(now[3], 255, "pixel {pixel}");
        // More than a pixel's diagonal outside the ring, or that far inside the hole.
        if distance(pixel, [70.3, 60.1]) > 41.5 || distance(pixel, [60.0, 50.0]) < 6.0 {
            assert_eq!(now, before, "pixel {pixel}");
        } else if now != before {
            changed += 1;
        }
    }
    assert!(changed > 1000, "{changed}");
}

#[test]
fn moved_ring_leaves_a_gap_and_covers_the_background() {
    let rgba = pixels();
    let mut project = project(rings(), [120.0, 70.0]);
    project.handles[0].depth = -5.0;
    let (solution, warped) = warped(&project, &rgba);
    let pixel = |x: u32, y: u32| (y * WIDTH + x) as usize * 4;
    let alpha = |x, y| warped.rgba[pixel(x, y) + 3];
    // The ring spans x = 30 to 111. It moves right and leaves the part left of x = 70 empty.
    assert_eq!((alpha(20, 60), alpha(35, 60), alpha(140, 60)), (255, 0, 255));
    assert_eq!(warped.rgba[pixel(20, 60)..][..4], rgba[pixel(20, 60)..][..4]);
    assert_eq!(warped.rgba[pixel(140, 60)..][..4], rgba[pixel(100, 60)..][..4]);
    let pose = solution.pose(&project).expect("a pose");
    let rest_at = |x: f64, y: f64| solution.rest_point(&pose, DVec2::new(x, y));
    assert_eq!(rest_at(20.0, 60.0).map(DVec2::round), Some(DVec2::new(20.0, 60.0)));
    assert_eq!(rest_at(35.0, 60.0), None);
    assert!(rest_at(140.0, 60.0).is_some_and(|p| p.distance(DVec2::new(100.0, 60.0)) < 1e-6));
    assert!(solution.map(&pose, DVec2::new(20.0, 60.0)).is_none());
}

#[test]
fn other_domains_have_no_background() {
    let rgba = pixels();
    let mut project = project(rings(), [80.0, 70.0]);
    assert!(!warped(&project, &rgba).0.static_background().triangles().is_empty());
    for domain in [None, Some(DomainSpec::Image), Some(DomainSpec::Alpha { threshold: 0.5 })] {
        project.domain = domain;
        assert!(warped(&project, &rgba).0.static_background().triangles().is_empty());
    }
}
