//! The program: see the library of this package.

use std::process::ExitCode;

use c2warp_cli::Memory;

#[global_allocator]
static MEMORY: Memory = Memory;

fn main() -> ExitCode {
    c2warp_cli::run()
}
