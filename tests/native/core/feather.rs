//! Tests of feathers: a moved part has a soft rim, and the picture at rest does not change.

use c2warp::{
    Canvas, Filter, Picture, ResampleOptions, Solution, Solver, Warped,
    project::{DomainSpec, FillSpec, Handle, Project},
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;

const WIDTH: u32 = 400;
const HEIGHT: u32 = 160;

fn circle(centre: [f64; 2], radius: f64) -> Vec<DVec2> {
    let corner = |k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 61.0) * radius;
    (0..61).map(|k| corner(k) + DVec2::from(centre)).collect()
}

fn polygon(corners: &[[f64; 2]]) -> Vec<DVec2> {
    corners.iter().copied().map(DVec2::from).collect()
}

/// Pixels by their column and row.
fn pixels(colour: impl FnMut((u32, u32)) -> [u8; 4]) -> Vec<u8> {
    (0..WIDTH * HEIGHT).map(|at| (at % WIDTH, at / WIDTH)).flat_map(colour).collect()
}

fn noise() -> Vec<u8> {
    let mut random = Random(5);
    pixels(|_| [random.below(256) as u8, random.below(256) as u8, 90, 255])
}

/// White on the left, black on the right.
fn halves() -> Vec<u8> {
    pixels(|(x, _)| if x < 200 { [255; 4] } else { [0, 0, 0, 255] })
}

fn project(rings: Vec<Vec<DVec2>>, feather: f64, [rest, posed]: [[f64; 2]; 2]) -> Project {
    let mut project = Project::for_picture(WIDTH, HEIGHT).with_editor_settings();
    project.domain = Some(DomainSpec::polygon(rings).feathered(feather));
    project.handles = vec![Handle::point("nose", rest).posed_at([posed])];
    project
}

/// A circle on the left that moves to the right.
fn moved(feather: f64) -> Project {
    project(vec![circle([100.0, 80.0], 30.0)], feather, [[100.0, 80.0], [300.0, 80.0]])
}

fn solved(project: &Project, rgba: &[u8]) -> Solution {
    solve(project, &Picture::new(WIDTH, HEIGHT, rgba).expect("a picture")).expect("a solution")
}

fn warped(project: &Project, rgba: &[u8], options: ResampleOptions) -> Warped {
    let solution = solved(project, rgba);
    let pose = solution.pose(project).expect("a pose");
    solution.warped(&Picture::new(WIDTH, HEIGHT, rgba).expect("a picture"), &pose, options).expect("a picture")
}

/// The red bytes of the row through the middle of the circle, where it was moved to.
fn rim(feather: f64) -> Vec<u8> {
    let warped = warped(&moved(feather), &halves(), ResampleOptions::default());
    (210..390).map(|x| warped.rgba[(80 * 400 + x) * 4]).collect()
}

fn largest_step(row: &[u8]) -> u8 {
    row.windows(2).map(|pair| pair[0].abs_diff(pair[1])).max().expect("a row of pixels")
}

fn shapes() -> [(Vec<Vec<DVec2>>, [f64; 2]); 4] {
    let comb = [
        [40.2, 20.7],
        [210.0, 21.1],
        [209.0, 130.5],
        [180.4, 130.0],
        [177.0, 40.0],
        [174.1, 130.0],
        [121.0, 40.2],
        [88.6, 128.0],
        [85.0, 41.0],
        [40.9, 132.3],
    ];
    let at_border = [[0.0, 20.3], [90.7, 30.0], [88.0, 160.0], [0.0, 160.0]];
    let near_border = [[3.0, 2.5], [120.0, 2.5], [118.0, 157.0], [3.0, 157.0]];
    [
        (vec![circle([90.3, 80.1], 50.7), circle([80.0, 70.0], 12.0)], [110.0, 95.0]),
        (vec![polygon(&comb)], [70.0, 35.0]),
        (vec![polygon(&at_border)], [40.0, 80.0]),
        (vec![polygon(&near_border), circle([130.0, 80.0], 8.0)], [60.0, 80.0]),
    ]
}

