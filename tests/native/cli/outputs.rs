//! Tests of what outputs may replace: neither an input nor another output, by any name. And of interrupted runs.

use std::fs::{self, File};
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::json;

use crate::command::{command, fail, succeed};
use crate::scene_folder::{PROJECT, SceneFolder};

/// A ring with a clip, a second picture of its size, and points.
fn all_inputs() -> SceneFolder {
    let folder = SceneFolder::new("ring").edited(|project| {
        let id = project["handles"][0]["id"].clone();
        let keys = json!([{ "time": 0, "rotation": 0 }, { "time": 0.2, "rotation": 40 }]);
        let tracks = json!([{ "handle": id, "keys": keys }]);
        project["clips"] = json!([{ "name": "turn", "duration": 0.4, "loop": "none", "tracks": tracks }]);
    });
    folder.write("points.csv", "x,y\n20,64\n");
    let mut other = folder.picture("ring.png");
    other.put_pixel(0, 0, image::Rgba([1, 2, 3, 255]));
    other.save(folder.file("other.png")).unwrap();
    folder
}

/// The files of a folder with their contents, without links.
fn contents(folder: &SceneFolder) -> Vec<(String, Vec<u8>)> {
    let files = folder.file_names().into_iter().filter(|name| folder.file(name).is_file());
    files.map(|name| (name.clone(), fs::read(folder.file(&name)).unwrap())).collect()
}

/// Commands with the name of the output that `OUT` stands for, and the inputs that it must not replace.
///
/// The own picture of a project is no input beside another one, unless outlines are lined up.
const COMMANDS: &[(&str, &str, &[&str])] = &[
    ("warp scene.c2warp.json -o OUT", "out.png", &[PROJECT, "ring.png"]),
    ("warp scene.c2warp.json -o bent.png --stmap OUT", "out.exr", &[PROJECT, "ring.png"]),
    ("warp scene.c2warp.json --image other.png -o OUT", "out.png", &[PROJECT, "other.png"]),
    ("warp other.png --project scene.c2warp.json -o OUT", "out.png", &[PROJECT, "other.png"]),
    ("warp scene.c2warp.json --image other.png --fit alpha -o OUT", "out.png", &[PROJECT, "other.png", "ring.png"]),
    ("animate scene.c2warp.json -o OUT", "out.gif", &[PROJECT, "ring.png"]),
    ("animate scene.c2warp.json -o OUT", "out.png", &[PROJECT, "ring.png"]),
    ("animate scene.c2warp.json -o OUT", "out.webp", &[PROJECT, "ring.png"]),
    ("animate scene.c2warp.json --sheet OUT", "out.png", &[PROJECT, "ring.png"]),
    ("animate scene.c2warp.json --sheet beside.png", "beside.json", &[PROJECT, "ring.png"]),
    ("animate scene.c2warp.json -o frame-%02d.png", "frame-07.png", &[PROJECT, "ring.png"]),
    ("maps scene.c2warp.json --inverse OUT", "out.exr", &[PROJECT, "ring.png"]),
    ("maps scene.c2warp.json --inverse a.exr --stretch OUT", "out.png", &[PROJECT, "ring.png"]),
    ("maps scene.c2warp.json --forward OUT --image other.png", "out.png", &[PROJECT, "other.png"]),
    ("maps scene.c2warp.json --disocclusion OUT", "out.png", &[PROJECT, "ring.png"]),
    ("map scene.c2warp.json --at points.csv -o OUT", "out.csv", &[PROJECT, "ring.png", "points.csv"]),
    ("weights scene.c2warp.json --at points.csv -o OUT", "out.npy", &[PROJECT, "ring.png", "points.csv"]),
    ("weights scene.c2warp.json --handle HANDLE -o OUT", "out.png", &[PROJECT, "ring.png"]),
    ("weights scene.c2warp.json --every 9 -o a.csv --sites OUT", "out.csv", &[PROJECT, "ring.png"]),
    ("distance scene.c2warp.json --from 20,64 --at points.csv -o OUT", "out.csv", &[PROJECT, "ring.png", "points.csv"]),
    ("bake scene.c2warp.json -o OUT", "out.c2rig", &[PROJECT, "ring.png"]),
    ("export scene.c2warp.json -o OUT", "out.glb", &[PROJECT, "ring.png"]),
    ("export scene.c2warp.json -o OUT", "out.tscn", &[PROJECT, "ring.png"]),
    ("export scene.c2warp.json -o rig.spine.json", "rig.atlas", &[PROJECT, "ring.png"]),
    // The project's own picture is used as it is.
    ("export scene.c2warp.json -o rig.spine.json", "rig.png", &[PROJECT]),
    ("export scene.c2warp.json -o rig_ske.json", "rig_tex.json", &[PROJECT, "ring.png"]),
    ("new ring.png --handles 20,64 --force -o OUT", "out.c2warp.json", &["ring.png"]),
];

