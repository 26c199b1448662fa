//! Tests of fills: the picture behind a lassoed part is whole, and nothing is seen of it at rest.

use c2warp::{
    Error, Picture, ResampleOptions, Solver, Warped,
    domain::Domain,
    fill::{Fill, fill},
    project::{DomainSpec, FillSpec, Handle, Project},
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;

fn circle(centre: [f64; 2], radius: f64, count: u32) -> Vec<DVec2> {
    let corner = |k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / f64::from(count)) * radius;
    (0..count).map(|k| corner(k) + DVec2::from(centre)).collect()
}

fn all() -> Vec<DVec2> {
    [(0.0, 0.0), (160.0, 0.0), (160.0, 120.0), (0.0, 120.0)].map(DVec2::from).to_vec()
}

/// Opaque pixels by their column and row.
fn pixels(colour: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    (0..WIDTH * HEIGHT).flat_map(|at| colour(at % WIDTH, at / WIDTH)).collect()
}

fn noise() -> Vec<u8> {
    let mut random = Random(5);
    (0..WIDTH * HEIGHT).flat_map(|_| [random.below(256) as u8, random.below(256) as u8, 90, 255]).collect()
}

fn project(rings: Vec<Vec<DVec2>>, [rest, posed]: [[f64; 2]; 2]) -> Project {
    let mut project = Project::for_picture(WIDTH, HEIGHT).with_editor_settings();
    project.domain = Some(DomainSpec::polygon(rings));
    project.fill = Some(FillSpec::default());
    project.handles = vec![Handle::point("nose", rest).posed_at([posed])];
    project
}

fn warped(project: &Project, rgba: &[u8], options: ResampleOptions) -> Warped {
    let picture = Picture::new(WIDTH, HEIGHT, rgba).expect("a picture");
    let solution = solve(project, &picture).expect("a solution");
    let pose = solution.pose(project).expect("a pose");
    solution.warped(&picture, &pose, options).expect("a picture")
}

fn filled(rgba: &[u8], rings: &[Vec<DVec2>], seed: u32) -> Result<Fill, Error> {
    let picture = Picture::new(WIDTH, HEIGHT, rgba).expect("a picture");
    let mut spec = FillSpec::default();
    spec.seed = seed;
    fill(&picture, &Domain::from_rings(rings).expect("a domain"), &spec)
}

#[test]
fn picture_at_rest_is_unchanged() {
    let rgba = noise();
    let comb: Vec<DVec2> = [
        (40.2, 30.7),
        (110.0, 31.1),
        (109.0, 90.5),
        (100.4, 90.0),
        (97.0, 40.0),
        (94.1, 90.0),
        (91.0, 40.2),
        (88.6, 88.0),
        (85.0, 41.0),
        (40.9, 92.3),
    ]
    .map(DVec2::from)
    .to_vec();
    let edge: Vec<DVec2> = [(0.0, 20.3), (90.7, 30.0), (88.0, 120.0), (0.0, 120.0)].map(DVec2::from).to_vec();
    let ring = vec![circle([70.3, 60.1], 40.7, 31), circle([50.0, 50.0], 8.0, 7)];
    for (rings, at) in [(ring, [70.0, 60.0]), (vec![comb], [70.0, 35.0]), (vec![edge], [40.0, 60.0])] {
        for held in [false, true] {
            let mut project = project(rings.clone(), [at; 2]);
            project.fix_boundary = held;
            assert!(warped(&project, &rgba, ResampleOptions::default()).rgba == rgba, "held: {held}, {rings:?}");
        }
    }
}

#[test]
fn moved_part_leaves_no_gap() {
    let rgba = noise();
    let rings = vec![circle([70.3, 60.1], 40.7, 31)];
    for (posed, scale) in [([70.4, 60.2], 1.0), ([75.0, 62.0], 1.0), ([120.0, 70.0], 0.5), ([120.0, 70.0], 1.7)] {
        let options = ResampleOptions { scale, ..ResampleOptions::default() };
        let warped = warped(&project(rings.clone(), [[70.0, 60.0], posed]), &rgba, options);
        assert!(warped.rgba.chunks(4).all(|pixel| pixel[3] == 255), "{posed:?} at {scale}");
    }
}

#[test]
fn surroundings_stay_as_they_are() {
    let rgba = noise();
    let warped = warped(
        &project(vec![circle([40.0, 60.0], 20.0, 31)], [[40.0, 60.0], [100.0, 60.0]]),
        &rgba,
        ResampleOptions::default(),
    );
    for (at, (now, before)) in warped.rgba.chunks(4).zip(rgba.chunks(4)).enumerate() {
        let (x, y) = ((at % 160) as f64 + 0.5, (at / 160) as f64 + 0.5);
        let away = |x0: f64| (x - x0).hypot(y - 60.0);
        assert!(now == before || away(40.0) < 24.0 || away(100.0) < 24.0, "{x}, {y}");
    }
}

#[test]
fn fill_is_the_same_each_time_and_for_each_order_of_handles() {
    let rgba = noise();
    let ring = [circle([70.0, 60.0], 25.0, 31)];
    assert_eq!(filled(&rgba, &ring, 3), filled(&rgba, &ring, 3));
    assert_ne!(filled(&rgba, &ring, 3), filled(&rgba, &ring, 4));
}

