//! The program: see the library of this package.

use std::process::ExitCode;

fn main() -> ExitCode {
    c2warp_cli::run()
}
