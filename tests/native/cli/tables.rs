//! `c2warp weights`, `map` and `distance`: tables over points.

use std::collections::BTreeMap;

use csv::StringRecord;
use glam::DVec2;

use crate::command::succeed;
use crate::workplace::Workplace;

/// Runs a subcommand over points; its header and rows.
pub(crate) fn table(place: &Workplace, subcommand: &str, points: &[[f64; 2]]) -> (String, Vec<StringRecord>) {
    let lines: String = points.iter().map(|[x, y]| format!("{x},{y}\n")).collect();
    place.write("points.csv", format!("x,y\n{lines}"));
    let (name, options) = subcommand.split_once(' ').unwrap_or((subcommand, ""));
    let printed = succeed(place.folder(), &format!("{name} scene.c2warp.json {options} --at points.csv -o out.csv"));
    assert!(printed.is_empty());
    let mut reader = csv::Reader::from_path(place.file("out.csv")).unwrap();
    let header = reader.headers().unwrap().iter().collect::<Vec<_>>().join(",");
    (header, reader.records().map(Result::unwrap).collect())
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

fn rows<const N: usize>(rows: &[StringRecord]) -> Vec<[f64; N]> {
    rows.iter().map(|row| std::array::from_fn(|i| number(&row[i]))).collect()
}

/// Points all over the strip, its rim and corners included.
fn strip_points() -> Vec<[f64; 2]> {
    (0..=48).map(|i| [f64::from(i) * 2.0, f64::from(i * 29 % 49)]).collect()
}

#[test]
fn weights_sum_to_one_and_none_is_zero_or_less() {
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
        let place = Workplace::with(scene);
        let (header, rows) = table(&place, "weights", &points);
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
fn a_handle_has_all_the_weight_at_its_own_place() {
    let place = Workplace::with("strip");
    let (_, rows) = table(&place, "weights", &[[48.0, 24.0]]);
    let cells: Vec<Vec<_>> = rows.iter().map(|row| row.iter().collect()).collect();
    assert_eq!(cells.len(), 1);
    assert_eq!((cells[0][0], &cells[0][2..]), ("0", &["real", "middle", "48", "24", "1"][..]));
}

#[test]
fn a_point_outside_has_no_weights() {
    let place = Workplace::with("ring");
    let (_, rows) = table(&place, "weights", &[[64.0, 64.0], [108.0, 64.0], [-5.0, 1e9], [1e300, -1e300]]);
    assert!(!rows.is_empty() && rows.iter().all(|row| &row[0] == "1"));
}

#[test]
fn the_map_of_a_scene_at_rest_is_the_identity() {
    for (scene, points) in [
        ("strip", [[20.0, 24.0], [33.3, 40.125], [84.0, 20.5]]),
        ("ring", [[20.0, 64.0], [33.3, 90.125], [64.0, 20.5]]),
    ] {
        let place = Workplace::with(scene).at_rest();
        let (header, cells) = table(&place, "map", &points);
        assert_eq!(header, "x,y,posed_x,posed_y,det");
        for [x, y, posed_x, posed_y, det] in rows(&cells) {
            assert!((posed_x - x).abs() < 1e-9 && (posed_y - y).abs() < 1e-9 && (det - 1.0).abs() < 1e-6, "{x}, {y}");
        }
    }
}

#[test]
fn the_map_takes_a_handle_where_it_was_taken() {
    let place = Workplace::with("strip");
    let (_, cells) = table(&place, "map", &[[12.0, 24.0], [48.0, 24.0], [84.0, 24.0]]);
    let posed: Vec<_> = rows::<5>(&cells).iter().map(|row| DVec2::new(row[2], row[3])).collect();
    for (found, expected) in posed.iter().zip([[12.0, 24.0], [50.0, 18.0], [82.0, 30.0]]) {
        assert!(found.distance(expected.into()) < 1e-9, "{found}");
    }
    // The handle `right` grows its surroundings by 1.1 in each direction.
    assert!((number(&cells[2][4]) - 1.21).abs() < 1e-3, "{}", &cells[2][4]);
}

#[test]
fn the_inverse_map_leads_back_to_where_points_rest() {
    let place = Workplace::with("strip");
    let (_, cells) = table(&place, "map", &[[12.0, 24.0], [30.0, 20.0], [60.5, 30.5]]);
    let posed: Vec<[f64; 2]> = rows::<5>(&cells).iter().map(|row| [row[2], row[3]]).collect();
    let (header, back) = table(&place, "map --inverse", &posed);
    assert_eq!(header, "x,y,rest_x,rest_y");
    for ([.., rest_x, rest_y], [x, y, ..]) in rows::<4>(&back).into_iter().zip(rows::<5>(&cells)) {
        assert!((rest_x - x).hypot(rest_y - y) < 0.05, "{rest_x}, {rest_y}, not {x}, {y}");
    }
    let (_, beside) = table(&place, "map --inverse", &[[-40.0, 24.0], [1e300, -1e300]]);
    assert!(beside.iter().all(|row| row[2].is_empty() && row[3].is_empty()));
}

/// What the picture shows where the inverse map says is what the warped picture shows.
#[test]
fn the_inverse_map_is_that_of_the_warped_picture() {
    let place = Workplace::with("ring");
    succeed(place.folder(), "warp scene.c2warp.json -o out.png");
    let (before, after) = (place.picture("ring.png"), place.picture("out.png"));
    let centres: Vec<[f64; 2]> =
        after.enumerate_pixels().map(|(x, y, _)| [x, y].map(|side| f64::from(side) + 0.5)).collect();
    let (_, cells) = table(&place, "map --inverse", &centres);
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
fn what_rests_on_a_bar_or_polygon_lands_on_it() {
    let place = Workplace::with("portrait");
    let along = |[a, b]: [[f64; 2]; 2], share: f64| <[f64; 2]>::from(DVec2::from(a).lerp(b.into(), share));
    // Pieces of the mouth, the left eye and the shoulders, at rest and posed.
    let pieces = [
        ([[80.0, 165.0], [100.0, 167.0]], [[77.0, 160.0], [100.0, 168.0]]),
        ([[94.0, 110.0], [94.0, 126.0]], [[92.0, 108.0], [92.0, 124.0]]),
        ([[30.0, 236.0], [170.0, 236.0]], [[30.0, 236.0], [170.0, 236.0]]),
    ];
    let shares = [0.0, 0.013, 0.5, 0.777, 1.0];
    let at: Vec<_> = pieces.iter().flat_map(|&(rest, _)| shares.map(|share| along(rest, share))).collect();
    let expected = pieces.iter().flat_map(|&(_, posed)| shares.map(|share| along(posed, share)));
    let (_, cells) = table(&place, "map", &at);
    for (row, expected) in rows::<5>(&cells).iter().zip(expected) {
        assert!(DVec2::new(row[2], row[3]).distance(expected.into()) < 1e-6, "{row:?}, not {expected:?}");
    }
    let (_, cells) = table(&place, "weights", &at);
    let handle = |point: usize| ["mouth", "left-eye", "shoulders"][point / shares.len()];
    assert!(cells.iter().all(|row| &row[2] == "real" && row[3] == *handle(row[0].parse().unwrap())));
}

#[test]
fn a_held_boundary_has_weight_and_no_handle() {
    let place = Workplace::with("tower");
    let (_, cells) = table(&place, "weights", &[[0.0, 50.0]]);
    assert!(!cells.is_empty() && cells.iter().all(|row| (&row[2], &row[3]) == ("real", "")));
    let (_, cells) = table(&place, "map", &[[0.0, 50.0], [31.7, 0.0]]);
    for [x, y, posed_x, posed_y, _] in rows(&cells) {
        assert!((posed_x - x).hypot(posed_y - y) < 1e-9);
    }
}

#[test]
fn the_map_is_empty_outside_and_still_on_an_island_without_handles() {
    let place = Workplace::with("islands");
    let (_, cells) = table(&place, "map", &[[60.0, 32.0], [88.0, 32.0], [30.0, 40.0]]);
    assert_eq!(cells[0], ["60", "32", "", "", ""][..]);
    let [x, y, posed_x, posed_y, det] = rows(&cells[1..])[0];
    assert_eq!([posed_x, posed_y, det], [x, y, 1.0]);
    let [x, y, posed_x, posed_y, det] = rows(&cells[1..])[1];
    assert!((posed_x - x - 5.0).abs() < 1e-12 && (posed_y - y + 3.0).abs() < 1e-12 && (det - 1.0).abs() < 1e-9);
}

#[test]
fn distance_is_the_straight_line_where_nothing_is_between() {
    let place = Workplace::with("strip");
    let points = strip_points();
    let (header, cells) = table(&place, "distance --from 7.5,41", &points);
    assert_eq!(header, "x,y,distance");
    assert_eq!(cells.len(), points.len());
    for [x, y, distance] in rows(&cells) {
        assert!((distance - (x - 7.5).hypot(y - 41.0)).abs() < 1e-9, "{x}, {y}: {distance}");
    }
}

#[test]
fn distance_does_not_ask_whether_handles_can_be_solved() {
    let place = Workplace::with("strip").changed(|project| {
        project["handles"][0]["rest"] = serde_json::json!([-500, -500]);
    });
    let (_, cells) = table(&place, "distance --from 10,20", &[[40.0, 20.0]]);
    assert_eq!(cells[0], vec!["40", "20", "30"]);
}

#[test]
fn distance_leads_around_a_hole() {
    let place = Workplace::with("ring");
    let (_, cells) = table(&place, "distance --from 30,64", &[[98.0, 64.0], [64.0, 64.0]]);
    // Two tangents to the hole of 30 px and the arc between them; its outline is a polygon, inside the circle by less than a pixel.
    let tangent = (34_f64.powi(2) - 30_f64.powi(2)).sqrt();
    let arc = 30.0 * (std::f64::consts::PI - 2.0 * (30.0_f64 / 34.0).acos());
    let distance = number(&cells[0][2]);
    assert!((distance / (2.0 * tangent + arc) - 1.0).abs() < 0.03, "{distance} for {}", 2.0 * tangent + arc);
    assert_eq!(&cells[1][2], "");
}

#[test]
fn no_path_leads_to_another_island() {
    let place = Workplace::with("islands");
    let (_, cells) = table(&place, "distance --from 32,32", &[[88.0, 32.0], [32.0, 40.0]]);
    assert_eq!(&cells[0][2], "");
    assert!((number(&cells[1][2]) - 8.0).abs() < 1e-9);
}

#[test]
fn no_points_give_a_table_without_rows() {
    let place = Workplace::with("strip");
    for subcommand in ["weights", "map", "distance --from 1,1"] {
        assert!(table(&place, subcommand, &[]).1.is_empty(), "{subcommand}");
    }
}

#[test]
fn numbers_come_back_to_the_last_bit() {
    let place = Workplace::with("strip");
    let (x, y) = (0.1 + 0.2, 100.0 / 3.0);
    let (_, cells) = table(&place, "map", &[[x, y]]);
    assert_eq!((number(&cells[0][0]).to_bits(), number(&cells[0][1]).to_bits()), (x.to_bits(), y.to_bits()));
}

#[test]
fn spreadsheets_may_write_the_points() {
    let place = Workplace::with("strip");
    place.write("points.csv", "\u{feff}x , y\r\n 12, 24 \r\n\r\n\"84\",24\r\n");
    succeed(place.folder(), "map scene.c2warp.json --at points.csv -o out.csv");
    assert_eq!(std::fs::read_to_string(place.file("out.csv")).unwrap().lines().count(), 3);
}
