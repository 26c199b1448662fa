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

const SVG: &str = "http://www.w3.org/2000/svg";
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
    let reported = remarks(content).join("; ");
    for part in ["scripts", "animations", "not SVG", "“Hello there”", "file:///etc/passwd", "other.svg#a"] {
        assert!(reported.contains(part), "{part}: {reported}");
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
    // This font is installed nowhere. Its text is drawn in another font, or left out; both are reported.
    let text = r#"<path d="M0 0h9v9H0z" fill="red"/><text y="8" font-family="No Such Font">Hi</text>"#;
    folder.write("text.svg", svg(text));
    let reported = command(folder.path(), "warp scene.c2warp.json --image text.svg -o bent.svg").output().unwrap();
    let reported = String::from_utf8(reported.stderr).unwrap();
    assert!(reported.contains("No Such Font") || reported.contains("“Hi”"), "{reported}");
}

/// The fills and strokes of the paths of a drawing.
fn paints(drawing: &Drawing) -> Vec<[String; 2]> {
    let document = Document::parse(drawing.plain_svg()).unwrap();
    let is_clip = |node: &usvg::roxmltree::Node<'_, '_>| node.parent_element().unwrap().has_tag_name((SVG, "clipPath"));
    let paths = document.descendants().filter(|node| node.has_tag_name((SVG, "path")) && !is_clip(node));
    let paint = |node: usvg::roxmltree::Node<'_, '_>, name| {
        let opacity =
            node.attribute(&*format!("{name}-opacity")).map_or(String::new(), |opacity| format!(" {opacity}"));
        node.attribute(name).unwrap_or("black").to_owned() + &opacity
    };
    paths.map(|path| ["fill", "stroke"].map(|name| paint(path, name))).collect()
}

