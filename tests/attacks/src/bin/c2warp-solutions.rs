//! Solves projects, one in each line of the standard input, on opaque pictures of their size.
//!
//! A line of the output has the hash of the weights, and the bits of the posed positions of a grid of points. If the
//! project is refused, it has the code of the error. `tests/browser/edits.spec.ts` compares it with WebAssembly.

use std::fmt::Write as _;
use std::io::{self, BufRead, Write};

use c2warp::glam::DVec2;
use c2warp::{Error, Picture, project::Project, solve};

/// Columns and rows of the grid.
const GRID: u32 = 6;

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let told = told(&line?).unwrap_or_else(|error| error.code().to_owned());
        writeln!(out, "{told}")?;
    }
    Ok(())
}

fn told(text: &str) -> Result<String, Error> {
    let project = Project::from_json(text)?;
    let (width, height) = (project.image.width, project.image.height);
    let rgba = vec![u8::MAX; width as usize * height as usize * 4];
    let solution = solve(&project, &Picture::new(width, height, &rgba)?)?;
    let pose = solution.pose(&project)?;
    let mut told = solution.report(&pose).weights_hash;
    for at in 0..GRID * GRID {
        let cell = DVec2::new(f64::from(at % GRID) + 0.5, f64::from(at / GRID) + 0.5) / f64::from(GRID);
        let posed = solution.map(&pose, cell * DVec2::new(width.into(), height.into()));
        let DVec2 { x, y } = posed.map_or(DVec2::NAN, |mapped| mapped.posed);
        write!(told, " {:016x} {:016x}", x.to_bits(), y.to_bits()).expect("text is written to memory");
    }
    Ok(told)
}
