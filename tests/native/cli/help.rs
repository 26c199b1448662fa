//! Tests of the command's own documentation: help with examples that run, completions, manual pages, the schema.

use std::fs;
use std::path::Path;

use c2warp_tests::Scene;
use serde_json::{Value, json};

use crate::command::{fail, succeed, succeed_with_closed_pipe};
use crate::scene_folder::SceneFolder;

fn text(arguments: &str) -> String {
    String::from_utf8(succeed(Path::new("."), arguments)).unwrap()
}

/// The names of all commands, as the help lists them.
fn commands() -> Vec<String> {
    let help = text("--help");
    let (_, list) = help.split_once("Commands:\n").unwrap();
    let names = list.lines().map_while(|line| line.split_whitespace().next());
    names.filter(|&name| name != "help").map(str::to_owned).collect()
}

/// The command lines of the example in the help of a command, without `c2warp`.
fn example(name: &str) -> Vec<String> {
    let help = text(&format!("help {name}"));
    let example = help.split_once("\nExample: ").unwrap_or_else(|| panic!("{name} has no example")).1;
    let lines = example.lines().filter_map(|line| line.strip_prefix("  c2warp "));
    lines.map(str::to_owned).collect()
}

/// A folder with the files that examples name: a cat with a clip, its picture, a table of points, and folders.
fn folder() -> SceneFolder {
    let folder = SceneFolder::new("gingerbread").edited(|project| {
        let keys = json!([{ "time": 0, "posed": [24, 96] }, { "time": 0.2, "posed": [34, 60] }]);
        let tracks = json!([{ "handle": "left-hand", "keys": keys }]);
        project["clips"] = json!([{ "name": "wave", "duration": 0.4, "loop": "repeat", "tracks": tracks }]);
        project["image"]["src"] = json!("cat.png");
    });
    fs::rename(folder.file("gingerbread.png"), folder.file("cat.png")).unwrap();
    fs::rename(folder.file("scene.c2warp.json"), folder.file("cat.c2warp.json")).unwrap();
    folder.write("points.csv", "x,y\n90,120\n24,96\n");
    fs::create_dir(folder.file("rigs")).unwrap();
    folder
}

#[test]
fn every_command_has_an_example_that_runs_and_is_in_the_manual() {
    let folder = folder();
    let manual = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../web/docs/cli.md")).unwrap();
    for name in commands() {
        let lines = example(&name);
        assert!(!lines.is_empty(), "{name}");
        for line in lines {
            assert!(line.starts_with(&name) && manual.contains(&format!("c2warp {line}")), "cli.md: {line}");
            // The shell would write the output to a file.
            let (arguments, file) = line.split_once(" > ").map_or((&*line, None), |(line, file)| (line, Some(file)));
            let printed = succeed(folder.path(), arguments);
            assert!(file.is_none() || !printed.is_empty(), "{line}");
            let words: Vec<&str> = arguments.split_whitespace().collect();
            if let Some(at) = words.iter().position(|&word| word == "-o") {
                assert!(folder.file(words[at + 1]).exists(), "{line}");
            }
        }
    }
}

#[test]
fn schema_is_the_generated_one() {
    let generated = Path::new(env!("CARGO_MANIFEST_DIR")).join("../web/src/document/generated/project.schema.json");
    assert_eq!(text("schema"), fs::read_to_string(generated).unwrap());
}

#[test]
fn completions_and_pages_name_all_commands() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = text(&format!("completions {shell}"));
        commands().iter().for_each(|name| assert!(script.contains(name), "{shell} does not know {name}"));
        assert!(script.contains("pixelated"), "{shell}");
    }
    let page = text("man");
    for name in commands() {
        assert!(page.contains(&format!("c2warp\\-{name}(1)")), "{name}");
        let page = text(&format!("man {name}"));
        assert!(page.starts_with(".ie") && page.contains(&format!("c2warp {name}")), "{name}");
    }
    let line = fail(Path::new("."), "man bend");
    assert!(line.starts_with("unknown command \"bend\": the commands are ") && line.contains("warp"), "{line}");
    for arguments in ["completions zsh", "man", "schema"] {
        succeed_with_closed_pipe(Path::new("."), arguments);
    }
}

#[test]
fn loss_of_a_rig_is_printed_as_json() {
    let folder = folder();
    let printed = succeed(folder.path(), "export cat.c2warp.json -o cat.glb --bones 12 --vertices 80 --json");
    let loss: Value = serde_json::from_slice(&printed).unwrap();
    assert_eq!(loss["influences"], 4);
    assert!((1..=12).contains(&loss["bones"].as_u64().unwrap()));
    assert!(loss["vertices"].as_u64().unwrap() <= 80);
    assert_eq!(loss["errors_px"]["clips"][0]["name"], "wave");
    let [pose, random] = ["pose", "random_poses"].map(|key| &loss["errors_px"][key]);
    for errors in [pose, random, &loss["errors_px"]["clips"][0]["vertices"], &loss["errors_px"]["between_vertices"]] {
        let [mean, largest] = ["mean", "largest"].map(|key| errors[key].as_f64().unwrap());
        assert!(0.0 <= mean && mean <= largest, "{errors}");
    }
    let Scene { project, .. } = Scene::named("gingerbread");
    assert!(loss["sites"].as_u64().unwrap() as usize >= project.handles.len());
}
