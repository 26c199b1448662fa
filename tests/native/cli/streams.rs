//! Standard input and output, and output files that others look at meanwhile.

use std::fs::{self, File};
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use image::ImageFormat;
use serde_json::json;

use crate::command::{command, succeed, succeed_unread};
use crate::workplace::Workplace;

const DISTANCE: &str = "distance scene.c2warp.json --from 7,41 --at points.csv";

/// A strip with a list of more points than a pipe holds the table of.
fn with_points() -> Workplace {
    let place = Workplace::with("strip");
    let lines: String = (0..20_000).map(|i| format!("{},{}\n", i % 96, i % 48)).collect();
    place.write("points.csv", format!("x,y\n{lines}"));
    place
}

#[test]
fn standard_output_takes_pictures_and_tables() {
    let place = with_points();
    succeed(place.folder(), &format!("{DISTANCE} -o out.csv"));
    assert!(succeed(place.folder(), &format!("{DISTANCE} -o -")) == fs::read(place.file("out.csv")).unwrap());
    let run = command(place.folder(), "warp scene.c2warp.json --grow -o -").output().unwrap();
    assert_eq!(image::guess_format(&run.stdout).unwrap(), ImageFormat::Png);
    assert!(image::load_from_memory(&run.stdout).is_ok() && run.stdout.ends_with(b"IEND\xaeB`\x82"));
    assert_eq!(run.stderr, succeed(place.folder(), "warp scene.c2warp.json --grow -o out.png"));
    assert!(!place.file("-").exists());
}

#[test]
fn standard_input_gives_projects_pictures_and_points() {
    let place = with_points();
    place.write("photo", fs::read(place.file("strip.png")).unwrap());
    let photo = place.picture("strip.png");
    image::DynamicImage::from(photo).into_rgb8().save(place.file("photo.jpg")).unwrap();
    for (file, arguments) in [
        ("scene.c2warp.json", "warp - -o"),
        ("photo", "warp scene.c2warp.json --image - -o"),
        ("photo.jpg", "warp scene.c2warp.json --image - -o"),
        ("points.csv", "map scene.c2warp.json --at - -o"),
    ] {
        succeed(place.folder(), &format!("{} out", arguments.replace(" - ", &format!(" {file} "))));
        let mut run = command(place.folder(), &format!("{arguments} piped")).stdin(Stdio::piped()).spawn().unwrap();
        std::io::copy(&mut File::open(place.file(file)).unwrap(), &mut run.stdin.take().unwrap()).unwrap();
        assert!(run.wait().unwrap().success());
        assert!(fs::read(place.file("piped")).unwrap() == fs::read(place.file("out")).unwrap(), "{file}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_standard_output_leads_to_keeps_what_others_wrote() {
    let place = with_points();
    let table = succeed(place.folder(), &format!("{DISTANCE} -o -"));
    for name in ["-", "/dev/stdout"] {
        let log = File::create(place.file("log")).unwrap();
        for _ in 0..2 {
            let output = log.try_clone().unwrap();
            let status = command(place.folder(), &format!("{DISTANCE} -o {name}")).stdout(output).status().unwrap();
            assert!(status.success());
        }
        assert!(fs::read(place.file("log")).unwrap() == [table.as_slice(), &table].concat(), "{name}");
    }
}

#[test]
fn a_reader_may_have_read_enough() {
    let place = with_points();
    for subcommand in [DISTANCE, "map scene.c2warp.json --at points.csv", "warp scene.c2warp.json"] {
        succeed_unread(place.folder(), &format!("{subcommand} -o -"));
    }
}

#[test]
fn a_run_that_is_killed_at_work_leaves_nothing_behind() {
    let place = Workplace::with("strip").changed(|project| project["samples"] = json!(2_000_000));
    let mut run = command(place.folder(), "warp scene.c2warp.json -o out.png").spawn().unwrap();
    sleep(Duration::from_millis(300));
    assert!(run.try_wait().unwrap().is_none(), "it was too quick");
    run.kill().unwrap();
    run.wait().unwrap();
    assert_eq!(place.listing(), ["scene.c2warp.json", "strip.png"]);
}

#[cfg(unix)]
#[test]
fn a_file_that_is_replaced_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;

    let place = Workplace::with("untouched");
    place.write("out.png", "");
    for mode in [0o600, 0o666] {
        fs::set_permissions(place.file("out.png"), PermissionsExt::from_mode(mode)).unwrap();
        succeed(place.folder(), "warp scene.c2warp.json -o out.png");
        assert_eq!(fs::metadata(place.file("out.png")).unwrap().permissions().mode() & 0o777, mode);
    }
}

#[cfg(unix)]
#[test]
fn links_to_links_are_kept() {
    let place = Workplace::with("untouched");
    for (link, to) in [("out.png", "between.png"), ("between.png", "real.png")] {
        std::os::unix::fs::symlink(to, place.file(link)).unwrap();
    }
    succeed(place.folder(), "warp scene.c2warp.json -o out.png");
    assert!(place.file("between.png").is_symlink() && place.picture("real.png") == place.picture("strip.png"));
}
