//! Tests of drawings: SVG in, SVG out.

use c2warp::glam::DVec2;
use c2warp::project::{Handle, Project};
use c2warp::{ContinuedMap, Picture, Solution, solve};
use c2warp_vector::{BentOptions, Drawing, VectorError};
use kurbo::{Affine, BezPath, Line, ParamCurve, ParamCurveArclen, ParamCurveNearest, PathSeg, Point, Rect};
use serde_json::Value;
use usvg::roxmltree::Document;

use crate::command::{command, fail, succeed};
use crate::scene_folder::SceneFolder;

const FEATURES: &str = include_str!("../../drawings/features.svg");
const SIDE: u32 = 480;
/// Icons of each set.
const ICONS: usize = 110;
/// Length of measured lines, in pixels at rest.
const STEP: f64 = 0.25;
/// Least number of lines of a segment: short ones may turn sharply.
const LEAST: f64 = 32.0;
/// Lines that share a box.
const RUN: usize = 32;

/// A project that bends a square picture as a whole, turned and stretched at four of five places.
fn bending_project() -> Project {
    let mut project = Project::for_picture(SIDE, SIDE);
    let handle = |id, rest: [f64; 2], posed: [f64; 2]| Handle::point(id, rest).posed_at([posed]);
    project.handles = vec![
        handle("a", [60.0, 60.0], [110.0, 40.0]),
        handle("b", [420.0, 60.0], [400.0, 120.0]),
        handle("c", [240.0, 240.0], [240.0, 240.0]),
        handle("d", [60.0, 420.0], [40.0, 380.0]),
        handle("e", [420.0, 420.0], [450.0, 440.0]),
    ];
    project
}

fn bending_solution() -> (Project, Solution) {
    let project = bending_project();
    let solution = solve(&project, &Picture::new(SIDE, SIDE, &vec![255; (SIDE * SIDE * 4) as usize]).unwrap()).unwrap();
    (project, solution)
}

/// The paths of a drawing in pixels of the picture, those of clip paths and masks included.
fn paths(svg: &str, size: [f64; 2]) -> Vec<BezPath> {
    let side = f64::from(SIDE);
    let to_pixels = Affine::scale_non_uniform(side / size[0], side / size[1]);
    let document = Document::parse(svg).unwrap();
    let drawn = document.descendants().filter(|node| {
        let is_hidden = node.ancestors().any(|node| matches!(node.tag_name().name(), "pattern" | "defs"));
        node.tag_name().name() == "path" && !is_hidden
    });
    let of_path = |node: usvg::roxmltree::Node<'_, '_>| {
        let transforms = node.ancestors().filter_map(|node| node.attribute("transform")).map(|text| {
            let numbers = text.trim_start_matches("matrix(").trim_end_matches(')').split(' ');
            Affine::new(numbers.map(|number| number.parse().unwrap()).collect::<Vec<f64>>().try_into().unwrap())
        });
        let whole = transforms.fold(Affine::IDENTITY, |whole, outer| outer * whole);
        to_pixels * whole * BezPath::from_svg(node.attribute("d").unwrap()).unwrap()
    };
    drawn.map(of_path).collect()
}

fn polyline(segments: impl Iterator<Item = PathSeg>, step: f64, place: impl Fn(Point) -> Point) -> Vec<Line> {
    let pieces = |segment: PathSeg| {
        let count = (segment.arclen(0.1) / step).ceil().max(LEAST) as usize;
        (0..=count).map(move |k| segment.eval(k as f64 / count as f64)).map(&place).collect::<Vec<_>>()
    };
    segments.flat_map(|segment| pieces(segment).windows(2).map(|p| Line::new(p[0], p[1])).collect::<Vec<_>>()).collect()
}

fn around(run: &[Line]) -> Rect {
    run.iter().map(|line| Rect::from_points(line.p0, line.p1)).reduce(|one, other| one.union(other)).unwrap()
}

