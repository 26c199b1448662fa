//! Cells of many handles, and the limits that keep a solve within seconds and a gigabyte.

use c2warp::{
    Error, Picture, Solution,
    domain::Domain,
    project::{DomainSpec, Handle, Project},
    solve, solve_domain,
};
use glam::DVec2;

const SIDE: u32 = 1000;

/// Fractional parts of multiples of two irrational numbers: points that no lattice has.
fn scattered(count: usize) -> impl Iterator<Item = DVec2> {
    let at = |i: u32| (DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_2) * f64::from(i)).fract();
    (1..).map(at).take(count)
}

fn points(places: impl Iterator<Item = DVec2>) -> Project {
    let handles = places.enumerate().map(|(at, place)| Handle::point(format!("{at}"), place));
    Project::for_picture(SIDE, SIDE).with_handles(handles).with_editor_settings()
}

fn solved(project: &Project) -> Result<Solution, Error> {
    let rgba = vec![255; (SIDE * SIDE * 4) as usize];
    solve(project, &Picture::new(SIDE, SIDE, &rgba)?)
}

fn on_circle(turn: f64, radius: f64) -> DVec2 {
    DVec2::splat(500.0) + radius * DVec2::from_angle(turn * std::f64::consts::TAU)
}

/// A star whose rays begin at a distance of `inner` from the middle.
fn star(rays: usize, inner: f64) -> DomainSpec {
    let corner = |at: usize| on_circle(at as f64 / (2 * rays) as f64, if at.is_multiple_of(2) { 500.0 } else { inner });
    DomainSpec::polygon(vec![(0..2 * rays).map(corner).collect()])
}

/// In a rectangle paths are straight, so a search over all sites has the right values.
#[test]
fn cells_and_separations_are_those_of_a_search_over_all_sites() {
    let side = f64::from(SIDE);
    // All over the picture, and within a small part of it.
    for share in [1.0, 0.02] {
        let solution = solved(&points(scattered(120).map(|p| (0.4 + share * p) * (side / 1.4)))).expect("a solution");
        let sites = solution.sites();
        for (at, site) in sites.iter().enumerate() {
            let others = sites.iter().enumerate().filter(|&(other, _)| other != at).map(|(_, other)| other);
            let nearest = others.map(|other| other.rest.distance(site.rest)).fold(f64::INFINITY, f64::min);
            assert!((nearest - site.separation).abs() < 1e-9, "{nearest} and {}", site.separation);
        }
        let mut reached = vec![0.0_f64; sites.len()];
        for p in scattered(50_000).map(|p| p * side) {
            let distance = |site: usize| sites[site].rest.distance(p);
            let nearest = (0..sites.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).expect("a site");
            reached[nearest] = reached[nearest].max(distance(nearest));
        }
        for (reached, site) in reached.into_iter().zip(sites) {
            assert!(reached <= site.cell_radius + 1e-9, "{reached} of {}", site.cell_radius);
            assert!(site.cell_radius <= site.separation * 1.7, "{} of {}", site.cell_radius, site.separation);
        }
    }
}

#[test]
fn a_thousand_handles_are_solved() {
    let solution = solved(&points(scattered(1000).map(|p| p * f64::from(SIDE)))).expect("a solution");
    assert_eq!(solution.sites().iter().filter(|site| site.kind.is_real()).count(), 1000);
}

#[test]
fn handles_crowd_up_to_a_limit() {
    let line = |count: usize, gap: f64| points((0..count).map(|at| DVec2::new(300.0 + gap * at as f64, 500.0)));
    assert!(solved(&line(50, 0.02)).is_ok());
    for (count, gap, limit) in [(51, 0.02, 50), (201, 1.0, 200)] {
        let error = solved(&line(count, gap)).expect_err("a limit");
        assert_eq!((error.code(), error.handles()), ("handles-crowded", vec!["0"]));
        let told = error.to_string();
        assert!(
            told.contains(&format!("{count} point handles")) && told.contains(&format!("at most {limit} ")),
            "{told}"
        );
    }
    assert!(solved(&line(60, 3.0)).is_ok());
}

