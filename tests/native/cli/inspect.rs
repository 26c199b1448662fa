//! Tests of `c2warp inspect`.

use serde_json::Value;

use crate::command::{succeed, succeed_with_closed_pipe};
use crate::scene_folder::SceneFolder;

fn report(scene: &str) -> Value {
    let printed = succeed(SceneFolder::new(scene).path(), "inspect scene.c2warp.json --json");
    serde_json::from_slice(&printed).unwrap()
}

#[test]
fn json_has_every_documented_key() {
    let report = report("strip");
    for key in [
        "samples",
        "islands",
        "holes",
        "point_handles",
        "bar_handles",
        "polygon_handles",
        "real_sites",
        "virtual_sites",
        "cover_mean",
        "cover_max",
        "min_phi_sum",
        "folded_triangles",
    ] {
        assert!(report[key].as_f64().is_some_and(|number| number >= 0.0), "{key}: {}", report[key]);
    }
    for stage in ["domain", "sampling", "regions", "weights", "pose"] {
        assert!(report["ms"][stage].as_f64().is_some_and(|ms| ms >= 0.0), "{stage}: {}", report["ms"]);
    }
    assert!(report["min_phi_sum"].as_f64().unwrap() > 0.0);
}

#[test]
fn counts_handles_islands_and_holes() {
    let count = |report: &Value, key: &str| report[key].as_u64().unwrap();
    let ring = report("ring");
    assert_eq!((count(&ring, "islands"), count(&ring, "holes"), count(&ring, "point_handles")), (1, 1, 3));
    assert_eq!((count(&ring, "real_sites"), count(&ring, "bar_handles")), (3, 0));
    let portrait = report("portrait");
    assert_eq!((count(&portrait, "bar_handles"), count(&portrait, "polygon_handles")), (6, 1));
    assert_eq!((count(&portrait, "point_handles"), &portrait["outside"]), (0, &Value::Array(Vec::new())));
    let islands = report("islands");
    assert_eq!((count(&islands, "islands"), count(&islands, "holes"), count(&islands, "point_handles")), (2, 0, 1));
    assert_eq!((count(&islands, "loose_islands"), &islands["outline"]), (1, &Value::from("traced")));
    assert_eq!(count(&report("untouched"), "real_sites"), 0);
    // The project asks for 1,500 samples.
    assert!((750..=3000).contains(&count(&report("strip"), "samples")));
}

#[test]
fn text_report_has_the_same_values() {
    let folder = SceneFolder::new("ring");
    let text = String::from_utf8(succeed(folder.path(), "inspect scene.c2warp.json")).unwrap();
    for words in ["samples", "point handles", "folded triangles", "ms regions"] {
        assert!(text.lines().any(|line| line.starts_with(words)), "{words}: {text}");
    }
}

#[test]
fn closed_pipe_is_not_an_error() {
    let folder = SceneFolder::new("untouched");
    succeed_with_closed_pipe(folder.path(), "inspect scene.c2warp.json");
}
