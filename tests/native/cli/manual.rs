//! The examples of `web/docs/cli.md` print what the page shows.

use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use crate::command::{command, fail, succeed};

/// Stands for the end of a line in the page.
const CUT: char = '…';

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The fenced blocks of the manual in one language.
fn blocks(language: &str) -> Vec<String> {
    let manual = fs::read_to_string(root().join("web/docs/cli.md")).unwrap();
    let fence = format!("```{language}\n");
    manual.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap().to_owned()).collect()
}

/// A folder with the files that the manual makes.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    let samples = root().join("web/public/samples");
    fs::copy(samples.join("gingerbread.png"), folder.path().join("gingerbread.png")).unwrap();
    let project = fs::read_to_string(samples.join("gingerbread.c2warp.json")).unwrap();
    let raised = project.replace(r#""posed": [124, 516]"#, r#""posed": [160, 420]"#);
    fs::write(folder.path().join("wave.c2warp.json"), raised).unwrap();
    fs::write(folder.path().join("points.csv"), "x,y\n330,560\n512,700\n312,1126\n20,20\n").unwrap();
    let marks = r#"{"points": {"elbow": [330, 560], "beside": [100, 480]}}"#;
    fs::write(folder.path().join("marks.json"), marks).unwrap();
    folder
}

/// The page leaves out times, and the end of long lines.
fn assert_shown(printed: &str, shown: &str) {
    let printed: Vec<&str> = printed.lines().filter(|line| !line.starts_with("ms ")).collect();
    let shown: Vec<&str> = shown.lines().collect();
    assert_eq!(printed.len(), shown.len(), "{printed:#?}");
    for (printed, shown) in printed.into_iter().zip(shown) {
        match shown.split_once(CUT) {
            Some((start, _)) => assert!(printed.starts_with(start), "{printed} / {shown}"),
            None => assert_eq!(printed, shown),
        }
    }
}

#[test]
fn manual_shows_the_output_of_its_commands() {
    let folder = folder();
    let mut compared = 0;
    for block in blocks("console").iter().filter(|block| block.contains("/tmp/")) {
        let block = block.replace("/tmp/", "");
        let (first, shown) = block.split_once('\n').unwrap();
        let printed = String::from_utf8(succeed(folder.path(), first.strip_prefix("$ c2warp ").unwrap())).unwrap();
        match shown.strip_prefix("$ cat ").and_then(|rest| rest.split_once('\n')) {
            Some((table, shown)) => assert_shown(&fs::read_to_string(folder.path().join(table)).unwrap(), shown),
            None => assert_shown(&printed, shown),
        }
        compared += 1;
    }
    assert_eq!(compared, 7);
}

#[test]
fn manual_shows_the_message_of_a_rejection() {
    let folder = folder();
    let project = fs::read_to_string(folder.path().join("wave.c2warp.json")).unwrap();
    let hat = r#"{ "id": "hat", "kind": "point", "rest": [20, 20], "posed": [20, 20] }"#;
    let beside = project.replace(r#""handles": ["#, &format!(r#""handles": [ {hat},"#));
    fs::write(folder.path().join("beside.c2warp.json"), beside).unwrap();
    let line = fail(folder.path(), "inspect beside.c2warp.json");
    let blocks = blocks("console");
    let checked = command(folder.path(), "check beside.c2warp.json").output().unwrap();
    let printed = format!("$ c2warp check beside.c2warp.json\n{}", String::from_utf8(checked.stdout).unwrap());
    assert!(blocks.contains(&printed), "{printed}");
    let last = blocks.last().unwrap();
    assert_eq!(last.lines().nth(1).unwrap(), format!("c2warp: {line}"));
}
