//! The attacks on their corpora, and on mutations of these with a fixed seed.

mod mutation;

use std::fs;
use std::path::{Path, PathBuf};

use c2warp_attacks::{ATTACKS, Attack};
use c2warp_tests::Random;

use mutation::mutated;

/// Inputs of an attack by name. They are sorted, so that every run is the same.
fn corpus(name: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(name);
    let files = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let read = |path: PathBuf| (path.display().to_string(), fs::read(&path).expect("a file of the corpus"));
    let mut inputs: Vec<_> = files.map(|file| read(file.expect("a folder that can be listed").path())).collect();
    inputs.sort();
    inputs
}

/// Names the input that breaks a promise. The test shows it by the panic that follows.
fn run(attack: Attack, title: &str, bytes: &[u8]) {
    let result = std::panic::catch_unwind(|| attack(bytes));
    assert!(result.is_ok(), "{title}: {}", bytes.escape_ascii());
}

fn attack_with(name: &str, mutations: u64) {
    let (_, attack) = ATTACKS.into_iter().find(|&(of, _)| of == name).expect("an attack of this name");
    let corpus = corpus(name);
    for (file, bytes) in &corpus {
        run(attack, file, bytes);
    }
    let inputs: Vec<Vec<u8>> = corpus.into_iter().map(|(_, bytes)| bytes).collect();
    let mut random = Random(41);
    for number in 0..mutations {
        run(attack, &format!("mutation {number}"), &mutated(&inputs, &mut random));
    }
}

#[test]
fn any_text_is_a_project_or_refused() {
    attack_with("project", 300_000);
}

#[test]
fn any_rings_are_a_domain_or_refused() {
    attack_with("rings", 15_000);
}

#[test]
fn any_alpha_is_solved_or_refused() {
    attack_with("alpha", 1_500);
}

#[test]
fn any_handles_are_posed_or_refused() {
    attack_with("handles", 400);
}

#[test]
fn any_bytes_are_a_picture_or_refused() {
    attack_with("pictures", 20_000);
}

#[test]
fn any_text_is_a_drawing_or_refused() {
    attack_with("drawings", 5_000);
}
