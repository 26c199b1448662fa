//! Tests of outlines from alpha: their position, thin parts and narrow gaps.

use c2warp::{Error, Picture, domain::Domain, project::DomainSpec};
use c2warp_tests::Random;
use glam::DVec2;

use crate::alpha_shapes::{coverage, disc, stroke};

/// Side of the pictures in pixels, larger than a sprite. In a sprite, specks are islands.
const SIZE: u32 = 136;

/// Returns the domain of a picture with this alpha at each pixel.
fn domain_of(alpha: impl Fn(u32, u32) -> u8) -> Result<Domain, Error> {
    let rgba: Vec<u8> = (0..SIZE * SIZE).flat_map(|i| [0, 0, 0, alpha(i % SIZE, i / SIZE)]).collect();
    Domain::from_alpha(&Picture::new(SIZE, SIZE, &rgba).expect("a valid picture"), 0.5)
}

/// Returns the domain of a shape, given by its signed distance.
fn domain(depth: impl Fn(DVec2) -> f64) -> Result<Domain, Error> {
    domain_of(coverage(depth))
}

#[test]
fn outline_of_a_disc_is_accurate_to_a_fraction_of_a_pixel() {
    let centre = DVec2::new(60.3, 59.8);
    let domain = domain(disc(centre, 40.0)).expect("a disc");
    assert_eq!((domain.islands(), domain.holes(), domain.specks()), (1, 0, 0));
    // Alpha encodes distances up to half a pixel. Next to a full or empty pixel, the crossing is off by up to 0.1 px.
    for p in &domain.rings()[0] {
        assert!((p.distance(centre) - 40.0).abs() < 0.15);
    }
    let area = std::f64::consts::PI * 1600.0;
    assert!((domain.area() - area).abs() < 0.01 * area);
    assert!(domain.rings()[0].len() < 60);
}

#[test]
fn whisker_of_two_pixels_is_connected_in_every_direction() {
    for step in 0..24 {
        let along = DVec2::from_angle(std::f64::consts::TAU * f64::from(step) / 24.0);
        let (body, tip) = (DVec2::new(60.2, 60.7), DVec2::new(60.2, 60.7) + 55.0 * along);
        let (head, whisker) = (disc(body, 12.0), stroke(body, tip, 2.0));
        let domain = domain(|p| head(p).max(whisker(p))).expect("a head");
        assert_eq!((domain.islands(), domain.holes()), (1, 0), "step {step}");
        let reach = domain.rings()[0].iter().map(|p| p.distance(body)).fold(0.0, f64::max);
        assert!(reach > 54.0, "step {step} reaches {reach}");
    }
}

#[test]
fn fingers_two_pixels_apart_stay_separate_in_every_direction() {
    for step in 0..24 {
        let along = DVec2::from_angle(std::f64::consts::TAU * f64::from(step) / 24.0);
        let side = 4.0 * along.perp();
        let palm = DVec2::new(60.4, 59.9) - 30.0 * along;
        let finger = |side: DVec2| stroke(palm + side, palm + side + 60.0 * along, 6.0);
        let (left, right, hand) = (finger(side), finger(-side), disc(palm, 14.0));
        let domain = domain(|p| left(p).max(right(p)).max(hand(p))).expect("a hand");
        assert_eq!((domain.islands(), domain.holes()), (1, 0), "step {step}");
        // The shortest path between the tips goes through the palm.
        let navigation = c2warp::distance::Navigation::new(&domain);
        let [a, b] = [side, -side].map(|side| palm + side + 58.0 * along);
        let distances = navigation.distances_from(a).expect("a tip");
        assert!(distances.to(b).expect("the other tip") > 80.0, "step {step}");
    }
}