#[test]
fn picture_at_rest_is_the_same_to_the_bit() {
    let mut random = Random(7);
    let translucent = pixels(|_| [0; 4].map(|_: i32| random.below(256) as u8));
    for ((rings, at), rgba) in
        shapes().into_iter().flat_map(|shape| [noise(), translucent.clone()].map(|rgba| (shape.clone(), rgba)))
    {
        for (feather, scale) in [(2.0, 1.0), (9.5, 1.0), (64.0, 1.0), (20.0, 0.6), (20.0, 1.7)] {
            for fill in [None, Some(FillSpec::default())] {
                let options = ResampleOptions { scale, ..ResampleOptions::default() };
                let mut project = project(rings.clone(), feather, [at; 2]);
                project.fill = fill;
                let soft = warped(&project, &rgba, options);
                project.domain = project.domain.map(|domain| domain.feathered(0.0));
                assert!(soft == warped(&project, &rgba, options), "{feather} px at {scale}, {fill:?}, {rings:?}");
            }
        }
    }
}

#[test]
fn largest_step_across_the_rim_falls_as_the_width_grows() {
    assert!(largest_step(&rim(0.0)) > 120);
    for feather in [4.0, 8.0, 16.0, 32.0] {
        // The steepest place of t² (3 − 2 t) has a slope of 1.5.
        let (step, expected) = (f64::from(largest_step(&rim(feather))), 255.0 * 1.5 / feather);
        assert!((step - expected).abs() < 0.1 * expected + 2.0, "{feather} px: {step} of {expected}");
    }
}

#[test]
fn rim_begins_at_the_outline_and_ends_at_its_width() {
    for feather in [8.0, 16.0, 32.0] {
        let row = rim(feather);
        let at = |x: f64| row[(x - 210.0) as usize];
        // The right side of the circle is at 330.
        assert!(at(328.0) == 255 && at(330.0) > 240, "{feather}: {row:?}");
        assert!(at(330.0 + feather / 2.0).abs_diff(128) < 255 / feather as u8 + 4, "{feather}: {row:?}");
        assert!(at(330.0 + feather - 2.0) > 0 && at(330.0 + feather + 2.0) == 0, "{feather}: {row:?}");
        let falling: Vec<u8> = row[118..].to_vec();
        assert!(falling.is_sorted_by(|a, b| a >= b), "{feather}: {falling:?}");
    }
}

#[test]
fn rim_over_a_fill_begins_where_the_filled_pixels_end() {
    let mut project = moved(16.0);
    project.fill = Some(FillSpec::default());
    let warped = warped(&project, &halves(), ResampleOptions::default());
    let red = |x: usize| warped.rgba[(80 * 400 + x) * 4];
    assert!(warped.rgba.chunks(4).all(|pixel| pixel[3] == 255));
    assert!(red(332) == 255 && red(334) > 235 && red(350) == 0, "{:?}", (328..352).map(red).collect::<Vec<_>>());
    let row: Vec<u8> = (320..360).map(red).collect();
    assert!(largest_step(&row) < 30, "{row:?}");
    // Nothing is left of the part where it was: a ring around the hole would show.
    assert!((40..160).all(|x| red(x) == 255));
}

#[test]
fn rims_end_at_the_border_of_the_picture_and_in_the_middle_of_gaps() {
    let rgba = noise();
    let near = polygon(&[[3.0, 40.0], [100.0, 40.0], [100.0, 120.0], [3.0, 120.0]]);
    let beside = polygon(&[[110.0, 40.0], [200.0, 40.0], [200.0, 120.0], [110.0, 120.0]]);
    let solution = solved(&project(vec![near, beside], 32.0, [[50.0, 80.0]; 2]), &rgba);
    let feather = solution.feather();
    let (mut on_border, mut in_gap) = (0, 0);
    for (&place, &level) in feather.vertices().iter().zip(feather.levels()) {
        assert!(place.cmpge(DVec2::ZERO).all() && place.x <= 400.0 && place.y <= 160.0, "{place}");
        if place.x == 0.0 && (45.0..115.0).contains(&place.y) {
            on_border += 1;
            assert!(level.abs() < 1e-6, "{place}: {level}");
        }
        if (104.9..105.1).contains(&place.x) && (45.0..115.0).contains(&place.y) {
            in_gap += 1;
            assert!(level.abs() < 0.15, "{place}: {level}");
        }
    }
    assert!(on_border > 5 && in_gap > 5, "{on_border}, {in_gap}");
}

#[test]
fn a_notch_that_opens_is_not_spanned() {
    let notch =
        [[60.0, 30.0], [200.0, 30.0], [200.0, 150.0], [134.0, 150.0], [130.0, 60.0], [126.0, 150.0], [60.0, 150.0]];
    let mut project = project(vec![polygon(&notch)], 32.0, [[80.0, 140.0], [50.0, 140.0]]);
    project.handles.push(Handle::point("right", [180.0, 140.0]).posed_at([[210.0, 140.0]]));
    project.handles.push(Handle::point("top", [130.0, 40.0]));
    let warped = warped(&project, &pixels(|_| [255; 4]), ResampleOptions::default());
    // The notch was 6 px wide there, and is 60 px wider. Its background stays in the middle.
    let alpha: Vec<u8> = (90..170).map(|x| warped.rgba[(130 * 400 + x) * 4 + 3]).collect();
    assert!(alpha.iter().filter(|&&alpha| alpha == 0).count() > 30, "{alpha:?}");
}

