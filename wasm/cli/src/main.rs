//! The `c2warp` command: warps pictures, draws films, and reports weights, maps and distances.
//!
//! There is one file per subcommand. An error prints one line on standard error and exits with status 1. Output files
//! appear complete or not at all. An invalid command line prints the usage and exits with status 2.

mod animate;
mod bake;
mod carried;
mod distance;
mod error;
mod export;
mod fitting;
mod input;
mod inspect;
mod map;
mod maps;
mod output;
mod picture;
mod points;
mod posed_drawing;
mod project;
mod shapes;
mod shared;
mod warp;
mod weights;
mod workers;

use std::io;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use error::CliError;

#[derive(Parser)]
#[command(name = "c2warp", version, about = "Warps pictures with handles, and reports weights, maps and distances")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Warp(warp::Arguments),
    Animate(animate::Arguments),
    Inspect(inspect::Arguments),
    Weights(weights::Arguments),
    Map(map::Arguments),
    Maps(maps::Arguments),
    Distance(distance::Arguments),
    Bake(bake::Arguments),
    Export(export::Arguments),
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Warp(arguments) => warp::run(&arguments),
        Command::Animate(arguments) => animate::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Weights(arguments) => weights::run(&arguments),
        Command::Map(arguments) => map::run(&arguments),
        Command::Maps(arguments) => maps::run(&arguments),
        Command::Distance(arguments) => distance::run(&arguments),
        Command::Bake(arguments) => bake::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // A reader such as `head` has closed the output.
        Err(CliError::Print(reason) | CliError::Write { reason, .. }) if reason.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(CliError::Told) => ExitCode::FAILURE,
        Err(error) => {
            error::tell(error);
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::Arguments;

    #[test]
    fn command_line_definition_is_consistent() {
        Arguments::command().debug_assert();
    }
}