#[test]
fn holes_and_islands_are_kept_and_specks_are_counted() {
    let ring = |p: DVec2| 10.0 - (p.distance(DVec2::new(35.0, 35.0)) - 20.0).abs();
    let (island, dust, grain) =
        (disc(DVec2::new(90.0, 80.0), 18.0), disc(DVec2::new(90.0, 20.0), 0.9), disc(DVec2::new(20.0, 100.0), 0.8));
    let domain = domain(|p| ring(p).max(island(p)).max(dust(p)).max(grain(p))).expect("a ring");
    assert_eq!((domain.islands(), domain.holes(), domain.specks()), (2, 1, 2));
}

#[test]
fn single_pixel_of_a_sprite_is_an_island() {
    let mut rgba = vec![0; 16 * 16 * 4];
    for at in [0, 1, 16, 17, 18, 120, 255] {
        rgba[4 * at + 3] = 255;
    }
    let domain =
        Domain::from_alpha(&Picture::new(16, 16, &rgba).expect("a valid picture"), 0.5).expect("opaque pixels");
    assert_eq!((domain.islands(), domain.holes(), domain.specks()), (3, 0, 0));
}

/// Pictures with soft and hard edges of every slope, and with noise. The corners must agree to the last bit.
#[test]
fn outline_of_a_mirrored_picture_is_mirrored() {
    let mut random = Random(11);
    for case in 0..60 {
        let grain = 1 + random.below(12) as u32;
        let noise: Vec<u8> = (0..SIZE * SIZE).map(|_| random.below(256) as u8).collect();
        let position = |random: &mut Random| 120.0 * DVec2::new(random.unit(), random.unit());
        let strokes: Vec<(DVec2, DVec2, f64)> =
            (0..4).map(|_| (position(&mut random), position(&mut random), 1.0 + 20.0 * random.unit())).collect();
        let drawn = coverage(|p| strokes.iter().map(|&(a, b, w)| stroke(a, b, w)(p)).fold(f64::MIN, f64::max));
        let alpha = |x: u32, y: u32| match case % 3 {
            0 => noise[(y / grain * SIZE + x / grain) as usize],
            1 => drawn(x, y),
            _ => 255 * u8::from(drawn(x, y) > 127),
        };
        let last = SIZE - 1;
        let corners = |domain: Result<Domain, Error>, change: fn(DVec2) -> DVec2| {
            let rings = domain.map_or_else(|_| Vec::new(), |domain| domain.rings().to_vec());
            let mut corners: Vec<(u64, u64)> =
                rings.into_iter().flatten().map(change).map(|p| (p.x.to_bits(), p.y.to_bits())).collect();
            corners.sort_unstable();
            corners
        };
        let here = |change| corners(domain_of(alpha), change);
        let there = |domain| corners(domain, |p| p);
        assert!(
            here(|p| DVec2::new(f64::from(SIZE) - p.x, p.y)) == there(domain_of(|x, y| alpha(last - x, y))),
            "case {case}"
        );
        assert!(
            here(|p| DVec2::new(p.x, f64::from(SIZE) - p.y)) == there(domain_of(|x, y| alpha(x, last - y))),
            "case {case}"
        );
        assert!(here(|p| DVec2::new(p.y, p.x)) == there(domain_of(|x, y| alpha(y, x))), "case {case}");
    }
}

#[test]
fn transparent_pictures_and_specks_alone_are_rejected() {
    assert_eq!(domain(|_| -1.0), Err(Error::NothingOpaque { threshold: 0.5 }));
    let dust = disc(DVec2::new(60.0, 60.0), 0.9);
    assert_eq!(domain(dust), Err(Error::OnlySpecks { threshold: 0.5, specks: 1 }));
}

#[test]
fn opaque_picture_has_a_domain_up_to_its_border() {
    let domain = domain(|p| 200.0 - p.x).expect("a picture");
    let (low, high) = domain.bounds();
    assert_eq!((low, high), (DVec2::ZERO, DVec2::splat(f64::from(SIZE))));
    assert!((domain.area() - f64::from(SIZE * SIZE)).abs() < 1.0);
}