#[test]
fn each_vertex_moves_with_a_sample_of_the_outline() {
    let rgba = noise();
    for (rings, at) in shapes() {
        let solution = solved(&project(rings, 20.0, [at; 2]), &rgba);
        let feather = solution.feather();
        let edges = || {
            let rings = solution.domain().rings().iter();
            rings.flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)))
        };
        let on_outline =
            |p: DVec2| edges().any(|(&a, &b)| (p.distance(a) + p.distance(b) - a.distance(b)).abs() < 1e-6);
        assert!(feather.owners().iter().all(|&owner| on_outline(solution.vertices()[owner as usize])));
        assert_eq!(feather.vertices().len(), feather.levels().len());
        assert!(feather.triangles().iter().flatten().all(|&vertex| (vertex as usize) < feather.levels().len()));
    }
}

#[test]
fn held_outlines_and_other_domains_have_no_rim() {
    let rgba = noise();
    let mut project = moved(16.0);
    assert!(!solved(&project, &rgba).feather().triangles().is_empty());
    project.fix_boundary = true;
    assert!(solved(&project, &rgba).feather().triangles().is_empty());
    project.domain = Some(DomainSpec::Image.feathered(16.0));
    assert!(solved(&project, &rgba).feather().triangles().is_empty());
    assert!(solved(&moved(0.0), &rgba).feather().triangles().is_empty());
}

#[test]
fn pixel_art_and_maps_have_no_rim() {
    let rgba = noise();
    let options = ResampleOptions { filter: Filter::Nearest, ..ResampleOptions::default() };
    assert!(warped(&moved(16.0), &rgba, options) == warped(&moved(0.0), &rgba, options));
    let picture = Picture::new(WIDTH, HEIGHT, &rgba).expect("a picture");
    let [soft, sharp] = [16.0, 0.0].map(|feather| {
        let solution = solved(&moved(feather), &rgba);
        let pose = solution.pose(&moved(feather)).expect("a pose");
        let drawing = solution.drawing(&picture, &pose, ResampleOptions::default()).expect("a drawing");
        drawing.sources(&picture, 0..HEIGHT)
    });
    assert_eq!(soft, sharp);
}

#[test]
fn the_same_pixels_on_every_canvas_and_in_bands() {
    let rgba = noise();
    let project = project(vec![circle([100.0, 80.0], 30.0)], 24.0, [[100.0, 80.0], [370.0, 80.0]]);
    let picture = warped(&project, &rgba, ResampleOptions::default());
    let grown = warped(&project, &rgba, ResampleOptions { canvas: Canvas::Grown, ..ResampleOptions::default() });
    // The circle goes to 400, and its rim on to 424.
    assert!((420..=424).contains(&grown.width) && grown.height == HEIGHT, "{}", grown.width);
    let rows = grown.rgba.chunks(grown.width as usize * 4).map(|row| &row[..1600]);
    assert!(picture.rgba.chunks(1600).eq(rows));
}

#[test]
fn reused_solver_gives_the_same_feather() {
    let rgba = noise();
    let picture = Picture::new(WIDTH, HEIGHT, &rgba).expect("a picture");
    let mut solver = Solver::new();
    let mut project = moved(12.0);
    project.fill = Some(FillSpec::default());
    for feather in [12.0, 30.0, 0.0, 12.0] {
        project.domain = project.domain.map(|domain| domain.feathered(feather));
        // One handle inside, and one on the outline.
        project.handles = vec![project.handles[0].clone()];
        for at in [[110.0, 70.0], [130.0, 80.0]] {
            project.handles.push(Handle::point(format!("{at:?}"), at));
            solver.begin(&project, &picture).expect("a project");
            while solver.advance().expect("a stage").is_some() {}
            let reused = solver.solution().expect("every stage has run");
            assert_eq!(reused.feather(), solved(&project, &rgba).feather());
            let steps = std::iter::from_fn(|| solver.advance_fill(&picture).expect("a step")).count();
            // The fill depends only on the rings.
            assert!(steps == 0 || feather == 12.0);
        }
    }
}
