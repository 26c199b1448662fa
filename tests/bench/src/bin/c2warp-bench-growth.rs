//! `c2warp-bench-growth`: prints how time and memory of a solve grow, as tables, or those of one series by its name.

use std::{
    io::{self, Write},
    process::ExitCode,
    time::Instant,
};

use c2warp::{Error, Picture, Solver, project::Project};
use c2warp_bench::growth::{GROWTH, SIDE, Series, WORST};
use peak_alloc::PeakAlloc;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

fn main() -> ExitCode {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let rgba = vec![u8::MAX; (SIDE * SIDE) as usize * 4];
    let picture = Picture::new(SIDE as u32, SIDE as u32, &rgba).expect("a picture of allowed size");
    for (title, series) in [("Growth", GROWTH), ("Worst known", WORST)] {
        if writeln!(io::stdout(), "{title}\n").and_then(|()| table(series, &picture, &wanted)).is_err() {
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn table(series: &[Series], picture: &Picture<'_>, wanted: &[String]) -> io::Result<()> {
    let mut out = io::stdout();
    writeln!(out, "| things | number | sites | domain | sampling | regions | weights | pose | ms | peak MB |")?;
    writeln!(out, "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|")?;
    for Series { name, scene, counts } in series {
        if !wanted.is_empty() && !wanted.iter().any(|word| name.contains(word)) {
            continue;
        }
        for &count in *counts {
            let project = scene(count);
            HEAP.reset_peak_usage();
            let before = HEAP.current_usage();
            let start = Instant::now();
            let solved = solve(&project, picture);
            let ms = start.elapsed().as_secs_f64() * 1e3;
            let peak = (HEAP.peak_usage() - before) as f64 / 1e6;
            match solved {
                Ok((sites, times)) => {
                    let times = times.map(|ms| format!("{ms:.0}")).join(" | ");
                    writeln!(out, "| {name} | {count} | {sites} | {times} | {ms:.0} | {peak:.0} |")?;
                }
                Err(error) => writeln!(out, "| {name} | {count} | {error} | {ms:.0} | {peak:.0} |")?,
            }
        }
    }
    writeln!(out)
}

/// The number of sites, and the milliseconds of each stage and of the first pose.
fn solve(project: &Project, picture: &Picture<'_>) -> Result<(usize, [f64; 5]), Error> {
    let mut times = [0.0; 5];
    let mut solver = Solver::new();
    let mut start = Instant::now();
    let mut lap = || std::mem::replace(&mut start, Instant::now()).elapsed().as_secs_f64() * 1e3;
    solver.begin(project, picture)?;
    solver.advance()?;
    times[0] = lap();
    for time in &mut times[1..4] {
        solver.advance()?;
        *time = lap();
    }
    let solution = solver.into_solution().expect("every stage has run");
    let mut handles = project.handles.clone();
    if let Some(first) = handles.first_mut() {
        *first = first.clone().turned(30.0);
    }
    let _ = lap();
    solution.poser().pose(&handles, project.pose.blend)?;
    times[4] = lap();
    Ok((solution.sites().len(), times))
}
