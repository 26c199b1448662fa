//! Domains that are difficult for distances.

use c2warp::{Picture, domain::Domain};
use glam::DVec2;

use crate::visibility::VisibilityGraph;

/// Side of the square picture around each domain, in pixels.
pub const SIZE: u32 = 1000;

/// Corners of the rings of a domain, in pixels. Outer rings have a positive area, holes a negative one.
pub type Rings = Vec<Vec<DVec2>>;

/// Returns the domain of valid rings.
///
/// # Panics
/// If the rings are invalid.
#[must_use]
pub fn polygon(rings: &Rings) -> Domain {
    Domain::from_rings(rings).expect("the test's rings are valid")
}

/// Returns a regular polygon.
fn circle(centre: DVec2, radius: f64, corners: usize) -> Vec<DVec2> {
    let at = |i: usize| DVec2::from_angle(std::f64::consts::TAU * i as f64 / corners as f64);
    (0..corners).map(|i| centre + radius * at(i)).collect()
}

/// Returns a figure with a head, arms and legs.
#[must_use]
pub fn gingerbread() -> Rings {
    let half = [
        (500.0, 40.0),
        (560.0, 55.0),
        (605.0, 95.0),
        (620.0, 150.0),
        (605.0, 210.0),
        (570.0, 250.0),
        (560.0, 275.0),
        (600.0, 300.0),
        (690.0, 315.0),
        (790.0, 300.0),
        (850.0, 310.0),
        (880.0, 345.0),
        (870.0, 395.0),
        (820.0, 420.0),
        (720.0, 425.0),
        (640.0, 430.0),
        (610.0, 460.0),
        (605.0, 540.0),
        (620.0, 610.0),
        (660.0, 700.0),
        (720.0, 800.0),
        (745.0, 860.0),
        (735.0, 920.0),
        (690.0, 950.0),
        (630.0, 935.0),
        (590.0, 880.0),
        (550.0, 790.0),
        (520.0, 730.0),
    ];
    let right = half.iter().map(|&(x, y)| DVec2::new(x, y));
    let left = half.iter().rev().filter(|&&(x, _)| x > 500.0).map(|&(x, y)| DVec2::new(SIZE as f64 - x, y));
    vec![right.chain([DVec2::new(500.0, 715.0)]).chain(left).collect()]
}

/// Returns a band with many corners that winds two and a half times.
#[must_use]
pub fn spiral() -> Rings {
    let arm = |i: usize, width: f64| {
        let turn = 5.0 * std::f64::consts::PI * i as f64 / 160.0;
        DVec2::splat(500.0) + (60.0 + 24.0 * turn + width) * DVec2::from_angle(turn)
    };
    let outer = (0..=160).map(|i| arm(i, 45.0));
    let inner = (0..=160).rev().map(|i| arm(i, -45.0));
    vec![outer.chain(inner).collect()]
}

/// Returns a square with a hole of convex and reflex corners.
#[must_use]
pub fn holed_square() -> Rings {
    let hole = [
        (300.0, 300.0),
        (520.0, 350.0),
        (700.0, 280.0),
        (650.0, 480.0),
        (720.0, 650.0),
        (560.0, 600.0),
        (500.0, 720.0),
        (450.0, 600.0),
        (280.0, 690.0),
        (400.0, 480.0),
    ];
    let square = [(50.0, 50.0), (950.0, 50.0), (950.0, 950.0), (50.0, 950.0)];
    vec![square.map(DVec2::from).to_vec(), hole.map(DVec2::from).to_vec()]
}

/// Returns a bar with teeth 6 px wide and gaps of 3 px.
#[must_use]
pub fn comb() -> Rings {
    let mut ring = vec![DVec2::new(50.0, 100.0), DVec2::new(950.0, 100.0), DVec2::new(950.0, 250.0)];
    let mut x = 950.0;
    while x - 9.0 > 60.0 {
        ring.extend([(x, 800.0), (x - 6.0, 800.0), (x - 6.0, 250.0), (x - 9.0, 250.0)].map(DVec2::from));
        x -= 9.0;
    }
    ring.push(DVec2::new(50.0, 250.0));
    // The first tooth starts at the corner of the bar.
    ring.remove(2);
    ring.insert(2, DVec2::new(950.0, 240.0));
    vec![ring]
}

/// Returns the domain of a picture with bays, capes, holes and small scallops. It has more than 500 corners.
///
/// # Panics
/// Never, because the picture is generated here.
#[must_use]
pub fn alpha() -> Domain {
    let n = SIZE as usize;
    let mut rgba = vec![255_u8; n * n * 4];
    for (i, pixel) in rgba.chunks_exact_mut(4).enumerate() {
        let p = DVec2::new((i % n) as f64 + 0.5, (i / n) as f64 + 0.5) - 500.0;
        let angle = libm::atan2(p.y, p.x);
        let shore = 330.0 + 70.0 * libm::sin(5.0 * angle) + 12.0 * libm::sin(61.0 * angle);
        let lake = (p - DVec2::new(80.0, -60.0)).length() - 70.0 - 8.0 * libm::sin(23.0 * angle);
        let pond = (p - DVec2::new(-140.0, 90.0)).length() - 45.0;
        let depth = (shore - p.length()).min(lake).min(pond);
        pixel[3] = (255.0 * (depth + 0.5).clamp(0.0, 1.0)) as u8;
    }
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a valid picture");
    Domain::from_alpha(&picture, 0.5).expect("a picture with opaque parts")
}

/// Returns a convex domain.
#[must_use]
pub fn disc() -> Rings {
    vec![circle(DVec2::splat(500.0), 420.0, 48)]
}

/// Returns `count` points of a low-discrepancy sequence inside a domain, beginning at index `start`.
#[must_use]
pub fn scattered(domain: &VisibilityGraph, start: usize, count: usize) -> Vec<DVec2> {
    // Roberts' R2 sequence: multiples of the powers of the plastic number.
    let at = |i: usize| {
        let i = i as f64;
        DVec2::new((0.754_877_666_246_692_7 * i).fract(), (0.569_840_290_998_053_2 * i).fract()) * f64::from(SIZE)
    };
    (start..).map(at).filter(|&p| domain.contains(p)).take(count).collect()
}
