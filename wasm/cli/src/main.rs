//! The `c2warp` command: warps pictures, and answers questions about a warp.
//!
//! One file per subcommand. An error is one line on standard error and exit status 1; output files appear complete or not at
//! all. An invalid command line prints its usage, and ends with exit status 2.

mod distance;
mod error;
mod input;
mod inspect;
mod jpeg;
mod map;
mod number;
mod output;
mod picture;
mod points;
mod profile;
mod scene;
mod stmap;
mod warp;
mod weights;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use error::CliError;

#[derive(Parser)]
#[command(name = "c2warp", version, about = "Warps pictures by their handles, and answers questions about a warp")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Warp(warp::Arguments),
    Inspect(inspect::Arguments),
    Weights(weights::Arguments),
    Map(map::Arguments),
    Distance(distance::Arguments),
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Warp(arguments) => warp::run(&arguments),
        Command::Inspect(arguments) => inspect::run(&arguments),
        Command::Weights(arguments) => weights::run(&arguments),
        Command::Map(arguments) => map::run(&arguments),
        Command::Distance(arguments) => distance::run(&arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        // The reader of the output has closed it, as `head` does.
        Err(CliError::Print(reason) | CliError::Write { reason, .. }) if reason.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            let line = one_line(&error.to_string());
            // Standard error may be closed as well, and then there is nowhere to report.
            let _ = writeln!(io::stderr(), "c2warp: {line}");
            ExitCode::FAILURE
        }
    }
}

/// A message on one line, without control characters that would affect the terminal.
fn one_line(message: &str) -> String {
    let words = message.split_whitespace().map(|word| word.replace(char::is_control, "\u{fffd}"));
    words.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::{Arguments, one_line};

    #[test]
    fn a_message_is_one_line_without_control_characters() {
        assert_eq!(one_line("handle \"\u{1b}[31mred\n x\0\": gone"), "handle \"\u{fffd}[31mred x\u{fffd}\": gone");
    }

    #[test]
    fn the_arguments_contradict_each_other_nowhere() {
        Arguments::command().debug_assert();
    }
}