fn squared_distance(p: Point, frame: Rect) -> f64 {
    p.distance_squared(Point::new(p.x.clamp(frame.x0, frame.x1), p.y.clamp(frame.y0, frame.y1)))
}

/// The Hausdorff distance between a bent path and the map of the path at rest.
fn hausdorff(rest: &BezPath, bent: &BezPath, map: &ContinuedMap<'_>) -> f64 {
    let place = |p: Point| {
        let place = map.place(DVec2::new(p.x, p.y));
        Point::new(place.x, place.y)
    };
    let lines = [polyline(rest.segments(), STEP, place), polyline(bent.segments(), STEP, |p| p)];
    let farthest = |from: &[Line], to: &[Line]| {
        let boxes: Vec<Rect> = to.chunks(RUN).map(around).collect();
        let runs: Vec<&[Line]> = to.chunks(RUN).collect();
        let in_run = |p: Point, run: &[Line]| {
            run.iter().map(|line| line.nearest(p, 1e-6).distance_sq).fold(f64::INFINITY, f64::min)
        };
        let nearest = |(at, line): (usize, &Line)| {
            // Most boxes are farther than a line at the same fraction of the path.
            let first = in_run(line.p0, runs[at * runs.len() / from.len()]);
            runs.iter().zip(&boxes).fold(first, |nearest, (run, frame)| {
                if squared_distance(line.p0, *frame) >= nearest { nearest } else { nearest.min(in_run(line.p0, run)) }
            })
        };
        from.iter().enumerate().map(nearest).fold(0.0, f64::max).sqrt()
    };
    farthest(&lines[0], &lines[1]).max(farthest(&lines[1], &lines[0]))
}

