//! The `c2warp` command: warps pictures, draws films, and reports weights, maps and distances.
//!
//! There is one file per subcommand. An error prints one line on standard error and exits with status 1. Output files
//! appear complete or not at all. An invalid command line prints the usage and exits with status 2.

mod animate;
mod bake;
mod carried;
mod check;
mod completions;
mod distance;
mod error;
mod export;
mod files;
mod fitting;
mod input;
mod inspect;
mod man;
mod map;
mod maps;
mod memory;
mod new;
mod output;
mod picture;
mod png_chunks;
mod png_file;
mod points;
mod posed_drawing;
mod progress;
mod project;
mod schema;
mod shapes;
mod shared;
mod signals;
mod warp;
mod weights;
mod workers;

use std::io;
use std::path::Path;
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use error::CliError;
#[doc(hidden)]
pub use memory::Memory;

#[derive(Parser)]
#[command(name = "c2warp", version, about = "Warps pictures with handles, and reports weights, maps and distances")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Warp(warp::Arguments),
    Animate(animate::Arguments),
    Inspect(inspect::Arguments),
    Weights(weights::Arguments),
    Map(map::Arguments),
    Maps(maps::Arguments),
    Distance(distance::Arguments),
    Bake(bake::Arguments),
    Export(export::Arguments),
    Schema(schema::Arguments),
    Completions(completions::Arguments),
    Man(man::Arguments),
}

/// The definition of the command line, for programs that describe it.
fn definition() -> clap::Command {
    Arguments::command()
}

/// Runs the command line of this process.
#[must_use]
pub fn run() -> ExitCode {
    enter_folder();
    error::print_panics();
    signals::begin();
    let command = Arguments::parse().command;
    progress::begin();
    let result = match command {
        Command::New(arguments) => new::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Warp(arguments) => warp::run(arguments),
        Command::Animate(arguments) => animate::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Weights(arguments) => weights::run(&arguments),
        Command::Map(arguments) => map::run(&arguments),
        Command::Maps(arguments) => maps::run(&arguments),
        Command::Distance(arguments) => distance::run(&arguments),
        Command::Bake(arguments) => bake::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
        Command::Schema(_) => schema::run(),
        Command::Completions(arguments) => completions::run(&arguments),
        Command::Man(arguments) => man::run(&arguments),
    };
    progress::clear();
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // A reader such as `head` has closed the output.
        Err(CliError::Print(reason) | CliError::Write { reason, .. }) if reason.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(CliError::Reported) => ExitCode::FAILURE,
        Err(error) => {
            error::print(error);
            ExitCode::FAILURE
        }
    }
}

/// Reads the bytes of a picture file as the command does, for tests of damaged files.
///
/// # Errors
/// The line that the command would print.
#[doc(hidden)]
pub fn read_picture(bytes: &[u8]) -> Result<image::RgbaImage, String> {
    picture::read_from(bytes, Path::new("picture"), None).map(|file| file.pixels).map_err(|error| error.to_string())
}

/// As WebAssembly, the program starts in the root folder. Relative paths are relative to the caller's folder.
fn enter_folder() {
    if cfg!(target_os = "wasi")
        && let Some(folder) = std::env::var_os("PWD")
    {
        // If that fails, the error of the first path names it.
        let _ = std::env::set_current_dir(folder);
    }
}

#[cfg(test)]
mod tests {
    use super::definition;

    #[test]
    fn command_line_definition_is_consistent() {
        definition().debug_assert();
    }
}