#[cfg(unix)]
#[test]
fn no_output_replaces_an_input() {
    let folder = all_inputs();
    let handle = serde_json::from_slice::<serde_json::Value>(&fs::read(folder.file(PROJECT)).unwrap()).unwrap()
        ["handles"][0]["id"]
        .as_str()
        .unwrap()
        .to_owned();
    let before = contents(&folder);
    for &(arguments, output, inputs) in COMMANDS {
        let arguments = arguments.replace("HANDLE", &handle);
        for &input in inputs {
            let refuse = |output: &str| {
                let line = fail(folder.path(), &arguments.replace("OUT", output));
                assert!(contents(&folder) == before, "{arguments}, {output}: {line}");
                line
            };
            // Its extension may be rejected first.
            for name in [input.to_owned(), format!("./{input}"), folder.file(input).to_string_lossy().into_owned()] {
                if arguments.contains("OUT") {
                    refuse(&name);
                }
            }
            for link in [|from, to| std::os::unix::fs::symlink(from, to), |from, to| fs::hard_link(from, to)] {
                link(folder.file(input), folder.file(output)).unwrap();
                let link = folder.file(output);
                let (line, now) = {
                    let line = fail(folder.path(), &arguments.replace("OUT", output));
                    assert!(link.is_symlink() || fs::read(&link).unwrap() == fs::read(folder.file(input)).unwrap());
                    fs::remove_file(&link).unwrap();
                    (line, contents(&folder))
                };
                assert!(now == before, "{arguments}: {line}");
                let expected = [format!("{output}: this is the input "), input.to_owned()];
                assert!(expected.iter().all(|part| line.contains(part)), "{arguments}: {line}");
            }
        }
    }
}

#[cfg(unix)]
#[test]
fn redirected_input_is_an_input() {
    let folder = all_inputs();
    for (file, arguments) in [
        (PROJECT, "warp - -o scene.c2warp.json"),
        ("other.png", "warp scene.c2warp.json --image - -o other.png"),
        ("points.csv", "map scene.c2warp.json --at /dev/stdin -o points.csv"),
    ] {
        let before = fs::read(folder.file(file)).unwrap();
        let mut run = command(folder.path(), arguments);
        let ended = run.stdin(File::open(folder.file(file)).unwrap()).output().unwrap();
        let told = String::from_utf8(ended.stderr).unwrap();
        assert!(ended.status.code() == Some(1) && told.contains("this is the input"), "{arguments}: {told}");
        assert!(fs::read(folder.file(file)).unwrap() == before);
    }
    // What is appended is no input then.
    let log = fs::OpenOptions::new().append(true).open(folder.file(PROJECT)).unwrap();
    let ended = command(folder.path(), "warp scene.c2warp.json -o -").stdout(log).output().unwrap();
    assert_eq!(ended.status.code(), Some(1));
    assert!(String::from_utf8(ended.stderr).unwrap().contains("-: this is the input scene.c2warp.json"));
}

#[cfg(unix)]
#[test]
fn no_output_replaces_another_output() {
    let folder = all_inputs();
    std::os::unix::fs::symlink("one", folder.file("two.png")).unwrap();
    fs::create_dir(folder.file("in")).unwrap();
    let before = contents(&folder);
    for arguments in [
        "animate scene.c2warp.json -o film.png --sheet film.png",
        "animate scene.c2warp.json -o frame-%04d.png --sheet ./frame-0003.png",
        "animate scene.c2warp.json -o frame-%d.png --sheet in/../frame-11.png",
        "animate scene.c2warp.json -o one.png --sheet one.png",
        "maps scene.c2warp.json --inverse in/a.exr --forward in/../in/a.exr",
        "maps scene.c2warp.json --inverse - --forward /dev/stdout",
        "weights scene.c2warp.json --every 9 -o a.csv --sites ./a.csv",
        "warp scene.c2warp.json -o one --stmap two.png.exr",
        "warp scene.c2warp.json -o out --stmap out",
    ] {
        if arguments.contains("two.png.exr") {
            std::os::unix::fs::symlink("one", folder.file("two.png.exr")).unwrap();
        }
        let line = fail(folder.path(), arguments);
        assert!(line.contains(": this is also the output "), "{arguments}: {line}");
        assert!(contents(&folder) == before, "{arguments}");
    }
}

#[test]
fn many_results_replace_no_input_that_is_still_to_be_read() {
    let folder = all_inputs();
    fs::create_dir(folder.file("out")).unwrap();
    // The second project names the result of the first one as its picture.
    fs::copy(folder.file("ring.png"), folder.file("out/first.png")).unwrap();
    let project = fs::read_to_string(folder.file(PROJECT)).unwrap();
    folder.write("first.c2warp.json", &project);
    folder.write("second.c2warp.json", project.replace("\"ring.png\"", "\"out/first.png\""));
    let before = fs::read(folder.file("out/first.png")).unwrap();
    let run = command(folder.path(), "warp first.c2warp.json second.c2warp.json -o out").output().unwrap();
    let told = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(told, "c2warp: out/first.png: this is the input out/first.png: choose another output\n");
    assert!(fs::read(folder.file("out/first.png")).unwrap() == before && folder.file("out/second.png").exists());
}

