//! Tests of the tables of `c2warp weights`, `map` and `distance`.

use std::collections::BTreeMap;

use csv::StringRecord;
use glam::DVec2;

use crate::command::succeed;
use crate::scene_folder::SceneFolder;

/// Runs a subcommand on points and returns the header and the rows of its table.
pub(crate) fn table(folder: &SceneFolder, subcommand: &str, points: &[[f64; 2]]) -> (String, Vec<StringRecord>) {
    let lines: String = points.iter().map(|[x, y]| format!("{x},{y}\n")).collect();
    folder.write("points.csv", format!("x,y\n{lines}"));
    let (name, options) = subcommand.split_once(' ').unwrap_or((subcommand, ""));
    let printed = succeed(folder.path(), &format!("{name} scene.c2warp.json {options} --at points.csv -o out.csv"));
    assert!(printed.is_empty());
    let mut reader = csv::Reader::from_path(folder.file("out.csv")).unwrap();
    let header = reader.headers().unwrap().iter().collect::<Vec<_>>().join(",");
    (header, reader.records().map(Result::unwrap).collect())
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

fn rows<const N: usize>(rows: &[StringRecord]) -> Vec<[f64; N]> {
    rows.iter().map(|row| std::array::from_fn(|i| number(&row[i]))).collect()
}

/// Points over the whole strip, with its border and corners.
fn strip_points() -> Vec<[f64; 2]> {
    (0..=48).map(|i| [f64::from(i) * 2.0, f64::from(i * 29 % 49)]).collect()
}

#[test]
fn weights_are_positive_and_sum_to_one() {
    for (scene, points) in [
        ("strip", strip_points()),
        (
            "ring",
            (0..40)
                .map(|i| {
                    let angle = f64::from(i) * 0.41;
                    [
                        64.0 + (32.0 + f64::from(i % 6) * 4.0) * angle.cos(),
                        64.0 + (32.0 + f64::from(i % 6) * 4.0) * angle.sin(),
                    ]
                })
                .collect::<Vec<_>>(),
        ),
    ] {
        let folder = SceneFolder::new(scene);
        let (header, rows) = table(&folder, "weights", &points);
        assert_eq!(header, "point,site,kind,handle,site_x,site_y,weight");
        let mut sums = BTreeMap::<usize, f64>::new();
        for row in &rows {
            let weight = number(&row[6]);
            assert!(weight > 0.0 && weight <= 1.0, "{row:?}");
            assert!(
                match &row[2] {
                    "real" => !row[3].is_empty(),
                    kind => kind == "virtual" && row[3].is_empty(),
                },
                "{row:?}"
            );
            *sums.entry(row[0].parse().unwrap()).or_default() += weight;
        }
        assert_eq!(sums.len(), points.len(), "{scene}");
        assert!(sums.values().all(|sum| (sum - 1.0).abs() < 1e-12), "{scene}: {sums:?}");
    }
}

#[test]
fn handle_has_full_weight_at_its_rest_position() {
    let folder = SceneFolder::new("strip");
    let (_, rows) = table(&folder, "weights", &[[48.0, 24.0]]);
    let cells: Vec<Vec<_>> = rows.iter().map(|row| row.iter().collect()).collect();
    assert_eq!(cells.len(), 1);
    assert_eq!((cells[0][0], &cells[0][2..]), ("0", &["real", "middle", "48", "24", "1"][..]));
}

#[test]
fn points_outside_have_no_weights() {
    let folder = SceneFolder::new("ring");
    let (_, rows) = table(&folder, "weights", &[[64.0, 64.0], [108.0, 64.0], [-5.0, 1e9], [1e300, -1e300]]);
    assert!(!rows.is_empty() && rows.iter().all(|row| &row[0] == "1"));
}

#[test]
fn map_at_rest_is_the_identity() {
    for (scene, points) in [
        ("strip", [[20.0, 24.0], [33.3, 40.125], [84.0, 20.5]]),
        ("ring", [[20.0, 64.0], [33.3, 90.125], [64.0, 20.5]]),
    ] {
        let folder = SceneFolder::new(scene).at_rest();
        let (header, cells) = table(&folder, "map", &points);
        assert_eq!(header, "x,y,posed_x,posed_y,det");
        for [x, y, posed_x, posed_y, det] in rows(&cells) {
            assert!((posed_x - x).abs() < 1e-9 && (posed_y - y).abs() < 1e-9 && (det - 1.0).abs() < 1e-6, "{x}, {y}");
        }
    }
}

#[test]
fn map_moves_handles_to_their_posed_positions() {
    let folder = SceneFolder::new("strip");
    let (_, cells) = table(&folder, "map", &[[12.0, 24.0], [48.0, 24.0], [84.0, 24.0]]);
    let posed: Vec<_> = rows::<5>(&cells).iter().map(|row| DVec2::new(row[2], row[3])).collect();
    for (found, expected) in posed.iter().zip([[12.0, 24.0], [50.0, 18.0], [82.0, 30.0]]) {
        assert!(found.distance(expected.into()) < 1e-9, "{found}");
    }
    // The handle `right` has scale 1.1.
    assert!((number(&cells[2][4]) - 1.21).abs() < 1e-3, "{}", &cells[2][4]);
}

#[test]
fn inverse_map_returns_the_rest_positions() {
    let folder = SceneFolder::new("strip");
    let (_, cells) = table(&folder, "map", &[[12.0, 24.0], [30.0, 20.0], [60.5, 30.5]]);
    let posed: Vec<[f64; 2]> = rows::<5>(&cells).iter().map(|row| [row[2], row[3]]).collect();
    let (header, back) = table(&folder, "map --inverse", &posed);
    assert_eq!(header, "x,y,rest_x,rest_y");
    for ([.., rest_x, rest_y], [x, y, ..]) in rows::<4>(&back).into_iter().zip(rows::<5>(&cells)) {
        assert!((rest_x - x).hypot(rest_y - y) < 0.05, "{rest_x}, {rest_y}, not {x}, {y}");
    }
    let (_, outside) = table(&folder, "map --inverse", &[[-40.0, 24.0], [1e300, -1e300]]);
    assert!(outside.iter().all(|row| row[2].is_empty() && row[3].is_empty()));
}

/// The picture must be opaque at the sources of all opaque pixels of the warped picture.
#[test]
fn inverse_map_agrees_with_the_warped_picture() {
    let folder = SceneFolder::new("ring");
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    let (before, after) = (folder.picture("ring.png"), folder.picture("out.png"));
    let centres: Vec<[f64; 2]> =
        after.enumerate_pixels().map(|(x, y, _)| [x, y].map(|side| f64::from(side) + 0.5)).collect();
    let (_, cells) = table(&folder, "map --inverse", &centres);
    let mut compared = 0;
    for (row, warped) in cells.iter().zip(after.pixels()) {
        if row[2].is_empty() {
            assert!(warped[3] < 200, "{row:?}");
        } else if warped[3] == 255 {
            let [x, y] = [2, 3].map(|cell| number(&row[cell]) as u32);
            compared += usize::from(before.get_pixel(x, y)[3] > 128);
        }
    }
    let opaque = after.pixels().filter(|pixel| pixel[3] == 255).count();
    assert!(opaque > 1000 && compared == opaque, "{compared} of {opaque}");
}

#[test]
fn points_on_bars_and_polygons_stay_on_them() {
    let folder = SceneFolder::new("portrait");
    let along = |[a, b]: [[f64; 2]; 2], t: f64| <[f64; 2]>::from(DVec2::from(a).lerp(b.into(), t));
    // Segments of the mouth, the left eye and the shoulders, at rest and posed.
    let segments = [
        ([[80.0, 165.0], [100.0, 167.0]], [[77.0, 160.0], [100.0, 168.0]]),
        ([[94.0, 110.0], [94.0, 126.0]], [[92.0, 108.0], [92.0, 124.0]]),
        ([[30.0, 236.0], [170.0, 236.0]], [[30.0, 236.0], [170.0, 236.0]]),
    ];
    let parameters = [0.0, 0.013, 0.5, 0.777, 1.0];
    let at: Vec<_> = segments.iter().flat_map(|&(rest, _)| parameters.map(|t| along(rest, t))).collect();
    let expected = segments.iter().flat_map(|&(_, posed)| parameters.map(|t| along(posed, t)));
    let (_, cells) = table(&folder, "map", &at);
    for (row, expected) in rows::<5>(&cells).iter().zip(expected) {
        assert!(DVec2::new(row[2], row[3]).distance(expected.into()) < 1e-6, "{row:?}, not {expected:?}");
    }
    let (_, cells) = table(&folder, "weights", &at);
    let handle = |point: usize| ["mouth", "left-eye", "shoulders"][point / parameters.len()];
    assert!(cells.iter().all(|row| &row[2] == "real" && row[3] == *handle(row[0].parse().unwrap())));
}

#[test]
fn held_boundary_has_real_sites_without_handles() {
    let folder = SceneFolder::new("tower");
    let (_, cells) = table(&folder, "weights", &[[0.0, 50.0]]);
    assert!(!cells.is_empty() && cells.iter().all(|row| (&row[2], &row[3]) == ("real", "")));
    let (_, cells) = table(&folder, "map", &[[0.0, 50.0], [31.7, 0.0]]);
    for [x, y, posed_x, posed_y, _] in rows(&cells) {
        assert!((posed_x - x).hypot(posed_y - y) < 1e-9);
    }
}

#[test]
fn map_is_empty_outside_and_identity_on_free_islands() {
    let folder = SceneFolder::new("islands");
    let (_, cells) = table(&folder, "map", &[[60.0, 32.0], [88.0, 32.0], [30.0, 40.0]]);
    assert_eq!(cells[0], ["60", "32", "", "", ""][..]);
    let [x, y, posed_x, posed_y, det] = rows(&cells[1..])[0];
    assert_eq!([posed_x, posed_y, det], [x, y, 1.0]);
    let [x, y, posed_x, posed_y, det] = rows(&cells[1..])[1];
    assert!((posed_x - x - 5.0).abs() < 1e-12 && (posed_y - y + 3.0).abs() < 1e-12 && (det - 1.0).abs() < 1e-9);
}

#[test]
fn distance_in_a_convex_domain_is_euclidean() {
    let folder = SceneFolder::new("strip");
    let points = strip_points();
    let (header, cells) = table(&folder, "distance --from 7.5,41", &points);
    assert_eq!(header, "x,y,distance");
    assert_eq!(cells.len(), points.len());
    for [x, y, distance] in rows(&cells) {
        assert!((distance - (x - 7.5).hypot(y - 41.0)).abs() < 1e-9, "{x}, {y}: {distance}");
    }
}

#[test]
fn distance_ignores_invalid_handles() {
    let folder = SceneFolder::new("strip").edited(|project| {
        project["handles"][0]["rest"] = serde_json::json!([-500, -500]);
    });
    let (_, cells) = table(&folder, "distance --from 10,20", &[[40.0, 20.0]]);
    assert_eq!(cells[0], vec!["40", "20", "30"]);
}

#[test]
fn distance_goes_around_a_hole() {
    let folder = SceneFolder::new("ring");
    let (_, cells) = table(&folder, "distance --from 30,64", &[[98.0, 64.0], [64.0, 64.0]]);
    // Two tangents to the hole of 30 px and the arc between them. The outline is a polygon less than a pixel inside the
    // circle.
    let tangent = (34_f64.powi(2) - 30_f64.powi(2)).sqrt();
    let arc = 30.0 * (std::f64::consts::PI - 2.0 * (30.0_f64 / 34.0).acos());
    let distance = number(&cells[0][2]);
    assert!((distance / (2.0 * tangent + arc) - 1.0).abs() < 0.03, "{distance} for {}", 2.0 * tangent + arc);
    assert_eq!(&cells[1][2], "");
}

#[test]
fn distance_to_another_island_is_empty() {
    let folder = SceneFolder::new("islands");
    let (_, cells) = table(&folder, "distance --from 32,32", &[[88.0, 32.0], [32.0, 40.0]]);
    assert_eq!(&cells[0][2], "");
    assert!((number(&cells[1][2]) - 8.0).abs() < 1e-9);
}

#[test]
fn table_without_points_has_no_rows() {
    let folder = SceneFolder::new("strip");
    for subcommand in ["weights", "map", "distance --from 1,1"] {
        assert!(table(&folder, subcommand, &[]).1.is_empty(), "{subcommand}");
    }
}

#[test]
fn coordinates_keep_every_bit() {
    let folder = SceneFolder::new("strip");
    let (x, y) = (0.1 + 0.2, 100.0 / 3.0);
    let (_, cells) = table(&folder, "map", &[[x, y]]);
    assert_eq!((number(&cells[0][0]).to_bits(), number(&cells[0][1]).to_bits()), (x.to_bits(), y.to_bits()));
}

#[test]
fn points_from_spreadsheets_are_accepted() {
    let folder = SceneFolder::new("strip");
    folder.write("points.csv", "\u{feff}x , y\r\n 12, 24 \r\n\r\n\"84\",24\r\n");
    succeed(folder.path(), "map scene.c2warp.json --at points.csv -o out.csv");
    assert_eq!(std::fs::read_to_string(folder.file("out.csv")).unwrap().lines().count(), 3);
}
