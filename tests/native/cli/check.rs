//! Tests of `c2warp check`: all problems of a project at once.

use std::fs;

use serde_json::{Value, json};

use crate::command::{command, fail, succeed, succeed_with_closed_pipe};
use crate::scene_folder::{PROJECT, SceneFolder, all_by_24_px};

/// Runs the check with `--json` and returns the severity, path and code of each problem. The exit status is 1 if there
/// is an error.
#[track_caller]
fn problems(folder: &SceneFolder) -> Vec<[String; 3]> {
    let ended = command(folder.path(), &format!("check {PROJECT} --json")).output().unwrap();
    let printed: Value = serde_json::from_slice(&ended.stdout).unwrap();
    let text = |problem: &Value, key: &str| problem[key].as_str().unwrap().to_owned();
    let problems = printed["problems"].as_array().unwrap().iter();
    let problems: Vec<_> = problems.map(|it| ["severity", "path", "code"].map(|key| text(it, key))).collect();
    let errors = problems.iter().filter(|[severity, ..]| severity == "error").count();
    assert_eq!(printed["ok"], json!(errors == 0));
    let line = format!("c2warp: {PROJECT}: {errors} error{}\n", if errors == 1 { "" } else { "s" });
    let (status, stderr) = if errors == 0 { (0, String::new()) } else { (1, line) };
    assert_eq!((ended.status.code(), String::from_utf8(ended.stderr).unwrap()), (Some(status), stderr));
    problems
}

#[test]
fn errors_of_the_format_and_of_handles_are_found_together() {
    let folder = SceneFolder::new("ring").edited(|project| {
        let handles = project["handles"].as_array_mut().unwrap();
        handles.insert(0, json!({ "id": "gap", "kind": "point", "rest": [64, 64] }));
        handles.insert(1, json!({ "id": "typo", "kind": "point", "rest": ["x", 64] }));
        handles.insert(2, json!({ "id": "twin", "kind": "point", "rest": [20, 64] }));
        handles.push(json!({ "id": "north", "kind": "point", "rest": [64, 108] }));
        project["sample"] = json!(100);
        let keys = json!([{ "time": 0, "posed": [20, 64] }]);
        project["clips"] = json!([{ "name": "wave", "duration": 1, "tracks": [{ "handle": "typo", "keys": keys }] }]);
    });
    assert_eq!(
        problems(&folder),
        [
            ["error", "sample", "project"],
            ["error", "handles[1].rest[0]", "project"],
            ["error", "handles[6].id", "project"],
            ["error", "handles[0]", "handle-outside"],
            ["error", "handles[3]", "handles-too-close"],
        ]
    );
    let ended = command(folder.path(), &format!("check {PROJECT}")).output().unwrap();
    let lines = String::from_utf8(ended.stdout).unwrap();
    assert_eq!(lines.lines().count(), 5, "{lines}");
    assert!(
        lines.contains("\nerror: handles[0]: handle “gap” at (64, 64) lies outside the domain: place it"),
        "{lines}"
    );
}

#[test]
fn suspicious_content_is_a_warning() {
    let turned = SceneFolder::new("fold");
    assert_eq!(problems(&turned), [["warning", "handles", "folds"]]);
    let calm = turned.at_rest().edited(|project| {
        let keys = json!([{ "time": 0, "posed": [60, 60] }, { "time": 0.5, "posed": [130, 58] }]);
        project["clips"] = json!([{ "name": "cross", "duration": 1, "tracks": [{ "handle": "left", "keys": keys }] }]);
    });
    assert_eq!(problems(&calm), [["warning", "clips[0]", "folds"]]);
    let lines = String::from_utf8(succeed(calm.path(), &format!("check {PROJECT}"))).unwrap();
    assert!(lines.starts_with("warning: clips[0]: clip “cross” turns ") && lines.contains(" at 0.5 s"), "{lines}");
    let islands = SceneFolder::new("islands");
    assert_eq!(problems(&islands), [["warning", "loose_parts", "loose-parts"]]);
    assert_eq!(problems(&islands.edited(|project| project["loose_parts"] = json!("follow"))), [[""; 3]; 0]);
    let untouched = SceneFolder::new("untouched");
    assert_eq!(problems(&untouched), [["warning", "handles", "no-handles"]]);
    let bar = SceneFolder::new("strip").at_rest().edited(|project| {
        let bar = json!({ "id": "beam", "kind": "bar", "rest": [[70, 40], [120, 40]] });
        project["handles"].as_array_mut().unwrap().push(bar);
    });
    assert_eq!(problems(&bar), [["warning", "handles[3].rest", "outside"]]);
}