#[test]
fn invalid_rings_are_rejected_by_key() {
    let ring = |points: &[(f64, f64)]| -> Vec<DVec2> { points.iter().map(|&p| p.into()).collect() };
    let square = ring(&[(10.0, 10.0), (90.0, 10.0), (90.0, 90.0), (10.0, 90.0)]);
    let rgba = [255; 100 * 100 * 4];
    let picture = Picture::new(100, 100, &rgba).expect("a valid picture");
    let rejected = |rings: &[Vec<DVec2>]| {
        let spec = DomainSpec::polygon(rings.to_vec());
        Domain::new(Some(&spec), &picture).expect_err("not a domain").to_string()
    };
    let with = |other: &[(f64, f64)]| rejected(&[square.clone(), ring(other)]);
    assert_eq!(with(&[(20.0, 20.0), (30.0, 20.0)]), "domain.rings[1]: expected at least 3 points, found 2");
    assert_eq!(
        with(&[(20.0, 20.0), (f64::NAN, 20.0), (20.0, 30.0)]),
        "domain.rings[1][1][0]: expected a finite number, found NaN"
    );
    assert_eq!(rejected(&[]), "domain.rings: expected at least one ring");
    assert!(
        with(&[(20.0, 20.0), (130.0, 20.0), (20.0, 30.0)]).starts_with("domain.rings[1][1] = (130, 20) lies outside")
    );
    assert_eq!(
        with(&[(20.0, 20.0), (30.0, 20.0), (30.0, 30.0), (20.0, 20.0)]),
        "domain.rings[1][3] coincides with domain.rings[1][0]: move or remove one of them"
    );
    assert_eq!(
        rejected(&[ring(&[(10.0, 10.0), (90.0, 90.0), (90.0, 10.0), (10.0, 90.0)])]),
        "the edge after domain.rings[0][2] crosses or touches the edge after domain.rings[0][0]: move one of them"
    );
    assert_eq!(
        with(&[(50.0, 50.0), (95.0, 50.0), (50.0, 60.0)]),
        "the edge after domain.rings[1][0] crosses or touches the edge after domain.rings[0][1]: move one of them"
    );
    assert_eq!(
        rejected(&[ring(&[(10.0, 10.0), (50.0, 50.0), (90.0, 90.0), (30.0, 30.0)])]),
        "the edge after domain.rings[0][3] crosses or touches the edge after domain.rings[0][0]: move one of them"
    );
}

#[test]
fn rings_without_a_picture_have_a_coordinate_limit() {
    let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec();
    let domain = Domain::from_rings(&[square(-1e6, 1e6), square(-1.0, 1.0)]).expect("a square with a hole");
    assert_eq!((domain.islands(), domain.holes(), domain.area()), (1, 1, 4e12 - 4.0));
    let rejected = |rings: &[Vec<DVec2>]| Domain::from_rings(rings).expect_err("not a domain");
    assert_eq!(rejected(&[square(0.0, 1.0), square(2.0, 1.1e6)]), Error::RingPoint { ring: 1, point: 1 });
    for invalid in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(rejected(&[square(0.0, invalid)]).code(), "project");
    }
    assert_eq!(rejected(&[square(0.0, 1e-4)]), Error::RingFlat { ring: 0 });
    assert_eq!(rejected(&[Vec::new()]).to_string(), "domain.rings[0]: expected at least 3 points, found 0");
}

#[test]
fn rings_with_too_many_corners_are_rejected() {
    let ring: Vec<DVec2> =
        (0..20_001).map(|i| DVec2::splat(50.0) + 40.0 * DVec2::from_angle(f64::from(i) * 3e-4)).collect();
    let error = Domain::from_rings(&[ring]).expect_err("too many points");
    assert_eq!(error, Error::RingsTooFine { corners: 20_001 });
    assert!(!error.to_string().contains("threshold"), "{error}");
}
