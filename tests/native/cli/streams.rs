//! Tests of standard input and output, and of output files during a run.

use std::fs::{self, File};
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use image::ImageFormat;
use serde_json::json;

use crate::command::{command, succeed, succeed_with_closed_pipe};
use crate::scene_folder::SceneFolder;

const DISTANCE: &str = "distance scene.c2warp.json --from 7,41 --at points.csv";

/// Returns the strip with so many points that their table exceeds the buffer of a pipe.
fn with_points() -> SceneFolder {
    let folder = SceneFolder::new("strip");
    let lines: String = (0..20_000).map(|i| format!("{},{}\n", i % 96, i % 48)).collect();
    folder.write("points.csv", format!("x,y\n{lines}"));
    folder
}

#[test]
fn standard_output_accepts_pictures_and_tables() {
    let folder = with_points();
    succeed(folder.path(), &format!("{DISTANCE} -o out.csv"));
    assert!(succeed(folder.path(), &format!("{DISTANCE} -o -")) == fs::read(folder.file("out.csv")).unwrap());
    let run = command(folder.path(), "warp scene.c2warp.json --grow -o -").output().unwrap();
    assert_eq!(image::guess_format(&run.stdout).unwrap(), ImageFormat::Png);
    assert!(image::load_from_memory(&run.stdout).is_ok() && run.stdout.ends_with(b"IEND\xaeB`\x82"));
    assert_eq!(run.stderr, succeed(folder.path(), "warp scene.c2warp.json --grow -o out.png"));
    assert!(!folder.file("-").exists());
}

#[test]
fn standard_input_provides_projects_pictures_and_points() {
    let folder = with_points();
    folder.write("photo", fs::read(folder.file("strip.png")).unwrap());
    let photo = folder.picture("strip.png");
    image::DynamicImage::from(photo).into_rgb8().save(folder.file("photo.jpg")).unwrap();
    for (file, arguments) in [
        ("scene.c2warp.json", "warp - -o"),
        ("photo", "warp scene.c2warp.json --image - -o"),
        ("photo.jpg", "warp scene.c2warp.json --image - -o"),
        ("points.csv", "map scene.c2warp.json --at - -o"),
    ] {
        succeed(folder.path(), &format!("{} out", arguments.replace(" - ", &format!(" {file} "))));
        let mut run = command(folder.path(), &format!("{arguments} piped")).stdin(Stdio::piped()).spawn().unwrap();
        std::io::copy(&mut File::open(folder.file(file)).unwrap(), &mut run.stdin.take().unwrap()).unwrap();
        assert!(run.wait().unwrap().success());
        assert!(fs::read(folder.file("piped")).unwrap() == fs::read(folder.file("out")).unwrap(), "{file}");
    }
}

#[cfg(unix)]
#[test]
fn standard_output_to_a_file_appends() {
    let folder = with_points();
    let table = succeed(folder.path(), &format!("{DISTANCE} -o -"));
    for name in ["-", "/dev/stdout"] {
        let log = File::create(folder.file("log")).unwrap();
        for _ in 0..2 {
            let output = log.try_clone().unwrap();
            let status = command(folder.path(), &format!("{DISTANCE} -o {name}")).stdout(output).status().unwrap();
            assert!(status.success());
        }
        assert!(fs::read(folder.file("log")).unwrap() == [table.as_slice(), &table].concat(), "{name}");
    }
}

#[test]
fn closed_pipe_is_not_an_error() {
    let folder = with_points();
    for subcommand in [DISTANCE, "map scene.c2warp.json --at points.csv", "warp scene.c2warp.json"] {
        succeed_with_closed_pipe(folder.path(), &format!("{subcommand} -o -"));
    }
}

#[test]
fn killed_run_leaves_no_files() {
    let folder = SceneFolder::new("strip").edited(|project| project["samples"] = json!(2_000_000));
    let mut run = command(folder.path(), "warp scene.c2warp.json -o out.png").spawn().unwrap();
    sleep(Duration::from_millis(300));
    assert!(run.try_wait().unwrap().is_none(), "the run ended before it could be killed");
    run.kill().unwrap();
    run.wait().unwrap();
    assert_eq!(folder.file_names(), ["scene.c2warp.json", "strip.png"]);
}

#[cfg(unix)]
#[test]
fn replaced_file_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;

    let folder = SceneFolder::new("untouched");
    folder.write("out.png", "");
    for mode in [0o600, 0o666] {
        fs::set_permissions(folder.file("out.png"), PermissionsExt::from_mode(mode)).unwrap();
        succeed(folder.path(), "warp scene.c2warp.json -o out.png");
        assert_eq!(fs::metadata(folder.file("out.png")).unwrap().permissions().mode() & 0o777, mode);
    }
}

#[cfg(unix)]
#[test]
fn chained_links_are_kept() {
    let folder = SceneFolder::new("untouched");
    for (link, to) in [("out.png", "between.png"), ("between.png", "real.png")] {
        std::os::unix::fs::symlink(to, folder.file(link)).unwrap();
    }
    succeed(folder.path(), "warp scene.c2warp.json -o out.png");
    assert!(folder.file("between.png").is_symlink() && folder.picture("real.png") == folder.picture("strip.png"));
}
