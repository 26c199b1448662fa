//! `c2warp schema`: the JSON schema of the project file.

use crate::error::CliError;
use crate::output;

/// Generated from the types that read a project.
const SCHEMA: &str = include_str!("../../../web/src/document/generated/project.schema.json");

/// Prints the JSON schema of the project file, for editors and validators
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: a file that an editor such as VS Code completes and checks projects by\n  \
                        c2warp schema > project.schema.json")]
pub(crate) struct Arguments {}

pub(crate) fn run() -> Result<(), CliError> {
    output::print(SCHEMA.as_bytes())
}
