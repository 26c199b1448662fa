//! `c2warp inspect`.

use serde_json::Value;

use crate::command::{succeed, succeed_unread};
use crate::workplace::Workplace;

fn report(scene: &str) -> Value {
    let printed = succeed(Workplace::with(scene).folder(), "inspect scene.c2warp.json --json");
    serde_json::from_slice(&printed).unwrap()
}

#[test]
fn tells_everything_that_it_promises() {
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
    assert_eq!(count(&report("untouched"), "real_sites"), 0);
    // As many samples as were asked for, about.
    assert!((750..=3000).contains(&count(&report("strip"), "samples")));
}

#[test]
fn says_the_same_to_people() {
    let place = Workplace::with("ring");
    let text = String::from_utf8(succeed(place.folder(), "inspect scene.c2warp.json")).unwrap();
    for words in ["samples", "point handles", "folded triangles", "ms regions"] {
        assert!(text.lines().any(|line| line.starts_with(words)), "{words}: {text}");
    }
}

#[test]
fn is_content_when_nobody_reads_on() {
    let place = Workplace::with("untouched");
    succeed_unread(place.folder(), "inspect scene.c2warp.json");
}
