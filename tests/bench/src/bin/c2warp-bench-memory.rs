//! `c2warp-bench-memory FILE`: writes to a file, as JSON, what a solve holds in memory.
//!
//! A program of its own, since counting takes time.

use std::{error::Error, fs, process::ExitCode};

use c2warp::Solver;
use c2warp_bench::{
    cases::{TABLE_2, gingerbread},
    results::Memory,
    suite::DENSE,
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
    let scene = gingerbread();
    let project = scene.project(TABLE_2[1].samples, DENSE);
    let picture = scene.picture()?;
    let before = HEAP.current_usage();
    let mut solver = Solver::new();
    solver.begin(&project, &picture)?;
    // What finding the outline in the picture takes for a moment depends on the picture, not on the samples.
    HEAP.reset_peak_usage();
    while solver.advance()?.is_some() {}
    let (held_bytes, peak_bytes) = (HEAP.current_usage() - before, HEAP.peak_usage() - before);
    let solution = solver.solution().expect("every stage has run");
    let virtual_sites = solution.sites().iter().filter(|site| !site.kind.is_real()).count();
    Ok(Memory { samples: solution.samples(), virtual_sites, held_bytes, peak_bytes })
}
