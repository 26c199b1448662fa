//! `c2warp-bench-memory FILE`: writes the memory of a solve to a file, as JSON.
//!
//! It is a separate program because counting allocations takes time.

use std::{error::Error, fs, process::ExitCode};

use c2warp::Solver;
use c2warp_bench::{
    cases::{TABLE_2, gingerbread},
    results::Memory,
    suite::MANY_SITES,
};
use peak_alloc::PeakAlloc;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

fn main() -> ExitCode {
    let done = match &std::env::args().skip(1).collect::<Vec<_>>()[..] {
        [file] => memory().and_then(|memory| Ok(fs::write(file, serde_json::to_string(&memory)?)?)),
        _ => Err("usage: c2warp-bench-memory FILE".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("c2warp-bench-memory: {error}");
            ExitCode::FAILURE
        }
    }
}

fn memory() -> Result<Memory, Box<dyn Error>> {
    let case = gingerbread();
    let project = case.project(TABLE_2[1].samples, MANY_SITES);
    let picture = case.picture()?;
    let before = HEAP.current_usage();
    let mut solver = Solver::new();
    solver.begin(&project, &picture)?;
    // Ignore the peak of finding the outline. It depends on the picture, not on the samples.
    HEAP.reset_peak_usage();
    while solver.advance()?.is_some() {}
    let (held_bytes, peak_bytes) = (HEAP.current_usage() - before, HEAP.peak_usage() - before);
    let solution = solver.solution().expect("every stage has run");
    let virtual_sites = solution.sites().iter().filter(|site| !site.kind.is_real()).count();
    Ok(Memory { samples: solution.samples(), virtual_sites, held_bytes, peak_bytes })
}