/// SVG files of an icon set.
fn icons(set: &str) -> Vec<(String, String)> {
    let path = format!("{}/../node_modules/@iconify-json/{set}/icons.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|reason| panic!("{path}: {reason}: run npm ci"));
    let file: Value = serde_json::from_str(&text).unwrap();
    let side = file["width"].as_f64().unwrap_or(16.0);
    let icons = file["icons"].as_object().unwrap().iter().take(ICONS);
    let svg = |(name, icon): (&String, &Value)| {
        let body = icon["body"].as_str().unwrap();
        (name.clone(), format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {side} {side}">{body}</svg>"#))
    };
    icons.map(svg).collect()
}

#[test]
fn public_icons_bend_within_a_tenth_of_a_pixel() {
    let (project, solution) = bending_solution();
    let pose = solution.pose(&project).unwrap();
    let map = solution.continued(&pose);
    let (mut nodes, mut count) = ([0; 2], 0);
    for (name, svg) in ["feather", "flat-color-icons"].into_iter().flat_map(icons) {
        let drawing = Drawing::read(&svg).unwrap();
        assert!(drawing.remarks().is_empty(), "{name}: {:?}", drawing.remarks());
        let bent = drawing.bent(&map, (SIDE, SIDE), BentOptions::default()).unwrap();
        let [before, after] = [drawing.plain_svg(), &bent.svg].map(|svg| paths(svg, drawing.size()));
        assert!(!before.is_empty() && before.len() == after.len(), "{name}");
        for (rest, bent) in before.iter().zip(&after) {
            let apart = hausdorff(rest, bent, &map);
            assert!(apart <= 0.1, "{name}: {apart} px");
        }
        nodes = [0, 1].map(|side| nodes[side] + bent.nodes[side]);
        count += 1;
    }
    assert!(count >= 200 && nodes[1] <= 2 * nodes[0], "{nodes:?}");
}

#[test]
fn all_parts_of_a_drawing_stay_and_bend_together() {
    let (project, solution) = bending_solution();
    let pose = solution.pose(&project).unwrap();
    let map = solution.continued(&pose);
    let drawing = Drawing::read(FEATURES).unwrap();
    let bent = drawing.bent(&map, (SIDE, SIDE), BentOptions::default()).unwrap().svg;
    for (rest, bent) in paths(drawing.plain_svg(), drawing.size()).iter().zip(&paths(&bent, drawing.size())) {
        assert!(hausdorff(rest, bent, &map) <= 0.1);
    }
    let count = |svg: &str, tag: &str| svg.matches(&format!("<{tag} ")).count();
    for tag in ["linearGradient", "radialGradient", "pattern", "clipPath", "mask", "filter", "g"] {
        let [before, after] = [drawing.plain_svg(), &bent].map(|svg| count(svg, tag));
        assert!(after >= before && before > 0, "{tag}: {before}, {after}");
    }
    for kept in
        ["mix-blend-mode:multiply", "stroke-dasharray", "fill-rule=\"evenodd\"", "opacity=\"0.8\"", "id=\"house\""]
    {
        assert!(bent.contains(kept), "{kept}");
    }
    // The result can be read, and every reference in it leads somewhere.
    let document = Document::parse(&bent).unwrap();
    for id in bent.split("url(#").skip(1).map(|rest| rest.split(')').next().unwrap()) {
        assert!(document.descendants().any(|node| node.attribute("id") == Some(id)), "{id}");
    }
    assert!(Drawing::read(&bent).unwrap().remarks().is_empty());
}

#[test]
fn drawings_at_rest_keep_their_paths() {
    let (mut project, solution) = bending_solution();
    for handle in &mut project.handles {
        *handle = Handle::point(handle.id.clone(), handle.shape.rest()[0]);
    }
    let pose = solution.pose(&project).unwrap();
    let drawing = Drawing::read(FEATURES).unwrap();
    let bent = drawing.bent(&solution.continued(&pose), (SIDE, SIDE), BentOptions::default()).unwrap();
    assert_eq!(bent.nodes[0], bent.nodes[1]);
    let path = |svg: &str| {
        svg.split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let [mut before, mut after] = [drawing.plain_svg(), &bent.svg].map(path);
    before.sort();
    after.sort();
    assert_eq!(before, after);
}

fn svg(content: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">{content}</svg>"#)
}

#[test]
fn missing_parts_and_excessive_sizes_are_reported() {
    let remarks = |content: &str| -> Vec<String> {
        Drawing::read(&svg(content)).unwrap().remarks().iter().map(ToString::to_string).collect()
    };
    let content = r#"<script>alert(1)</script><g onclick="a()"/><animate/><foreignObject/><text>Hello  there</text>
        <image href="file:///etc/passwd" width="1" height="1"/><use href="other.svg#a"/>"#;
    let told = remarks(content).join("; ");
    for part in ["scripts", "animations", "not SVG", "“Hello there”", "file:///etc/passwd", "other.svg#a"] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let plain = Drawing::read(&svg(content)).unwrap();
    assert!(!["alert", "passwd", "other"].iter().any(|part| plain.plain_svg().contains(part)));

    let refused = |text: &str| Drawing::read(text).unwrap_err();
    assert!(matches!(refused("<svg"), VectorError::Xml(_)));
    assert!(matches!(refused("<html/>"), VectorError::Root(_)));
    assert!(matches!(refused(&svg(&"<g/>".repeat(1_000_000))), VectorError::TooManyElements { .. }));
    assert!(matches!(refused(&svg(&("<g>".repeat(5000) + &"</g>".repeat(5000)))), VectorError::TooDeep { .. }));
    // Each element uses the one before twice, or once.
    let doubling = |at: usize| format!(r##"<g id="a{}"><use href="#a{at}"/><use href="#a{at}"/></g>"##, at + 1);
    let bomb: String = (0..40).map(doubling).collect();
    assert!(matches!(refused(&svg(&bomb)), VectorError::TooManyElements { .. }));
    let chain: String = (0..5000).map(|at| format!(r##"<use id="a{}" href="#a{at}"/>"##, at + 1)).collect();
    assert!(matches!(refused(&svg(&chain)), VectorError::TooDeep { .. }));
    let laughs = (1..9).map(|at| format!("<!ENTITY l{at} \"{}\">", format!("&l{};", at - 1).repeat(10)));
    let laughs = format!("<!DOCTYPE svg [<!ENTITY l0 \"<g/>\">{}]>{}", laughs.collect::<String>(), svg("&l8;"));
    assert!(Drawing::read(&laughs).is_err());

    let (project, solution) = bending_solution();
    let pose = solution.pose(&project).unwrap();
    let many = svg(&format!("<path d=\"M0 0{}\"/>", "h1h-1".repeat(500_000)));
    let bent = Drawing::read(&many).unwrap().bent(&solution.continued(&pose), (SIDE, SIDE), BentOptions::default());
    assert!(matches!(bent, Err(VectorError::TooManyNodes { .. })));
}

#[test]
fn command_bends_a_drawing_and_warps_it_as_a_picture() {
    let folder = SceneFolder::new("strip");
    let project = serde_json::to_value(bending_project()).unwrap();
    let folder = folder.edited(|file| {
        *file = project;
        file["image"] = serde_json::json!({ "src": "house.svg", "width": 480, "height": 480 });
    });
    folder.write("house.svg", FEATURES);
    succeed(folder.path(), "warp house.svg --project scene.c2warp.json -o bent.svg");
    succeed(folder.path(), "warp scene.c2warp.json --image house.svg -o again.svg");
    let bent = std::fs::read_to_string(folder.file("bent.svg")).unwrap();
    assert_eq!(bent, std::fs::read_to_string(folder.file("again.svg")).unwrap());
    // Rendered, the bent drawing is the warped picture. Gradients, patterns and shadows differ a little.
    succeed(folder.path(), "warp scene.c2warp.json -o warped.png");
    let image = serde_json::json!({ "src": "bent.svg", "width": SIDE, "height": SIDE });
    let still = serde_json::json!({ "format": "c2warp/1", "handles": [], "image": image });
    folder.write("still.c2warp.json", still.to_string());
    succeed(folder.path(), "warp still.c2warp.json -o bent.png");
    let [warped, rendered] = ["warped.png", "bent.png"].map(|name| folder.picture(name));
    let inside = |at: u32| (100..380).contains(&at);
    let differing = warped.enumerate_pixels().filter(|&(x, y, pixel)| {
        let other = rendered.get_pixel(x, y);
        inside(x) && inside(y) && pixel.0.iter().zip(other.0).any(|(&one, other)| one.abs_diff(other) > 48)
    });
    let share = differing.count() as f64 / 280.0_f64.powi(2);
    assert!(share < 0.04, "{share}");

    let grown = succeed(folder.path(), "warp scene.c2warp.json --grow -o grown.svg");
    assert!(String::from_utf8(grown).unwrap().trim().split(',').all(|number| number.parse::<f64>().is_ok()));
    assert!(fail(folder.path(), "warp scene.c2warp.json --pixelated -o bent.svg").contains("--pixelated"));
    folder.write("broken.svg", "<svg><g></svg>");
    assert!(
        fail(folder.path(), "warp scene.c2warp.json --image broken.svg -o bent.svg")
            .contains("broken.svg: this is not a drawing")
    );
    let of_pixels = SceneFolder::new("strip");
    assert!(fail(of_pixels.path(), "warp scene.c2warp.json -o out.svg").contains("only a drawing"));
    // A font that no system has: the text is drawn in another one, or left out. Both are told.
    let text = r#"<path d="M0 0h9v9H0z" fill="red"/><text y="8" font-family="No Such Font">Hi</text>"#;
    folder.write("text.svg", svg(text));
    let told = command(folder.path(), "warp scene.c2warp.json --image text.svg -o bent.svg").output().unwrap();
    let told = String::from_utf8(told.stderr).unwrap();
    assert!(told.contains("No Such Font") || told.contains("“Hi”"), "{told}");
}