#[test]
fn invalid_displacements_are_reported_with_the_reason() {
    let good = all_by_24_px();
    let values = good["values"].as_str().unwrap();
    assert_eq!(values.len(), 88);
    let of = |width: Value, height: Value, values: Value| json!({ "width": width, "height": height, "values": values });
    for (displacement, path, message) in [
        (
            of(json!(4), json!(4), json!("AAAA")),
            "displacement.values",
            "expected 88 characters of base64 for 4 × 4 control points, found 4",
        ),
        // The numbers of another picture's grid.
        (
            of(json!(5), json!(4), json!(values)),
            "displacement.values",
            "expected 108 characters of base64 for 5 × 4 control points, found 88",
        ),
        (
            of(json!(4), json!(4), json!("!".repeat(88))),
            "displacement.values",
            "expected 4 × 4 × 4 bytes in base64 with its padding",
        ),
        (
            of(json!(4), json!(4), json!("A".repeat(88))),
            "displacement.values",
            "expected 4 × 4 × 4 bytes in base64 with its padding",
        ),
        (of(json!(4), json!(4), json!([0, 0])), "displacement.values", "expected a string, found a list"),
        (of(json!(3), json!(4), json!(values)), "displacement.width", "expected a whole number from 4 to 259, found 3"),
        (
            of(json!(4), json!(260), json!(values)),
            "displacement.height",
            "expected a whole number from 4 to 259, found 260",
        ),
        (
            of(json!(4.5), json!(4), json!(values)),
            "displacement.width",
            "expected a whole number from 4 to 259, found 4.5",
        ),
        (json!({ "width": 4, "height": 4 }), "displacement.values", "missing"),
        (json!([4, 4]), "displacement", "expected an object, found a list"),
    ] {
        let folder = SceneFolder::new("strip").at_rest().edited(|project| project["displacement"] = displacement);
        assert_eq!(problems(&folder), [["error", path, "project"]]);
        let ended = command(folder.path(), &format!("check {PROJECT}")).output().unwrap();
        let line = String::from_utf8(ended.stdout).unwrap();
        assert_eq!(line, format!("error: {path}: {message}\n"));
        let line = fail(folder.path(), &format!("warp {PROJECT} -o out.png"));
        assert!(line.starts_with(&format!("{PROJECT}: {path}")) && line.contains(message), "{line}");
    }
}

#[test]
fn a_displaced_picture_without_handles_has_no_problems() {
    let folder = SceneFolder::new("untouched").edited(|project| project["displacement"] = all_by_24_px());
    assert_eq!(problems(&folder), [[""; 3]; 0]);
}

#[test]
fn sound_projects_have_no_problems_and_unreadable_ones_one() {
    let folder = SceneFolder::new("strip").at_rest();
    assert_eq!(succeed(folder.path(), &format!("check {PROJECT}")), b"no problems\n");
    succeed_with_closed_pipe(folder.path(), &format!("check {PROJECT}"));
    assert!(fail(folder.path(), "check no.c2warp.json").contains("no.c2warp.json: cannot read this file"));
    let text = fs::read_to_string(folder.file(PROJECT)).unwrap();
    for (contents, path) in [("{", ""), ("[]", ""), ("{}", "format"), (&text.replace("c2warp/1", "c2warp/2"), "format")]
    {
        folder.write(PROJECT, contents);
        assert_eq!(problems(&folder), [["error", path, "project"]], "{contents}");
    }
    folder.write(PROJECT, text.replace("96", "95"));
    assert_eq!(problems(&folder)[0][..2], ["error", "image"]);
    folder.write(PROJECT, text);
    folder.write("strip.png", "no picture");
    assert_eq!(problems(&folder), [["error", "image.src", "picture"]]);
}
