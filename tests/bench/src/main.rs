//! `c2warp-bench`: runs the benchmark natively, or prints its tables.
//!
//! - Without arguments it runs and prints the tables of this run.
//! - `--json FILE` runs and writes the times to a file.
//! - `--tables FOLDER` prints the tables of `native.json`, and of `wasm.json` and `memory.json` if they exist.

use std::{
    error::Error,
    fs,
    io::{self, Write},
    path::Path,
    process::ExitCode,
};

use c2warp_bench::{
    clock::native_ms,
    results::{Results, Timings},
    suite::Suite,
    tables::tables,
};
use serde::de::DeserializeOwned;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match words[..] {
        [] => timings().and_then(|native| print(&Results { native, wasm: None, memory: None })),
        ["--json", file] => timings().and_then(|native| Ok(fs::write(file, serde_json::to_string(&native)?)?)),
        ["--tables", folder] => read(Path::new(folder)).and_then(|results| print(&results)),
        _ => Err("usage: c2warp-bench [--json FILE | --tables FOLDER]".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("c2warp-bench: {error}");
            ExitCode::FAILURE
        }
    }
}

fn timings() -> Result<Timings, Box<dyn Error>> {
    Ok(Suite::full(native_ms).timings(|case| eprintln!("  {case}"))?)
}

fn read(folder: &Path) -> Result<Results, Box<dyn Error>> {
    let native = json(&folder.join("native.json"))?.ok_or("native.json is missing")?;
    Ok(Results { native, wasm: json(&folder.join("wasm.json"))?, memory: json(&folder.join("memory.json"))? })
}

/// Reads a JSON file. Returns `None` if it does not exist.
fn json<T: DeserializeOwned>(file: &Path) -> Result<Option<T>, Box<dyn Error>> {
    match fs::read_to_string(file) {
        Ok(text) => Ok(Some(serde_json::from_str(&text).map_err(|reason| format!("{}: {reason}", file.display()))?)),
        Err(reason) if reason.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(reason) => Err(format!("{}: {reason}", file.display()).into()),
    }
}

fn print(results: &Results) -> Result<(), Box<dyn Error>> {
    Ok(io::stdout().write_all(tables(results).as_bytes())?)
}