#[test]
fn styles_are_resolved_as_in_browsers() {
    let fills = |style: &str, content: &str| -> Vec<String> {
        let drawing = Drawing::read(&svg(&format!("<style>{style}</style>{content}"))).unwrap();
        assert_eq!(drawing.remarks(), [], "{style}");
        paints(&drawing).into_iter().map(|[fill, _]| fill).collect()
    };
    let path = |attributes: &str| format!(r#"<path d="M0 0h9v9z" {attributes}/>"#);
    let one = |style: &str, attributes: &str| fills(style, &path(attributes)).join(" ");
    // Custom properties, from the root, an element, a rule and a fallback.
    assert_eq!(one(":root{--skin:#e8b080} path{fill:var(--skin)}", ""), "#e8b080");
    assert_eq!(one("", r##"style="--a:blue;fill:var(--a)""##), "#0000ff");
    assert_eq!(one("", r#"fill="var(--none, rgb(1 2 3))""#), "#010203");
    assert_eq!(one("svg{color:rgb(9 9 9)}", r#"fill="color-mix(in srgb, currentColor, white)""#), "#848484");
    // Conditions.
    assert_eq!(one("@media screen{path{fill:red}} @media print{path{fill:blue}}", ""), "#ff0000");
    // Colours.
    assert_eq!(one("path{fill:rgb(20 90 200 / 80%)}", ""), "#145ac8 0.8");
    assert_eq!(one("path{fill:COLOR-MIX(in srgb, Red, Blue)}", ""), "#800080");
    assert_eq!(one("path{fill:hsl(280deg 60% 50%)}", r#"fill="red""#), "#9933cc");
    assert_eq!(one("svg{color:lime}", r#"fill="currentcolor""#), "#00ff00");
    // The cascade: an attribute, rules by specificity, a style, and `!important`.
    assert_eq!(one("#a{fill:red} .b{fill:lime} path{fill:blue}", r#"id="a" class="b" fill="white""#), "#ff0000");
    assert_eq!(one(".b{fill:lime!important}", r#"class="b" style="fill:red""#), "#00ff00");
    assert_eq!(one("path{fill:red;fill:unset}", r#"fill="blue""#), "#000000");
    // Selectors.
    let three = format!("<g>{}{}</g>{}", path(r#"class="x""#), path(""), path(r#"data-y="abc""#));
    assert_eq!(fills("g>path:nth-child(2){fill:red}", &three), ["#000000", "#ff0000", "#000000"]);
    assert_eq!(fills("path:hover, g path{fill:red}", &three), ["#ff0000", "#ff0000", "#000000"]);
    assert_eq!(fills("path:not(.x):is(g *, [data-y^=a]){fill:red}", &three), ["#000000", "#ff0000", "#ff0000"]);
    assert_eq!(fills(".x~path, svg>path:last-of-type{fill:red}", &three), ["#000000", "#ff0000", "#ff0000"]);
    // Used elements inherit from their `<use>`.
    let used = r##"<symbol id="s"><path d="M0 0h9v9z" fill="var(--c, lime)"/></symbol>
        <use href="#s" style="--c:red"/><use href="#s"/><g style="--c:blue"><use href="#s"/><use href="#s"/></g>"##;
    assert_eq!(fills("", used), ["#ff0000", "#00ff00", "#0000ff", "#0000ff"]);
    // Transforms and sizes of CSS.
    let moved = Drawing::read(&svg(r#"<circle style="r:2px;cx:4px;transform:translate(1px,2px) rotate(90deg)"/>"#));
    assert!(moved.unwrap().plain_svg().contains(r#"transform="matrix(0 1 -1 0 1 2)""#));
}

#[test]
fn styles_that_are_left_out_are_reported() {
    let reported = |content: &str| {
        let drawing = Drawing::read(&svg(content)).unwrap();
        drawing.remarks().iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    let path = |attributes: &str| reported(&format!(r#"<path d="M0 0h9v9z" {attributes}/>"#));
    for (attributes, named) in [
        (r#"vector-effect="non-scaling-stroke""#, "vector-effect"),
        (r#"style="transform-box:fill-box""#, "transform-box"),
        (r#"fill="light-dark(red, blue)""#, "fill: the value “light-dark(red, blue)”"),
        (r#"fill="var(--none)""#, "fill: the value “var(--none)”"),
        (r#"fill="rgb(from red r g b)""#, "rgb(from red r g b)"),
        (r#"stroke-width="calc(1px + 2px)""#, "stroke-width"),
        (r#"style="clip-path:circle(40%)""#, "clip-path"),
        (r#"style="filter:glow(3px)""#, "filter"),
        (r#"style="mask:linear-gradient(red,blue)""#, "mask"),
        (r#"style="animation:spin 2s""#, "animations"),
        (r#"pathLength="1" stroke-dasharray="1""#, "pathLength"),
    ] {
        let reported = path(attributes);
        assert!(reported.contains(named), "{attributes}: {reported}");
    }
    for (style, named) in [
        ("@media (prefers-color-scheme: dark){path{fill:red}}", "@media (prefers-color-scheme: dark)"),
        ("@layer a{path{fill:red}}", "@layer a"),
        ("@supports (fill: red){path{fill:red}}", "@supports (fill: red)"),
        ("path:glow{fill:red}", "path:glow"),
        ("g{path{fill:red}}", "“path”"),
        ("@keyframes a{from{fill:red}}", "animations"),
        ("@import 'a.css';", "@import"),
    ] {
        let reported = reported(&format!("<style>{style}</style>"));
        assert!(reported.contains(named), "{style}: {reported}");
    }
    // Styles that change nothing in a still picture.
    let plain = "<style>@media print{path{fill:red}} @page{margin:0} path::before{color:red} path{cursor:pointer;
        -inkscape-stroke:none;vector-effect:none;font-variation-settings:normal}</style>";
    assert_eq!(reported(plain), "");
    // An unknown value does not replace the one before.
    let drawing = Drawing::read(&svg(r#"<path d="M0 0h9v9z" fill="red" style="fill:light-dark(lime, blue)"/>"#));
    assert_eq!(paints(&drawing.unwrap())[0][0], "#ff0000");
    let drawing = Drawing::read(&svg(r#"<g fill="red"><path d="M0 0h9v9z" fill="light-dark(lime, blue)"/></g>"#));
    assert_eq!(paints(&drawing.unwrap())[0][0], "#ff0000");
}

#[test]
fn drawings_in_pictures_follow_the_same_rules() {
    let inner = svg(r#"<style>path{fill:oklch(70% .2 60)}</style><path d="M0 0h9v9z" vector-effect="fixed"/>"#);
    let address = |svg: &str| format!("data:image/svg+xml,{}", svg.replace('%', "%25").replace('#', "%23"));
    let outer = |svg: &str| {
        let address = address(svg).replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        format!(r#"<image width="9" height="9" href="{address}"/>"#)
    };
    let drawing = Drawing::read(&svg(&outer(&inner))).unwrap();
    let reported: Vec<String> = drawing.remarks().iter().map(ToString::to_string).collect();
    assert!(reported.iter().any(|reported| reported.contains("vector-effect")), "{reported:?}");
    let pixels = drawing.pixels(9, 9).unwrap();
    assert_eq!(pixels[4 * 4..4 * 5], [0xf4, 0x77, 0, 255]);

    let bomb = svg(&(0..40)
        .map(|at| format!(r##"<g id="a{}"><use href="#a{at}"/><use href="#a{at}"/></g>"##, at + 1))
        .collect::<String>());
    assert!(matches!(Drawing::read(&svg(&outer(&bomb))), Err(VectorError::TooManyElements { .. })));
    let broken = Drawing::read(&svg(&outer("<svg"))).unwrap();
    assert!(broken.remarks()[0].to_string().contains("cannot be read"));
}

#[test]
fn slow_drawings_are_rejected_before_drawing() {
    const PX: u32 = 1024;
    let filtered = |parts: &str, attributes: &str| {
        let filter = format!(r##"<filter id="f" {attributes}>{parts}</filter><g filter="url(#f)">"##);
        format!(r#"{filter}<rect width="9" height="9"/></g>"#)
    };
    let cause = |content: &str| match Drawing::read(&svg(content)).and_then(|drawing| drawing.cost(PX, PX)) {
        Err(VectorError::TooSlow { cause } | VectorError::TooMuchMemory { cause }) => cause,
        other => panic!("{other:?}: {}", &content[..content.len().min(200)]),
    };
    let groups = |count: usize, content: &str| {
        format!("{}{content}{}", r#"<g opacity=".9">"#.repeat(count), "</g>".repeat(count))
    };
    let rectangle = r#"<rect width="9" height="9"/>"#;
    let blurred = format!(
        r##"<filter id="f"><feGaussianBlur stdDeviation="1"/></filter>{}"##,
        r##"<path d="M0 0h9v9" filter="url(#f)"/>"##.repeat(5000)
    );
    let pattern = |at: usize, of: &str| {
        format!(
            r##"<pattern id="p{at}" width="9" height="9" patternUnits="userSpaceOnUse">{}</pattern>"##,
            format!(r#"<rect width="9" height="9" fill="{of}"/>"#).repeat(30)
        )
    };
    for (content, expected) in [
        (filtered(r#"<feGaussianBlur stdDeviation="1e9"/>"#, ""), "feGaussianBlur"),
        (filtered(r#"<feMorphology radius="3"/>"#, ""), "feMorphology"),
        (
            filtered(&format!(r#"<feConvolveMatrix order="99" kernelMatrix="{}"/>"#, "1 ".repeat(99 * 99)), ""),
            "feConvolveMatrix",
        ),
        (filtered(&r#"<feGaussianBlur stdDeviation="1"/>"#.repeat(1000), ""), "feGaussianBlur"),
        (filtered(&r#"<feFlood/>"#.repeat(100), r#"x="-9" y="-9" width="99" height="99""#), "feFlood"),
        (filtered(r#"<feTurbulence numOctaves="1000" baseFrequency="1"/>"#, ""), "feTurbulence"),
        (blurred, "feGaussianBlur"),
        (groups(190, &rectangle.repeat(2)) + &groups(190, rectangle).repeat(30), "g"),
        (
            format!("{}{}{}", pattern(0, "red"), pattern(1, "url(#p0)"), pattern(2, "url(#p1)"))
                + r##"<path d="M0 0h9v9" fill="url(#p2)"/>"##,
            "path",
        ),
        (
            format!(
                r##"<pattern id="p" width="1e5" height="1e5" patternUnits="userSpaceOnUse">{rectangle}</pattern><path d="M0 0h9v9" fill="url(#p)"/>"##
            ),
            "pattern",
        ),
        (
            format!(
                r##"<mask id="m">{rectangle}</mask>{}"##,
                format!(r##"<g mask="url(#m)">{rectangle}</g>"##).repeat(2000)
            ),
            "mask",
        ),
        (format!(r#"<path d="M0 0{}"/>"#, "h9v9h-9v-9".repeat(400_000)), "path"),
        (rectangle.repeat(60_000), "path"),
    ] {
        assert_eq!(cause(&content), expected, "{}", &content[..content.len().min(200)]);
    }

    // These cost little, in spite of their numbers.
    let table = format!(
        r#"<feComponentTransfer><feFuncR type="table" tableValues="{}"/></feComponentTransfer>"#,
        "0 1 ".repeat(100_000)
    );
    let region = filtered(r#"<feOffset dx="1"/>"#, r#"x="-1e9" y="-1e9" width="2e9" height="2e9""#);
    let tiles = r##"<pattern id="p" width="1e-3" height="1e-3" patternUnits="userSpaceOnUse"><path d="M0 0h1v1"/></pattern>
        <path d="M0 0h9v9" fill="url(#p)"/>"##;
    let dashes = r#"<path d="M0 0h9v9" stroke="red" stroke-dasharray="1e-6"/>"#;
    for content in [&filtered(&table, ""), &region, tiles, dashes] {
        let cost = Drawing::read(&svg(content)).unwrap().cost(PX, PX).unwrap();
        assert!(cost.time < 5e9, "{cost:?}: {}", &content[..content.len().min(200)]);
    }
}

#[test]
fn drawings_that_grow_when_read_are_rejected() {
    let refused = |text: &str| Drawing::read(text).unwrap_err();
    // The marker of a group is drawn at every node in it, and its pattern for each shape.
    let markers = format!(
        r##"<marker id="m">{}</marker><g marker-mid="url(#m)"><path d="M0 0{}"/></g>"##,
        "<g/>".repeat(100),
        "h1".repeat(5000)
    );
    assert!(matches!(refused(&svg(&markers)), VectorError::TooManyElements { .. }));
    let by_style = markers.replace("<g marker-mid=\"url(#m)\">", "<style>g{marker:url(#m)}</style><g>");
    assert!(matches!(refused(&svg(&by_style)), VectorError::TooManyElements { .. }));
    let patterns = format!(
        r##"<pattern id="p">{}</pattern><g fill="url(#p)">{}</g>"##,
        "<g/>".repeat(1000),
        "<path/>".repeat(1000)
    );
    assert!(matches!(refused(&svg(&patterns)), VectorError::TooManyElements { .. }));
    let copies =
        format!(r##"<path id="p" d="M0 0{}"/>{}"##, "h1".repeat(300_000), r##"<use href="#p"/>"##.repeat(1000));
    assert!(matches!(refused(&svg(&copies)), VectorError::TooManyCopies));
    let loops = (0..5000).map(|at| format!(r##"<pattern id="p{at}"><path fill="url(#p{at})"/></pattern>"##));
    assert!(matches!(refused(&svg(&loops.collect::<String>())), VectorError::TooManyElements { .. }));
    let attributes: String = (0..5000).map(|at| format!(" a{at}=''")).collect();
    assert!(matches!(refused(&svg(&format!("<g{attributes}/>"))), VectorError::TooManyAttributes { .. }));
    let siblings = format!("<style>{}</style>{}", "g~path{fill:red}".repeat(20), "<path/>".repeat(50_000));
    assert!(matches!(refused(&svg(&siblings)), VectorError::TooManyStyles));
}

#[test]
fn encoded_and_compressed_drawings_are_opened() {
    let folder = SceneFolder::new("strip");
    let named = |declaration: &str| {
        format!(
            r#"{declaration}<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><g id="Größe"><path d="M0 0h9v9z"/></g></svg>"#
        )
    };
    let latin = |text: String| text.chars().map(|character| character as u8).collect::<Vec<u8>>();
    let utf16 = |text: String| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let packed = |text: &[u8]| {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        std::io::Write::write_all(&mut encoder, text).unwrap();
        encoder.finish().unwrap()
    };
    let drawing = named("");
    for (name, bytes) in [
        ("latin1.svg", latin(named(r#"<?xml version="1.0" encoding="ISO-8859-1"?>"#))),
        ("marked.svg", utf16(format!("\u{feff}{drawing}"))),
        ("unmarked.svg", utf16(named(r#"<?xml version="1.0" encoding="UTF-16"?>"#))),
        ("packed.svgz", packed(drawing.as_bytes())),
        ("packed-latin1.svg", packed(&latin(named(r#"<?xml version="1.0" encoding="latin1"?>"#)))),
    ] {
        folder.write(name, bytes);
        succeed(folder.path(), &format!("new {name} --handles 700,300 -o {name}.json --force"));
        succeed(folder.path(), &format!("warp {name}.json --image {name} -o bent.svg"));
        assert!(std::fs::read_to_string(folder.file("bent.svg")).unwrap().contains("Größe"), "{name}");
    }
    for (name, bytes, reported) in [
        ("wrong.svg", latin(drawing.clone()), "not UTF-8 text"),
        ("klingon.svg", named(r#"<?xml version="1.0" encoding="Klingon"?>"#).into(), "unknown encoding \"Klingon\""),
        ("text.gz", packed(b"once upon a time"), "this is a compressed file"),
        ("cut.svgz", packed(&[drawing.as_bytes(), &b" ".repeat(1000)].concat())[..60].into(), "unpacked"),
        ("bomb.svgz", packed(&[b"<svg".to_vec(), vec![b' '; 65 << 20]].concat()), "more than 64 MB"),
    ] {
        folder.write(name, bytes);
        let words = fail(folder.path(), &format!("new {name} --handles 700,300 -o x.json"));
        assert!(words.contains(reported), "{name}: {words}");
    }
}

#[test]
fn commands_report_left_out_styles_and_reject_slow_drawings() {
    let folder = SceneFolder::new("strip");
    folder.write("lossy.svg", svg(r#"<path d="M0 0h9v9" fill="light-dark(red, blue)" vector-effect="fixed"/>"#));
    for line in [
        "new lossy.svg --handles 700,300 -o lossy.json",
        "check lossy.json --image lossy.svg",
        "warp lossy.json --image lossy.svg -o bent.svg",
    ] {
        let reported = command(folder.path(), line).output().unwrap();
        let reported = String::from_utf8(reported.stderr).unwrap();
        assert!(reported.contains("vector-effect") && reported.contains("light-dark(red, blue)"), "{line}: {reported}");
    }
    let slow = r##"<filter id="f"><feMorphology radius="4"/></filter><path d="M0 0h9v9" filter="url(#f)"/>"##;
    folder.write("slow.svg", svg(slow));
    assert!(fail(folder.path(), "new slow.svg --handles 700,300 -o slow.json").contains("<feMorphology>"));
}