#[test]
fn an_outline_has_a_greatest_length() {
    let in_star = |rays: usize| {
        let mut project = points([DVec2::splat(500.0)].into_iter());
        project.domain = Some(star(rays, 30.0));
        solved(&project)
    };
    assert!(in_star(60).is_ok());
    let error = in_star(1000).expect_err("a limit");
    assert_eq!(error.code(), "outline-too-long");
    assert!(error.to_string().contains("at most 28"), "{error}");
}

/// Hundreds of sites are tied in the hub. Each triple of them was a node of the first pose.
#[test]
fn a_hundred_handles_in_a_star_are_posed() {
    let mut project = points((0..100).map(|at| on_circle(f64::from(at) / 100.0, 450.0)));
    project.domain = Some(star(300, 30.0));
    let solution = solved(&project).expect("a solution");
    let bytes = solution.poser().to_bytes().len();
    assert!(bytes < 10_000_000, "{bytes} bytes");
    assert!(solution.pose(&project).is_ok());
}

/// Handles in short rays: the cells of all reach into the hub.
#[test]
fn a_solve_has_a_greatest_number_of_steps() {
    let mut project = points((0..600).map(|at| on_circle(f64::from(at) / 600.0, 490.0)));
    project.domain = Some(star(600, 467.0));
    project.pose.density = 0;
    let error = solved(&project).expect_err("a limit");
    assert_eq!(error.code(), "too-much-work");
    assert!(error.to_string().contains("more than 100000000 steps"), "{error}");
}

/// Places beyond its tip counted as inside, so cells there were divided until the solve was refused.
#[test]
fn a_spike_of_no_width_needs_few_sites() {
    let spike = [(-87.0, -46.0), (0.0, 9.0), (1.16e-9, 9.000_000_000_09), (0.0, 0.0)].map(DVec2::from).to_vec();
    let mut project = points([(0.0, 0.5), (0.0, 0.0)].map(DVec2::from).into_iter());
    (project.samples, project.pose.density) = (100, 0);
    let solution = solve_domain(&project, &Domain::from_rings(&[spike]).expect("a domain")).expect("a solution");
    assert!(solution.sites().len() < 50, "{} sites", solution.sites().len());
}

#[test]
fn bars_have_no_more_pieces_than_sites() {
    let step = f64::from(SIDE) / 100.0;
    let square =
        |at: DVec2, side: f64| [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| at + corner * side).to_vec();
    let hole = |at: u32| square(DVec2::new(f64::from(at % 100) + 0.25, f64::from(at / 100) * 25.0) * step, step / 2.0);
    let holes = (0..400).map(hole).filter(|hole| hole[0].y > 0.0);
    let rings = std::iter::once(square(DVec2::ZERO, f64::from(SIDE))).chain(holes);
    let mut project = points(std::iter::empty());
    project.domain = Some(DomainSpec::polygon(rings.collect()));
    // 30 bars across each of three rows of 100 holes.
    project.handles = (0..90)
        .map(|at| {
            let y = f64::from(at / 30 + 1) * 25.0 * step + (f64::from(at % 30) + 0.5) / 30.0 * step / 2.0;
            Handle::bar(at.to_string(), [DVec2::new(1.0, y), DVec2::new(f64::from(SIDE) - 1.0, y)])
        })
        .collect();
    assert_eq!(solved(&project).expect_err("a limit").code(), "too-many-sites");
}

/// The cell of one handle reaches as far as the other, and that of the other almost three times as far.
#[test]
fn a_long_cell_beside_a_short_one_is_divided() {
    let sliver = [(0.0, 0.0), (0.0, 35.5), (3.6e-6, 0.0)].map(DVec2::from).to_vec();
    let mut project = points([(0.0, 9.0), (0.0, 0.0)].map(DVec2::from).into_iter());
    (project.samples, project.pose.density) = (100, 0);
    let solution = solve_domain(&project, &Domain::from_rings(&[sliver]).expect("a domain")).expect("a solution");
    let divided = solution.sites().iter().all(|site| site.cell_radius < site.support_radius);
    assert!(divided, "{:#?}", solution.sites());
}
