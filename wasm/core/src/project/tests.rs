//! Tests of the format: reading, writing, and error messages.

use glam::{DAffine2, DMat2, DVec2};

use super::*;

const LEAST: &str = r#"{"format": "c2warp/1", "image": {"src": "a.png", "width": 4, "height": 3}, "handles": []}"#;

const FULL: &str = r#"{
  "format": "c2warp/1",
  "image": { "src": "gecko.webp", "width": 256, "height": 256 },
  "domain": { "kind": "alpha", "threshold": 0.5 },
  "samples": 10000,
  "weighting": { "shape_factor": 0.25, "degree": 7, "filling": "half", "support": "smooth" },
  "pose": { "mode": "rigid", "blend": "rigid", "density": 120 },
  "fix_boundary": true,
  "edges": true,
  "loose_parts": "follow",
  "handles": [
    { "id": "head", "kind": "point", "rest": [128, 40.5], "posed": [140, 0.1], "rotation": 15, "scale": 1, "depth": 0 },
    { "id": "tail", "kind": "bar", "rest": [[60, 200], [120, 220]], "posed": [[60, 200], [130, 240]], "rotation": "auto", "scale": 2, "depth": -1 },
    { "id": "eye", "kind": "polygon", "rest": [[1, 2], [3, 4], [5, 0]], "posed": [[1, 2], [3, 4], [5, 0]], "rotation": 0, "scale": 1, "depth": 0 }
  ]
}
"#;

/// A change to a project, and the error of the changed project.
type Refused = (fn(&mut Project), &'static str);

/// The error of the full project after an edit of its text.
fn refusal(from: &str, to: &str) -> String {
    assert!(FULL.contains(from), "{from}");
    Project::from_json(&FULL.replacen(from, to, 1)).unwrap_err().to_string()
}

#[test]
fn writes_the_text_that_it_read() {
    let project = Project::from_json(FULL).unwrap();
    assert_eq!(project.to_json(), FULL);
}

/// The full project with a clip.
fn with_clips(clips: &str) -> String {
    FULL.replacen("\n  ]\n}\n", &format!("\n  ],\n  \"clips\": {clips}\n}}\n"), 1)
}

#[test]
fn clips_are_written_as_they_are_read() {
    let clips = r#"[
    { "name": "wave", "duration": 1.2, "loop": "alternate", "tracks": [
        { "handle": "head", "keys": [
            { "time": 0, "posed": [160, 42], "rotation": "auto", "ease": "smooth" },
            { "time": 1.2, "scale": 2, "depth": -1, "ease": "hold" }
          ] },
        { "handle": "tail", "keys": [
            { "time": 0.5, "posed": [[60, 200], [120, 220]], "ease": "linear" }
          ] }
      ] },
    { "name": "still", "duration": 3, "loop": "none", "tracks": [] }
  ]"#;
    let project = Project::from_json(&with_clips(clips)).unwrap();
    assert_eq!(project.to_json(), with_clips(clips));
    let short = r#"[{ "name": "a", "duration": 1, "tracks": [{ "handle": "eye", "keys": [{ "time": 1 }] }] }]"#;
    let clips = Project::from_json(&with_clips(short)).unwrap().clips;
    let track = Track::new("eye", [Key::new(1.0, Ease::Smooth)]);
    assert_eq!(clips, [Clip::new("a", 1.0, Looping::Repeat).with_tracks([track])]);
}

