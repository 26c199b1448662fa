//! Tests of `c2warp map` with points in JSON.

use serde_json::{Value, json};

use crate::command::{fail, succeed};
use crate::scene_folder::SceneFolder;

#[test]
fn shapes_and_landmarks_keep_their_format() {
    let folder = SceneFolder::new("strip");
    folder.write("points.csv", "x,y\n40,20\n");
    succeed(folder.path(), "map scene.c2warp.json --at points.csv -o map.csv");
    let table = std::fs::read_to_string(folder.file("map.csv")).unwrap();
    let row: Vec<f64> = table.lines().nth(1).unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let ring = json!([[40, 20], [50, 20], [40, 30], [40, 20]]);
    let geometry = json!({ "type": "Polygon", "coordinates": [ring] });
    let area = json!({ "type": "Feature", "properties": { "name": "a" }, "geometry": geometry });
    folder.write("area.geojson", area.to_string());
    succeed(folder.path(), "map scene.c2warp.json --at area.geojson -o out.geojson");
    let area: Value = serde_json::from_slice(&std::fs::read(folder.file("out.geojson")).unwrap()).unwrap();
    assert_eq!(area["properties"]["name"], "a");
    assert_eq!(area["geometry"]["coordinates"][0][0], json!([row[2], row[3]]));
    assert_eq!(area["geometry"]["coordinates"][0][0], area["geometry"]["coordinates"][0][3]);
    folder.write("marks.json", r#"{"points":{"eye":[40,20]}}"#);
    succeed(folder.path(), "map scene.c2warp.json --at marks.json -o moved.json");
    succeed(folder.path(), "map scene.c2warp.json --at moved.json --inverse -o back.json");
    let back: Value = serde_json::from_slice(&std::fs::read(folder.file("back.json")).unwrap()).unwrap();
    assert!((back["points"]["eye"][0].as_f64().unwrap() - 40.0).abs() < 0.5);
    assert!(fail(folder.path(), "map scene.c2warp.json --at scene.c2warp.json -o out.json").contains("GeoJSON"));
}
