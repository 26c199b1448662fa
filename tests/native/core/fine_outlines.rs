//! Outlines with very many corners: they are simplified, gaps are bridged, or the whole picture is taken.

use c2warp::{
    Picture,
    domain::{Domain, OutlineDetail},
    limits::MAX_CORNERS,
    project::{DomainSpec, Handle, Project},
    site::SiteKind,
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;

/// A picture with this alpha at each pixel.
fn pixels(side: u32, alpha: impl Fn(u32, u32) -> u8) -> Vec<u8> {
    (0..side * side).flat_map(|i| [40, 90, 60, alpha(i % side, i / side)]).collect()
}

fn corners(domain: &Domain) -> usize {
    domain.rings().iter().map(Vec::len).sum()
}

/// Whether the domain has all opaque pixels, with a pixel of tolerance.
fn has_all_pixels(domain: &Domain, side: u32, rgba: &[u8]) -> bool {
    let navigation = c2warp::distance::Navigation::new(domain);
    (0..side * side).filter(|&i| rgba[i as usize * 4 + 3] > 127).step_by(7).all(|i| {
        let p = DVec2::new(f64::from(i % side), f64::from(i / side)) + 0.5;
        [DVec2::ZERO, DVec2::X, -DVec2::X, DVec2::Y, -DVec2::Y].iter().any(|&by| navigation.located(p + by).is_some())
    })
}

/// Leaves: thousands of small ellipses within a circle.
fn leaves(side: u32, count: usize) -> Vec<u8> {
    let mut random = Random(5);
    let mut alpha = vec![0_u8; (side * side) as usize];
    let middle = f64::from(side) / 2.0;
    for _ in 0..count {
        let out = DVec2::from_angle(std::f64::consts::TAU * random.unit());
        let at = DVec2::splat(middle) + 0.45 * f64::from(side) * random.unit().sqrt() * out;
        let (along, length) = (DVec2::from_angle(6.3 * random.unit()), 3.0 + 3.0 * random.unit());
        for y in (at.y - 7.0) as u32..(at.y + 7.0) as u32 {
            for x in (at.x - 7.0) as u32..(at.x + 7.0) as u32 {
                let off = DVec2::new(f64::from(x), f64::from(y)) + 0.5 - at;
                let (u, v) = (off.dot(along) / length, off.perp_dot(along) / (0.45 * length));
                if u * u + v * v < 1.0 {
                    alpha[(y * side + x) as usize] = 255;
                }
            }
        }
    }
    pixels(side, |x, y| alpha[(y * side + x) as usize])
}

#[test]
fn gaps_between_leaves_and_between_dots_are_bridged() {
    let side = 900;
    let dots = pixels(side, |x, y| {
        let off = DVec2::new(f64::from(x % 9), f64::from(y % 9)) - 4.0;
        if off.length() < 2.0 + 2.2 * f64::from(x) / f64::from(side) { 255 } else { 0 }
    });
    for (name, rgba) in [("leaves", leaves(side, 6000)), ("dots", dots)] {
        let domain = Domain::from_alpha(&Picture::new(side, side, &rgba).expect("a picture"), 0.5).expect(name);
        assert_eq!(domain.detail(), OutlineDetail::Bridged, "{name}");
        assert!(corners(&domain) <= MAX_CORNERS && domain.bridged_gap() > 0.0, "{name}: {}", corners(&domain));
        assert!(has_all_pixels(&domain, side, &rgba), "{name}");
    }
}

#[test]
fn scattered_squares_are_bridged_even_if_each_is_a_speck() {
    let side = 1800;
    // Squares of 4 px in cells of 20 px, at a random place in each.
    let mut random = Random(3);
    let mut alpha = vec![0; (side * side) as usize];
    for (row, column) in (0..side / 20).flat_map(|row| (0..side / 20).map(move |column| (row, column))) {
        let (x, y) = (20 * column + 2 + random.below(13) as u32, 20 * row + 2 + random.below(13) as u32);
        for i in 0..16 {
            alpha[((y + i / 4) * side + x + i % 4) as usize] = 255;
        }
    }
    let rgba = pixels(side, |x, y| alpha[(y * side + x) as usize]);
    let picture = Picture::new(side, side, &rgba).expect("a picture");
    let domain = Domain::from_alpha(&picture, 0.5).expect("a domain");
    assert!(corners(&domain) <= MAX_CORNERS);
    assert!(has_all_pixels(&domain, side, &rgba));
    assert_eq!(domain.detail(), OutlineDetail::Bridged);
    let mut project = Project::for_picture(side, side).with_handles([Handle::point("a", [750.0, 750.0])]);
    project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
    assert!(solve(&project, &picture).is_ok_and(|solution| solution.domain() == &domain));
}

#[test]
fn held_soft_shadow_needs_few_sites() {
    // A disc with a shadow that fades by less than a level a pixel.
    let side = 900;
    let rgba = pixels(side, |x, y| {
        let out = DVec2::new(f64::from(x), f64::from(y)).distance(DVec2::splat(450.0)) - 150.0;
        if out < 0.0 { 255 } else { (120.0 * libm::exp(-out * out / 20_000.0)) as u8 }
    });
    let mut project = Project::for_picture(side, side).with_handles([Handle::point("a", [450.0, 450.0])]);
    project.domain = Some(DomainSpec::Alpha { threshold: 6.0 / 255.0 });
    project.fix_boundary = true;
    let solution = solve(&project, &Picture::new(side, side, &rgba).expect("a picture")).expect("a solution");
    let held = solution.sites().iter().filter(|site| site.kind == SiteKind::Boundary).count();
    assert!(held < 200, "{held} sites hold the boundary");
    assert_ne!(solution.domain().detail(), OutlineDetail::Bridged);
}

#[test]
fn held_tips_need_few_sites() {
    // Tips of 11, 6, 3 and 1 degrees: the width of the other end, and the most real sites.
    let expected = [(200.0, 200), (100.0, 350), (60.0, 500), (20.0, 1_300)];
    let rgba = vec![255; 1000 * 300 * 4];
    let picture = Picture::new(1000, 300, &rgba).expect("a picture");
    for (width, most) in expected {
        let corners = [(0.0, 40.0), (1000.0, 40.0 + width / 2.0), (0.0, 40.0 + width)].map(DVec2::from);
        let mut project = Project::for_picture(1000, 300)
            .with_handles([Handle::point("a", [100.0, 40.0 + width / 2.0])])
            .with_editor_settings();
        project.domain = Some(DomainSpec::polygon(vec![corners.to_vec()]));
        (project.fix_boundary, project.pose.density) = (true, 100);
        let solution = solve(&project, &picture).unwrap_or_else(|error| panic!("{width} px: {error}"));
        let sites = solution.sites();
        let real = sites.iter().filter(|site| site.kind.is_real()).count();
        assert!(real < most, "{width} px: {real} real sites");
        assert!(sites.len() - real >= 100, "{width} px: {} virtual sites", sites.len() - real);
        let is_covered = |vertex| solution.weights().row(vertex).next().is_some();
        assert!((0..solution.vertices().len()).all(is_covered), "{width} px: vertices without weights");
        for (at, site) in sites.iter().enumerate().filter(|(_, site)| !site.kind.is_real()) {
            let others = sites.iter().filter(|other| other.kind.is_real());
            let nearest = others.map(|other| other.rest.distance(site.rest)).fold(f64::INFINITY, f64::min);
            assert!(site.support_radius <= nearest, "{width} px: the support of site {at} reaches a real one");
        }
    }
}

#[test]
fn held_fur_has_a_coarser_outline_than_free_fur() {
    let side = 600;
    let fur = pixels(side, |x, y| {
        let off = DVec2::new(f64::from(x), f64::from(y)) - 300.0;
        let reach = 180.0 + 90.0 * libm::pow(libm::sin(90.0 * libm::atan2(off.y, off.x)).abs(), 3.0);
        if off.length() < reach { 255 } else { 0 }
    });
    let picture = Picture::new(side, side, &fur).expect("a picture");
    let mut project = Project::for_picture(side, side).with_handles([Handle::point("a", [300.0, 300.0])]);
    project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
    let free = solve(&project, &picture).expect("a solution");
    project.fix_boundary = true;
    let held = solve(&project, &picture).expect("a solution");
    assert_eq!((free.domain().detail(), held.domain().detail()), (OutlineDetail::Traced, OutlineDetail::Bridged));
    assert!(corners(free.domain()) > 500 && corners(held.domain()) <= 250);
}

#[test]
fn rings_with_many_sharp_corners_are_not_held() {
    let zigzag = |k: i32| {
        let radius = if k % 2 == 0 { 190.0 } else { 150.0 };
        DVec2::splat(200.0) + radius * DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 1200.0)
    };
    let mut project = Project::for_picture(400, 400).with_handles([Handle::point("a", [200.0, 200.0])]);
    project.domain = Some(DomainSpec::polygon(vec![(0..1200).map(zigzag).collect()]));
    project.fix_boundary = true;
    let rgba = vec![255; 400 * 400 * 4];
    let error = solve(&project, &Picture::new(400, 400, &rgba).expect("a picture")).expect_err("too many corners");
    assert_eq!(error.code(), "held-too-fine");
    assert!(error.to_string().contains("1200 sharp corners"), "{error}");
}