#[test]
fn errors_in_clips_name_the_key() {
    let clip = |inside: &str| format!(r#"[{{ "name": "a", "duration": 1, {inside} }}]"#);
    let track = |handle: &str, keys: &str| clip(&format!(r#""tracks": [{{ "handle": "{handle}", "keys": {keys} }}]"#));
    let key = |inside: &str| track("head", &format!("[{{ {inside} }}]"));
    for (clips, message) in [
        ("{}".to_owned(), "clips: expected a list of clips, found an object"),
        (clip(r#""tracks": 7"#), "clips[0].tracks: expected a list of tracks, found 7"),
        (clip(r#""tracks": [], "fps": 25"#), "clips[0].fps: unknown key; expected one of name, duration, loop, tracks"),
        (
            clip(r#""tracks": [], "loop": "twice""#),
            r#"clips[0].loop: expected "repeat" or "alternate" or "none", found "twice""#,
        ),
        (
            r#"[{ "name": "", "duration": 1, "tracks": [] }]"#.to_owned(),
            "clips[0].name: expected a name, found an empty string",
        ),
        (
            r#"[{ "name": "a", "duration": 0, "tracks": [] }]"#.to_owned(),
            "clips[0].duration: expected seconds above 0 and up to 3600, found 0",
        ),
        (
            r#"[{ "name": "a", "duration": 1, "tracks": [] }, { "name": "a", "duration": 1, "tracks": [] }]"#
                .to_owned(),
            r#"clips[1].name: "a" is already the name of another clip"#,
        ),
        (track("ear", "[]"), r#"clips[0].tracks[0].handle: there is no handle "ear""#),
        (track("head", "[]"), "clips[0].tracks[0].keys: expected at least one key, found none"),
        (key(r#""time": 1.5"#), "clips[0].tracks[0].keys[0].time: expected seconds from 0 to 1, found 1.5"),
        (
            track("head", r#"[{ "time": 0.5 }, { "time": 0.5 }]"#),
            "clips[0].tracks[0].keys[1].time: expected a time after 0.5, that of the previous key, found 0.5",
        ),
        (key(r#""time": 0, "posed": [1]"#), "clips[0].tracks[0].keys[0].posed: expected a point [x, y], found 1 value"),
        (
            key(r#""time": 0, "posed": [[1, 2], [3, 4]]"#),
            "clips[0].tracks[0].keys[0].posed: expected a point [x, y], found 2 points",
        ),
        (
            track("tail", r#"[{ "time": 0, "posed": [1, 2] }]"#),
            "clips[0].tracks[0].keys[0].posed: expected as many points as in rest (2), found 1",
        ),
        (key(r#""time": 0, "scale": 0"#), "clips[0].tracks[0].keys[0].scale: expected a number above 0, found 0"),
        (
            key(r#""time": 0, "ease": "in""#),
            r#"clips[0].tracks[0].keys[0].ease: expected "smooth" or "linear" or "hold", found "in""#,
        ),
    ] {
        assert_eq!(Project::from_json(&with_clips(&clips)).unwrap_err().to_string(), message);
    }
    let twice = r#"[{ "name": "a", "duration": 1, "tracks": [
        { "handle": "head", "keys": [{ "time": 0 }] }, { "handle": "head", "keys": [{ "time": 0 }] }] }]"#;
    let message = r#"clips[0].tracks[1].handle: "head" already has a track"#;
    assert_eq!(Project::from_json(&with_clips(twice)).unwrap_err().to_string(), message);
}

#[test]
fn numbers_are_read_to_the_last_bit() {
    // Fast but inexact parsers read …304.
    let project = Project::from_json(&FULL.replacen("[128, 40.5]", "[-94.55329736530005, 40.5]", 1)).unwrap();
    let Shape::Point { rest, .. } = project.handles[0].shape else { panic!("a point") };
    assert_eq!(rest.x, -94.553_297_365_300_05);
    assert_eq!(Project::from_json(&project.to_json()).unwrap(), project);
}

#[test]
fn fills_in_the_defaults_and_writes_them_out() {
    let project = Project::from_json(LEAST).unwrap();
    let image = ImageRef { src: "a.png".to_owned(), width: 4, height: 3 };
    assert_eq!(project, Project::new(image));
    assert_eq!(Project::from_json(&project.to_json()).unwrap(), project);
    assert!(project.to_json().contains(r#""handles": []"#));
    assert_eq!((project.samples, project.weighting.shape_factor, project.weighting.degree), (10_000, 1.0, 5));
}

#[test]
fn errors_name_the_key() {
    for (from, to, refusal_text) in [
        (r#""c2warp/1""#, r#""c2warp/2""#, r#"format: expected "c2warp/1", found "c2warp/2""#),
        (r#""width": 256"#, r#""width": 0"#, "image.width: expected a whole number, 1 or more, found 0"),
        (r#""width": 256"#, r#""width": 1.5"#, "image.width: expected a whole number, 1 or more, found 1.5"),
        (r#""gecko.webp""#, "7", "image.src: expected a string, found 7"),
        ("0.5 }", "0 }", "domain.threshold: expected a number above 0 and up to 1, found 0"),
        (r#""alpha""#, r#""Alpha""#, r#"domain.kind: expected "image" or "alpha" or "polygon", found "Alpha""#),
        (r#""alpha""#, r#""image""#, "domain.threshold: unknown key; expected one of kind"),
        ("10000", "99", "samples: expected a whole number from 100 to 2000000, found 99"),
        ("10000", "2000001", "samples: expected a whole number from 100 to 2000000, found 2000001"),
        ("0.25", "1.01", "weighting.shape_factor: expected a number from 0 to 1, found 1.01"),
        (r#""degree": 7"#, r#""degree": 4"#, "weighting.degree: expected a whole number from 5 to 32, found 4"),
        (
            r#""support": "smooth""#,
            r#""continuity": "C2""#,
            r#"weighting.continuity: expected "exact" or "c2", found "C2""#,
        ),
        (r#""half""#, "null", r#"weighting.filling: expected "line" or "half", found null"#),
        (r#""density": 120"#, r#""density": -1"#, "pose.density: expected a whole number from 0 to 4096, found -1"),
        (r#""density": 120"#, r#""density": 4097"#, "pose.density: expected a whole number from 0 to 4096, found 4097"),
        ("true", "1", "fix_boundary: expected true or false, found 1"),
        (r#""follow""#, "true", r#"loose_parts: expected "stay" or "follow", found true"#),
        (
            r#""fix_boundary""#,
            r#""fixBoundary""#,
            "fixBoundary: unknown key; expected one of format, image, domain, fill, samples, weighting, pose, fix_boundary, edges, loose_parts, handles, clips, stiffness, displacement, shape",
        ),
        (r#""head""#, r#""""#, "handles[0].id: expected a name, found an empty string"),
        (r#""eye""#, r#""tail""#, r#"handles[2].id: "tail" is already the id of another handle"#),
        ("[128, 40.5]", r#"["x", 40.5]"#, r#"handles[0].rest[0]: expected a number, found "x""#),
        ("[128, 40.5]", "[128]", "handles[0].rest: expected a point [x, y], found 1 value"),
        ("[128, 40.5]", "[[1, 2]]", "handles[0].rest: expected a point [x, y], found 1 value"),
        ("15", r#""automatic""#, r#"handles[0].rotation: expected a number of degrees or "auto", found "automatic""#),
        (r#""scale": 1"#, r#""scale": 0"#, "handles[0].scale: expected a number above 0, found 0"),
        (r#""scale": 1"#, r#""scale": -2"#, "handles[0].scale: expected a number above 0, found -2"),
        (r#""rest": [128, 40.5], "#, "", "handles[0].rest: missing"),
        ("[[60, 200], [120, 220]]", "[[60, 200]]", "handles[1].rest: expected at least 2 points, found 1"),
        (
            "[[60, 200], [120, 220]]",
            "[[60, 200], [-7e164, 220]]",
            "handles[1].rest[1][0]: expected a number from −1e12 to 1e12, found -7e164",
        ),
        (
            "[[60, 200], [130, 240]]",
            "[[60, 200], [130, 240], [1, 1]]",
            "handles[1].posed: expected as many points as in rest (2), found 3",
        ),
        (
            "[[1, 2], [3, 4], [5, 0]]",
            "[[1, 2], [3, 4], [5, {}]]",
            "handles[2].rest[2][1]: expected a number, found an object",
        ),
        ("[[1, 2], [3, 4], [5, 0]]", "[[1, 2], [3, 4]]", "handles[2].rest: expected at least 3 points, found 2"),
    ] {
        assert_eq!(refusal(from, to), refusal_text);
    }
}

#[test]
fn refuses_numbers_that_are_not_json() {
    for number in ["NaN", "1e999", "-Infinity"] {
        let text = refusal("40.5", number);
        assert!(text.starts_with("handles[0].rest[1]: "), "{text}");
    }
    let twice = refusal(r#""depth": 0"#, r#""scale": 2"#);
    assert!(twice.starts_with(r#"handles[0]: duplicate key "scale""#), "{twice}");
}

#[test]
fn code_and_text_make_the_same_project() {
    let mut made = Project::for_picture(4, 3);
    made.handles = vec![
        Handle::point("a", [1.0, 2.0]).posed_at([[1.5, 2.0]]),
        Handle::bar("b", [[0.0, 0.0], [2.0, 0.5]]),
        Handle::polygon("c", [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0]]),
    ];
    let handles = r#"[
        { "id": "a", "kind": "point", "rest": [1, 2], "posed": [1.5, 2] },
        { "id": "b", "kind": "bar", "rest": [[0, 0], [2, 0.5]] },
        { "id": "c", "kind": "polygon", "rest": [[0, 0], [2, 0], [2, 2]] }
    ]"#;
    let read = LEAST.replace("a.png", "").replace("[]", handles);
    assert_eq!(made, Project::from_json(&read).unwrap());
    let rigid = made.clone().with_editor_settings();
    let settings = r#""weighting": { "support": "smooth" }, "pose": { "mode": "rigid", "density": 150 }, "edges": true,
        "handles""#;
    let read = read.replace("\"handles\"", settings).replace("[1.5, 2]", "[1.5, 2], \"rotation\": \"auto\"");
    assert_eq!(rigid, Project::from_json(&read).unwrap());
    made.handles[0].rotation = Rotation::Degrees(20.0);
    assert_eq!(made.with_editor_settings().handles[0].rotation, Rotation::Degrees(20.0));
}

#[test]
fn files_hold_continuity_only_if_it_is_not_the_default() {
    let exact = LEAST.replace("a.png", "");
    let c2 = exact.replace("\"handles\"", r#""weighting": { "continuity": "c2" }, "handles""#);
    let [exact, c2] = [exact, c2].map(|text| Project::from_json(&text).unwrap());
    assert_eq!((exact.weighting.continuity, c2.weighting.continuity), (Continuity::Exact, Continuity::C2));
    assert!(!exact.to_json().contains("continuity"));
    assert_eq!(Project::from_json(&c2.to_json()).unwrap(), c2);
}

#[test]
fn feathers_are_read_with_a_default_and_written() {
    let read = |domain: &str| {
        let text = format!(
            r#"{{"format":"c2warp/1","image":{{"src":"","width":9,"height":9}},"domain":{{{domain}}},"handles":[]}}"#
        );
        Project::from_json(&text).map_err(|error| error.to_string())
    };
    let ring = r#""kind":"polygon","rings":[[[0,0],[9,0],[0,9]]]"#;
    let triangle = DomainSpec::polygon(vec![[[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]].map(DVec2::from).to_vec()]);
    assert_eq!(read(ring).unwrap().domain, Some(triangle.clone()));
    let project = read(&format!(r#"{ring},"feather":7.5"#)).unwrap();
    assert_eq!(project.domain, Some(triangle.feathered(7.5)));
    assert!(project.to_json().contains(r#""feather": 7.5"#), "{}", project.to_json());
    assert_eq!(Project::from_json(&project.to_json()), Ok(project));
    let refused = [
        (format!(r#"{ring},"feather":-1"#), "domain.feather: expected a number from 0 to 64, found -1"),
        (format!(r#"{ring},"feather":64.5"#), "domain.feather: expected a number from 0 to 64, found 64.5"),
        (format!(r#"{ring},"feather":"wide""#), "domain.feather: expected a number, found \"wide\""),
        (r#""kind":"alpha","feather":8"#.into(), "domain.feather: unknown key; expected one of kind, threshold"),
        (r#""kind":"image","feather":8"#.into(), "domain.feather: unknown key; expected one of kind"),
    ];
    for (domain, message) in refused {
        assert!(read(&domain).unwrap_err().starts_with(message), "{:?}", read(&domain));
    }
}

#[test]
fn projects_from_code_and_text_follow_the_same_rules() {
    let good = Project::from_json(FULL).unwrap();
    assert_eq!(good.check(), Ok(()));
    let refused = |break_it: fn(&mut Project)| {
        let mut project = good.clone();
        break_it(&mut project);
        let refusal = project.check().unwrap_err().to_string();
        (Project::from_json(&project.to_json()).unwrap_err().to_string(), refusal)
    };
    let changes: [fn(&mut Project); 14] = [
        |project| project.image.height = 0,
        |project| project.domain = Some(DomainSpec::Alpha { threshold: -1.0 }),
        |project| project.domain = Some(DomainSpec::polygon(Vec::new())),
        |project| project.domain = Some(DomainSpec::polygon(vec![vec![DVec2::ZERO; 2]])),
        |project| project.domain = Some(DomainSpec::polygon(vec![vec![DVec2::ZERO; 3]]).feathered(64.5)),
        |project| project.samples = 0,
        |project| project.samples = u32::MAX,
        |project| project.weighting.shape_factor = 1.5,
        |project| project.weighting.degree = 2000,
        |project| project.pose.density = 4097,
        |project| project.handles[1].id.clear(),
        |project| project.handles[2].id = project.handles[0].id.clone(),
        |project| project.handles[0].scale = 0.0,
        |project| project.handles[2].shape = Shape::Polygon { rest: vec![DVec2::ONE; 3], posed: vec![DVec2::ONE; 4] },
    ];
    for change in changes {
        let (read, made) = refused(change);
        assert_eq!(read, made);
    }
}

#[test]
fn numbers_that_are_not_finite_are_refused_by_key() {
    let changes: [Refused; 6] = [
        (
            |project| project.domain = Some(DomainSpec::Alpha { threshold: f64::NAN }),
            "domain.threshold: expected a number above 0 and up to 1, found NaN",
        ),
        (
            |project| project.weighting.shape_factor = f64::NAN,
            "weighting.shape_factor: expected a number from 0 to 1, found NaN",
        ),
        (
            |project| project.handles[0].rotation = Rotation::Degrees(f64::INFINITY),
            "handles[0].rotation: expected a finite number, found inf",
        ),
        (|project| project.handles[0].scale = f64::NAN, "handles[0].scale: expected a finite number, found NaN"),
        (|project| project.handles[1].depth = f64::NAN, "handles[1].depth: expected a finite number, found NaN"),
        (
            |project| match &mut project.handles[2].shape {
                Shape::Polygon { posed, .. } => posed[1].y = f64::NAN,
                other => panic!("expected a polygon, found {other:?}"),
            },
            "handles[2].posed[1][1]: expected a finite number, found NaN",
        ),
    ];
    for (change, refusal) in changes {
        let mut project = Project::from_json(FULL).unwrap();
        change(&mut project);
        assert_eq!(project.check().unwrap_err().to_string(), refusal);
    }
}

#[test]
fn reads_rings_and_refuses_short_ones() {
    let with = |rings: &str| {
        let domain = format!(r#"{{ "kind": "polygon", "rings": {rings} }}"#);
        Project::from_json(&FULL.replace(r#"{ "kind": "alpha", "threshold": 0.5 }"#, &domain))
    };
    let project = with("[[[0, 0], [8, 0], [8.25, 8]]]").unwrap();
    assert_eq!(Project::from_json(&project.to_json()).unwrap(), project);
    assert_eq!(with("[]").unwrap_err().to_string(), "domain.rings: expected at least one ring");
    assert_eq!(
        with("[[[0, 0], [8, 0], [8, 8]], [[1, 1], [2, 2]]]").unwrap_err().to_string(),
        "domain.rings[1]: expected at least 3 points, found 2"
    );
}

#[test]
fn posed_defaults_to_rest() {
    let handles = handles_from_json(
        r#"[{"kind": "bar", "rest": [[0, 1], [2, 3]], "id": "b"}, {"id": "p", "kind": "point", "rest": [0.5, 1e-3]}]"#,
    )
    .unwrap();
    for handle in handles {
        match handle.shape {
            Shape::Point { rest, posed } => assert_eq!(rest, posed),
            Shape::Bar { rest, posed } | Shape::Polygon { rest, posed } => {
                assert_eq!(rest, posed);
            }
        }
    }
    assert_eq!(handles_from_json("\u{feff}[]"), Ok(Vec::new()));
    assert_eq!(handles_from_json("[7]").unwrap_err().to_string(), "[0]: expected an object, found 7");
}

#[test]
fn one_clip_is_read_with_paths_that_begin_at_it() {
    let hand = [Handle::point("hand", [1.0, 2.0])];
    let text = r#"{"name": "wave", "duration": 1, "tracks": [{"handle": "hand", "keys": [{"time": 0.5}]}]}"#;
    let clip = clip_from_json(text, &hand).unwrap();
    assert_eq!(
        clip,
        Clip::new("wave", 1.0, Looping::Repeat).with_tracks([Track::new("hand", [Key::new(0.5, Ease::Smooth)])])
    );
    let late = clip_from_json(&text.replace("0.5", "1.5"), &hand).unwrap_err();
    assert_eq!(late.path, "tracks[0].keys[0].time");
    assert_eq!(clip_from_json(text, &[]).unwrap_err().path, "tracks[0].handle");
    assert_eq!(clip_from_json(&text.replace("1,", "0,"), &hand).unwrap_err().path, "duration");
}

#[test]
fn later_versions_are_refused_before_unknown_keys() {
    let error = Project::from_json(r#"{"layers": [], "format": "c2warp/2"}"#).unwrap_err();
    assert_eq!(error.path, "format");
}

/// The full project with a mask.
fn with_mask(mask: &str) -> String {
    FULL.replacen("\n  ]\n}\n", &format!("\n  ],\n  \"stiffness\": {mask}\n}}\n"), 1)
}

#[test]
fn a_mask_is_written_as_it_is_read() {
    let mask = r#"{ "width": 2, "height": 2, "values": "AAD/gA==" }"#;
    let project = Project::from_json(&with_mask(mask)).unwrap();
    assert_eq!(project.stiffness, Some(Stiffness::new(2, 2, vec![0, 0, 255, 128])));
    assert_eq!(project.to_json(), with_mask(mask));
    assert_eq!(Project::from_json(FULL).unwrap().stiffness, None);
}

#[test]
fn errors_in_a_mask_name_the_key() {
    for (mask, message) in [
        ("null", "stiffness: expected an object, found null"),
        ("[]", "stiffness: expected an object, found an empty list"),
        (r#"{ "width": 2, "height": 2 }"#, "stiffness.values: missing"),
        (
            r#"{ "width": 0, "height": 0, "values": "" }"#,
            "stiffness.width: expected a whole number from 1 to 128, found 0",
        ),
        (
            r#"{ "width": 2, "height": 10000, "values": "" }"#,
            "stiffness.height: expected a whole number from 1 to 128, found 10000",
        ),
        (
            r#"{ "width": "NaN", "height": 2, "values": "" }"#,
            r#"stiffness.width: expected a whole number from 1 to 128, found "NaN""#,
        ),
        (
            r#"{ "width": 2.5, "height": 2, "values": "" }"#,
            "stiffness.width: expected a whole number from 1 to 128, found 2.5",
        ),
        (
            r#"{ "width": 2, "height": 2, "values": [0, 0, 1, null] }"#,
            "stiffness.values: expected a string, found a list",
        ),
        (
            r#"{ "width": 2, "height": 2, "values": "AAD/" }"#,
            "stiffness.values: expected 8 characters of base64 for 2 × 2 cells, found 4",
        ),
        (
            r#"{ "width": 2, "height": 2, "values": "AAD/gA-_" }"#,
            "stiffness.values: expected 2 × 2 bytes in base64 with its padding",
        ),
        (
            r#"{ "width": 2, "height": 2, "values": "AAD/gAAA" }"#,
            "stiffness.values: expected 2 × 2 bytes in base64 with its padding",
        ),
        (
            r#"{ "width": 1, "height": 1, "values": "AA==", "scale": 2 }"#,
            "stiffness.scale: unknown key; expected one of width, height, values",
        ),
    ] {
        assert_eq!(Project::from_json(&with_mask(mask)).unwrap_err().to_string(), message);
    }
    let mut project = Project::from_json(FULL).unwrap();
    project.stiffness = Some(Stiffness::new(3, 3, vec![0; 8]));
    assert_eq!(project.check().unwrap_err().to_string(), "stiffness.values: expected 3 × 3 bytes, found 8");
    project.stiffness = Some(Stiffness::new(10_000, 10_000, Vec::new()));
    let message = "stiffness.width: expected a whole number from 1 to 128, found 10000";
    assert_eq!(project.check().unwrap_err().to_string(), message);
}

/// The full project with a displacement.
fn with_displacement(displacement: &str) -> String {
    FULL.replacen("\n  ]\n}\n", &format!("\n  ],\n  \"displacement\": {displacement}\n}}\n"), 1)
}

#[test]
fn a_displacement_is_written_as_it_is_read() {
    let text = with_displacement(&format!(r#"{{ "width": 4, "height": 4, "values": "AQD+/w{}==" }}"#, "A".repeat(80)));
    let project = Project::from_json(&text).unwrap();
    let values = [vec![1, -2], vec![0; 30]].concat();
    assert_eq!(project.displacement, Some(Displacement::new(4, 4, values)));
    assert_eq!(project.to_json(), text);
    assert_eq!(Project::from_json(FULL).unwrap().displacement, None);
}

/// The full project with a shape.
fn with_shape(shape: &str) -> String {
    FULL.replacen("\n  ]\n}\n", &format!("\n  ],\n  \"shape\": {shape}\n}}\n"), 1)
}

#[test]
fn a_shape_is_written_as_it_is_read() {
    let text = with_shape("[\n    [1, 2, 3.5, -4, 0.5, 0, 0, 2],\n    [5, 6, 7, 8, 1, 0, 0, 1]\n  ]");
    let project = Project::from_json(&text).unwrap();
    assert_eq!(project.to_json(), text);
    assert_eq!(project.shape[0], ShapeSample::new([1.0, 2.0], [3.5, -4.0], DMat2::from_diagonal([0.5, 2.0].into())));
    assert_eq!(Project::from_json(FULL).unwrap().shape, []);
    assert_eq!(Project::from_json(&with_shape("[]")).unwrap().to_json(), FULL);
}

#[test]
fn errors_in_a_shape_name_the_sample() {
    let many = format!("[{}]", vec!["[1, 2, 3, 4, 1, 0, 0, 1]"; 65].join(", "));
    for (shape, message) in [
        ("{}", "shape: expected a list of samples, found an object"),
        ("[7]", "shape[0]: expected a sample of eight numbers, found 7"),
        ("[[1, 2, 3, 4, 1, 0, 0]]", "shape[0]: expected a sample of eight numbers, found 7"),
        ("[[1, 2, 3, \"4\", 1, 0, 0, 1]]", "shape[0][3]: expected a number, found \"4\""),
        ("[[1, 2, 3, 4, 1e13, 0, 0, 1]]", "shape[0][4]: expected a number from −1e12 to 1e12, found 10000000000000"),
        (&many, "shape: expected at most 64 samples, found 65"),
    ] {
        assert_eq!(Project::from_json(&with_shape(shape)).unwrap_err().to_string(), message);
    }
    let mut project = Project::from_json(FULL).unwrap();
    project.shape = vec![ShapeSample::new([1.0, 2.0], [f64::NAN, 0.0], DMat2::IDENTITY)];
    let message = "shape[0][2]: expected a number from −1e12 to 1e12, found NaN";
    assert_eq!(project.check().unwrap_err().to_string(), message);
}

#[test]
fn a_shape_is_mapped_with_its_picture() {
    let turn = DMat2::from_cols_array(&[0.0, 1.0, -1.0, 0.0]);
    let mut project = Project::from_json(FULL).unwrap();
    project.shape = vec![ShapeSample::new([10.0, 20.0], [30.0, 50.0], turn)];
    let map = DAffine2::from_scale_angle_translation([2.0, 3.0].into(), 0.0, [5.0, 7.0].into());
    let mapped = project.mapped(&map, (512, 768)).shape[0];
    assert_eq!((mapped.rest, mapped.posed), ([25.0, 67.0].into(), [65.0, 157.0].into()));
    let p = DVec2::new(12.0, 27.0);
    let expected = map.transform_point2(project.shape[0].place(p));
    assert!(mapped.place(map.transform_point2(p)).distance(expected) < 1e-12);
}

#[test]
fn errors_in_a_displacement_name_the_key() {
    for (displacement, message) in [
        ("[]", "displacement: expected an object, found an empty list"),
        (r#"{ "width": 4, "height": 4 }"#, "displacement.values: missing"),
        (
            r#"{ "width": 3, "height": 4, "values": "" }"#,
            "displacement.width: expected a whole number from 4 to 259, found 3",
        ),
        (
            r#"{ "width": 4, "height": 260, "values": "" }"#,
            "displacement.height: expected a whole number from 4 to 259, found 260",
        ),
        (
            r#"{ "width": 4, "height": 4, "values": "AQD+/w==" }"#,
            "displacement.values: expected 88 characters of base64 for 4 × 4 control points, found 8",
        ),
        (
            &format!(r#"{{ "width": 4, "height": 4, "values": "{}" }}"#, "A".repeat(88)),
            "displacement.values: expected 4 × 4 × 4 bytes in base64 with its padding",
        ),
    ] {
        assert_eq!(Project::from_json(&with_displacement(displacement)).unwrap_err().to_string(), message);
    }
    let mut project = Project::from_json(FULL).unwrap();
    project.displacement = Some(Displacement::new(4, 4, vec![0; 31]));
    let message = "displacement.values: expected 4 × 4 × 2 numbers, found 31";
    assert_eq!(project.check().unwrap_err().to_string(), message);
}

#[test]
fn only_polygons_have_a_stiffness() {
    let with = |handle: &str, value: &str| {
        let id = format!("\"id\": \"{handle}\"");
        Project::from_json(&FULL.replacen(&id, &format!("{id}, \"stiffness\": {value}"), 1))
    };
    let project = with("eye", "0.5").unwrap();
    assert_eq!(project.handles[2].stiffness, 0.5);
    assert_eq!(Project::from_json(&project.to_json()).unwrap(), project);
    assert_eq!(with("eye", "0").unwrap().to_json(), FULL);
    for (handle, value, message) in [
        ("eye", "1.5", "handles[2].stiffness: expected a number from 0 to 1, found 1.5"),
        ("eye", "-0.1", "handles[2].stiffness: expected a number from 0 to 1, found -0.1"),
        ("eye", "null", "handles[2].stiffness: expected a number, found null"),
        ("tail", "1", r#"handles[1].stiffness: only a polygon can be stiff, but "tail" is a bar"#),
        ("head", "0.2", r#"handles[0].stiffness: only a polygon can be stiff, but "head" is a point"#),
    ] {
        assert_eq!(with(handle, value).unwrap_err().to_string(), message);
    }
    let mut project = Project::from_json(FULL).unwrap();
    project.handles[2].stiffness = f64::NAN;
    assert_eq!(
        project.check().unwrap_err().to_string(),
        "handles[2].stiffness: expected a number from 0 to 1, found NaN"
    );
}

#[test]
fn names_have_at_most_200_characters() {
    let named = |id: &str, clip: &str, track: &str| {
        let text = r#"{ "format": "c2warp/1", "image": { "src": "", "width": 9, "height": 9 }, "handles": [{ "id": "ID",
            "kind": "point", "rest": [1, 2] }], "clips": [{ "name": "CLIP", "duration": 1, "tracks": [{ "handle":
            "TRACK", "keys": [{ "time": 0, "depth": 1 }] }] }] }"#;
        Project::from_json(&text.replace("ID", id).replace("CLIP", clip).replace("TRACK", track))
    };
    // Characters are counted, not bytes.
    let (longest, longer) = ("é".repeat(200), "é".repeat(201));
    assert!(named(&longest, &longest, &longest).is_ok());
    let expected = "expected a name of at most 200 characters, found 201";
    for (project, key) in [
        (named(&longer, "clip", &longer), "handles[0].id"),
        (named("head", &longer, "head"), "clips[0].name"),
        (named("head", "clip", &longer), "clips[0].tracks[0].handle"),
    ] {
        assert_eq!(project.unwrap_err().to_string(), format!("{key}: {expected}"));
    }
    let project = Project::for_picture(9, 9).with_handles([Handle::point(longer, [1.0, 2.0])]);
    assert_eq!(project.check().unwrap_err().to_string(), format!("handles[0].id: {expected}"));
}

#[test]
fn refusals_quote_no_long_text() {
    let long = "x".repeat(100_000);
    for (text, expected) in [
        (format!(r#"{{"format": "{long}"}}"#), r#"format: expected "c2warp/1", found a long string"#.to_owned()),
        (format!(r#"{{"format": "c2warp/1", "{long}": 1}}"#), format!("{}…: unknown key; expected", "x".repeat(40))),
        (format!(r#"{{"{long}": 1, "{long}": 2}}"#), "duplicate key a long string".to_owned()),
    ] {
        let refused = Project::from_json(&text).unwrap_err().to_string();
        assert!(refused.contains(&expected) && refused.len() < 400, "{refused}");
    }
}
