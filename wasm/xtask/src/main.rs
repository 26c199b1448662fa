//! The build steps of c2warp that cargo does not perform: `cargo run -p xtask -- COMMAND`.

mod bindgen;
mod panic_places;
mod schema;
mod split;
mod typescript;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(about, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Builds the WebAssembly modules of pages and their glue, or other modules by options
    Bindgen {
        /// Builds quickly, and keeps the names of functions
        #[arg(long)]
        dev: bool,
        /// Writes the solver and the poser with the names of their functions into this folder, for `npm run sizes`
        #[arg(long, conflicts_with_all = ["dev", "package"])]
        named: Option<PathBuf>,
        /// Another crate to build instead
        #[arg(long, requires = "out")]
        package: Option<String>,
        /// The output folder, relative to the root of the repository
        #[arg(long, requires = "package")]
        out: Option<PathBuf>,
    },
    /// Writes the types and constants that the page shares with the solver into web/src/*/generated
    Schema {
        /// Writes nothing, and fails if the files are out of date
        #[arg(long)]
        check: bool,
    },
}

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let result = match Arguments::parse().command {
        Command::Bindgen { dev, named, package, out } => {
            let profile = if dev { bindgen::Profile::Dev } else { bindgen::Profile::Release };
            let built = match (&named, &package, &out) {
                (Some(output), ..) => bindgen::run(&root, &bindgen::measured_in(output), bindgen::Profile::Named),
                (None, Some(package), Some(output)) => {
                    let module = bindgen::Module { package, output, name: bindgen::SOLVER, later: &[] };
                    bindgen::run(&root, &[module], profile)
                }
                _ => bindgen::run(&root, &bindgen::page_modules(), profile),
            };
            built.map_err(|error| error.to_string())
        }
        Command::Schema { check } => schema::write(&root, check).map_err(|error| error.to_string()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error}");
            ExitCode::FAILURE
        }
    }
}
