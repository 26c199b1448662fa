//! `c2warp man`: manual pages for `man`.

use clap_mangen::Man;

use crate::error::CliError;
use crate::output;

/// Prints the manual page of the command, or of one of its commands
#[derive(Debug, clap::Args)]
#[command(after_help = "Example: the page that `man c2warp-warp` shows\n  \
                        c2warp man warp > ~/.local/share/man/man1/c2warp-warp.1")]
pub(crate) struct Arguments {
    /// A command, such as warp
    command: Option<String>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), CliError> {
    let mut all = crate::definition();
    all.build();
    let described = match &arguments.command {
        None => all.clone(),
        Some(name) => {
            let named = all.get_subcommands().find(|command| command.get_name() == name);
            // Man pages join names of commands by hyphens.
            let named = named.map(|command| command.clone().display_name(format!("c2warp-{name}")));
            named.ok_or_else(|| {
                let names = all.get_subcommands().map(|command| command.get_name().to_owned());
                CliError::NoCommand { name: name.clone(), names: names.filter(|name| name != "help").collect() }
            })?
        }
    };
    let mut page = Vec::new();
    Man::new(described).render(&mut page).map_err(CliError::Print)?;
    output::print(&page)
}