#[test]
fn pictures_of_a_shell_pattern_have_a_result_each() {
    let folder = all_inputs();
    fs::create_dir(folder.file("in")).unwrap();
    fs::copy(folder.file("ring.png"), folder.file("in/other.jpg")).unwrap();
    let names = |out: &str| {
        let entries = fs::read_dir(folder.file(out)).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    for (out, arguments) in [
        ("a", "warp scene.c2warp.json --image ring.png other.png -o a"),
        ("b", "warp --image ring.png other.png -o b scene.c2warp.json"),
        ("c", "warp --image ring.png other.png scene.c2warp.json -o c"),
        ("d", "warp --image other.png --image ring.png -o d scene.c2warp.json"),
    ] {
        succeed(folder.path(), arguments);
        assert_eq!(names(out), ["other.png", "ring.png"], "{arguments}");
        for name in ["other.png", "ring.png"] {
            succeed(folder.path(), &format!("warp scene.c2warp.json --image {name} -o single.png"));
            let read = |path: &str| fs::read(folder.file(path)).unwrap();
            assert!(read(&format!("{out}/{name}")) == read("single.png"), "{arguments}");
        }
    }
    // One picture, as a pattern may give.
    succeed(folder.path(), "warp scene.c2warp.json --image ring.png -o e/");
    succeed(folder.path(), "warp scene.c2warp.json -o a");
    assert_eq!((names("e"), names("a").len()), (vec!["ring.png".to_owned()], 3));
    // The result of the second would have the name of the first.
    let run = command(folder.path(), "warp scene.c2warp.json --image other.png in/other.jpg -o f").output().unwrap();
    let told = String::from_utf8(run.stderr).unwrap();
    let expected = "c2warp: in/other.jpg: its result has the same name as that of other.png: rename one of them\n";
    assert_eq!((run.status.code(), told.as_str()), (Some(1), expected));
    assert_eq!(names("f"), ["other.png"]);
    let run = command(folder.path(), "warp --image ring.png other.png -o g").output().unwrap();
    let told = String::from_utf8(run.stderr).unwrap();
    assert!(run.status.code() == Some(2) && told.contains("the project stands before --image"), "{told}");
    assert!(!folder.file("g").exists());
}

/// Whether this process ignores a signal, and with it those that it starts: tests may run in the background.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.is_some_and(|mask| u64::from_str_radix(mask.trim(), 16).unwrap() >> (signal - 1) & 1 == 1)
}

#[cfg(unix)]
#[test]
fn interrupted_run_leaves_no_files() {
    use std::os::unix::process::ExitStatusExt;

    let folder = all_inputs();
    let long = "animate scene.c2warp.json --fps 240 --scale 4 -o film.png --sheet sheet.png";
    folder.write("film.png", "an earlier film");
    let before = folder.file_names();
    let signals = [15, 2, 1].into_iter().filter(|&signal| !is_ignored(signal));
    for (at, signal) in signals.cycle().take(9).enumerate() {
        let mut run = command(folder.path(), long).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(40 + 60 * at as u64));
        assert!(run.try_wait().unwrap().is_none(), "the run ended before it could be interrupted");
        let sent = Command::new("kill").arg(format!("-{signal}")).arg(run.id().to_string()).status().unwrap();
        assert!(sent.success());
        assert_eq!(run.wait().unwrap().signal(), Some(signal));
        assert_eq!(folder.file_names(), before, "{signal}");
        assert_eq!(fs::read(folder.file("film.png")).unwrap(), b"an earlier film");
    }
}

#[cfg(unix)]
#[test]
fn ignored_signals_stay_ignored() {
    let folder = all_inputs();
    let run = command(folder.path(), "animate scene.c2warp.json --fps 60 -o film.png");
    // As `nohup` does.
    let mut nohup = Command::new("sh");
    nohup.current_dir(folder.path()).args(["-c", "trap '' HUP; echo; exec \"$0\" \"$@\""]).arg(run.get_program());
    let mut run = nohup.args(run.get_args()).stdout(Stdio::piped()).spawn().unwrap();
    // An empty line: the shell ignores the signal now.
    run.stdout.as_mut().unwrap().read_exact(&mut [0]).unwrap();
    let begun = Instant::now();
    while run.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(60) {
        let _ = Command::new("kill").args(["-HUP", &run.id().to_string()]).stderr(Stdio::null()).status();
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(run.wait().unwrap().success() && folder.file("film.png").exists());
}
