//! Prints how much each handle moves each point of a grid, as CSV:
//!
//! ```sh
//! cargo run --release -p c2warp --example weights -- cat.c2warp.json 40 > weights.csv
//! ```

mod opened;

use std::env;
use std::error::Error;
use std::io::{self, Write};
use std::path::Path;

use c2warp::project::Project;
use c2warp::site::SiteKind;
use c2warp::{Picture, Solution, solve};
use glam::DVec2;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = env::args().skip(1).collect();
    match &*given {
        [project, step] => write_weights(project.as_ref(), step.parse()?, &mut io::stdout().lock()),
        _ => Err("expected: PROJECT STEP".into()),
    }
}

/// Writes a line for each point of a grid that lies in the picture.
fn write_weights(project: &Path, step: u32, output: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let (project, picture) = opened::open(project)?;
    let picture = Picture::new(picture.width(), picture.height(), &picture)?;
    let solution = solve(&project, &picture)?;
    let names: Vec<&str> = project.handles.iter().map(|handle| &*handle.id).collect();
    writeln!(output, "x,y,{}", names.join(","))?;
    for y in (step / 2..project.image.height).step_by(step as usize) {
        for x in (step / 2..project.image.width).step_by(step as usize) {
            let at = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
            let Some(weights) = weights_of_handles(&project, &solution, at) else { continue };
            let cells: Vec<String> = weights.iter().map(|weight| format!("{weight:.4}")).collect();
            writeln!(output, "{},{},{}", at.x, at.y, cells.join(","))?;
        }
    }
    Ok(())
}

/// The weight of each handle, in the order of the project; `None` outside the picture. They sum to 1.
///
/// A point follows sites near it (eq. 2), and virtual sites among them follow the handles around them (eq. 4).
fn weights_of_handles(project: &Project, solution: &Solution, at: DVec2) -> Option<Vec<f64>> {
    let mut weights = vec![0.0; project.handles.len()];
    for (site, weight) in solution.weights_at(at)? {
        for (real, part) in solution.harmonic_weights(site) {
            match solution.sites()[real].kind {
                SiteKind::Point { handle } | SiteKind::Bone { handle, .. } => {
                    weights[handle as usize] += weight * part;
                }
                // The held boundary is no handle, and moves nothing.
                _ => {}
            }
        }
    }
    Some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_one_and_are_greatest_at_their_handle() -> Result<(), Box<dyn Error>> {
        let mut table = Vec::new();
        write_weights(&opened::sample("gingerbread.c2warp.json"), 64, &mut table)?;
        let table = String::from_utf8(table)?;
        let mut lines = table.lines();
        assert_eq!(lines.next(), Some("x,y,head,left-hand,right-hand,left-foot,right-foot"));
        let rows: Vec<Vec<f64>> =
            lines.map(|line| line.split(',').map(str::parse).collect()).collect::<Result<_, _>>()?;
        assert!(rows.len() > 50);
        assert!(rows.iter().all(|row| (row[2..].iter().sum::<f64>() - 1.0).abs() < 1e-3));
        let distance = |row: &[f64]| (row[0] - 124.0).hypot(row[1] - 516.0);
        let nearest = rows.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).ok_or("no rows")?;
        assert!(nearest[2..].iter().all(|&weight| weight <= nearest[3]), "{nearest:?}");
        Ok(())
    }
}
