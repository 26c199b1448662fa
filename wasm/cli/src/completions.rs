//! `c2warp completions`: a script that lets a shell complete the command line.

use clap_complete::Shell;

use crate::error::CliError;
use crate::output;

/// Prints a script that lets a shell complete commands and options
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: completions for bash, in each new shell of this user\n  \
                        c2warp completions bash > ~/.local/share/bash-completion/completions/c2warp")]
pub(crate) struct Arguments {
    /// The shell
    shell: Shell,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut crate::definition(), "c2warp", &mut script);
    output::print(&script)
}