#[test]
fn uniform_colour_is_continued() {
    let rgba = pixels(|_, _| [10, 200, 90, 255]);
    let fill = filled(&rgba, &[circle([70.0, 60.0], 30.0, 31)], 0).expect("a fill");
    assert!(fill.rgba().chunks(4).all(|pixel| *pixel == [10, 200, 90, 255]));
}

#[test]
fn stripes_continue_through_the_hole() {
    let stripes =
        |x: u32, y: u32| if ((x + y / 8) / 6).is_multiple_of(2) { [220, 40, 30, 255] } else { [20, 60, 200, 255] };
    let rgba = pixels(stripes);
    let fill = filled(&rgba, &[circle([80.0, 60.0], 18.0, 31)], 0).expect("a fill");
    let [left, top] = fill.origin();
    let wrong = fill.rgba().chunks(4).enumerate().filter(|(at, pixel)| {
        let (x, y) = (left + *at as u32 % fill.width(), top + *at as u32 / fill.width());
        stripes(x, y).iter().zip(*pixel).any(|(a, b)| a.abs_diff(*b) > 60)
    });
    let (wrong, all) = (wrong.count(), fill.rgba().len() / 4);
    assert!(wrong * 20 < all, "{wrong} of {all} pixels are wrong");
}

#[test]
fn transparent_surroundings_stay_transparent() {
    let rgba =
        pixels(|x, y| if x.abs_diff(70).pow(2) + y.abs_diff(60).pow(2) < 400 { [200, 90, 20, 255] } else { [0; 4] });
    let fill = filled(&rgba, &[circle([70.0, 60.0], 30.0, 31)], 0).expect("a fill");
    assert!(fill.rgba().chunks(4).all(|pixel| *pixel == [0; 4]));
}

#[test]
fn small_and_large_domains_are_filled() {
    let rgba = noise();
    let dot: Vec<DVec2> = [(50.0, 50.0), (51.0, 50.0), (51.0, 51.0)].map(DVec2::from).to_vec();
    let nearly_all: Vec<DVec2> = [(4.0, 4.0), (156.0, 4.0), (156.0, 116.0), (4.0, 116.0)].map(DVec2::from).to_vec();
    for ring in [dot, nearly_all] {
        let fill = filled(&rgba, &[ring], 0).expect("a fill");
        assert!(fill.rgba().chunks(4).all(|pixel| pixel[3] == 255));
        // Colours come from the picture, whose blue is the same everywhere.
        assert!(fill.rgba().chunks(4).all(|pixel| pixel[2].abs_diff(90) <= 1));
    }
}

#[test]
fn domain_of_the_whole_picture_has_nothing_to_fill_from() {
    let rgba = noise();
    assert_eq!(filled(&rgba, &[all()], 0), Err(Error::NothingToFillFrom));
    let error =
        solve(&project(vec![all()], [[70.0, 60.0]; 2]), &Picture::new(WIDTH, HEIGHT, &rgba).expect("a picture"));
    let error = error.expect_err("nothing to fill from");
    assert_eq!(error.code(), "nothing-to-fill-from");
    assert!(error.to_string().contains("domain.rings"), "{error}");
}

#[test]
fn other_domains_ignore_a_fill() {
    let rgba = noise();
    let picture = Picture::new(WIDTH, HEIGHT, &rgba).expect("a picture");
    for domain in [None, Some(DomainSpec::Image), Some(DomainSpec::Alpha { threshold: 0.5 })] {
        let mut project = project(Vec::new(), [[75.0, 60.0]; 2]);
        project.domain = domain;
        assert!(solve(&project, &picture).expect("a solution").fill().is_none());
    }
}

#[test]
fn fill_is_kept_for_other_handles_and_continues_between_solves() {
    let rgba = noise();
    let picture = Picture::new(WIDTH, HEIGHT, &rgba).expect("a picture");
    let mut project = project(vec![circle([70.3, 60.1], 40.7, 31)], [[70.0, 60.0], [75.0, 62.0]]);
    let mut solver = Solver::new();
    let solve = |solver: &mut Solver, project: &Project| {
        solver.begin(project, &picture).expect("a project");
        while solver.advance().expect("a solve").is_some() {}
    };
    solve(&mut solver, &project);
    assert!(solver.solution().is_some_and(|solution| solution.fill().is_none()));
    let mut done = vec![0.0];
    for _ in 0..5 {
        done.extend(solver.advance_fill(&picture).expect("a fill"));
    }
    project.handles.push(Handle::point("chin", [60.0, 80.0]));
    solve(&mut solver, &project);
    while let Some(part) = solver.advance_fill(&picture).expect("a fill") {
        done.push(part);
    }
    assert!(done.is_sorted() && done.last() == Some(&1.0), "{done:?}");
    let fill = solver.solution().and_then(|solution| solution.fill().cloned());
    assert!(fill.is_some());
    // The next solution has it at once.
    project.handles.pop();
    solve(&mut solver, &project);
    assert_eq!(solver.advance_fill(&picture), Ok(None));
    assert!(solver.solution().and_then(|solution| solution.fill().cloned()) == fill);
    // Without it, the solution is another one.
    project.fill = None;
    assert!(!solver.has_solved(&project));
    solve(&mut solver, &project);
    assert_eq!(solver.advance_fill(&picture), Ok(None));
    assert!(solver.solution().is_some_and(|solution| solution.fill().is_none()));
}
