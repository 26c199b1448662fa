//! Draws the weight of a handle as an SVG: isolines at every tenth, over the outline of the picture.
//!
//! ```sh
//! cargo run --release -p c2warp --example isolines -- cat.c2warp.json tail > tail.svg
//! ```

mod opened;

use std::env;
use std::error::Error;
use std::io::{self, Write};
use std::path::Path;

use c2warp::site::SiteKind;
use c2warp::{Picture, Solution, solve};
use glam::DVec2;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = env::args().skip(1).collect();
    match &*given {
        [project, handle] => write_isolines(project.as_ref(), handle, &mut io::stdout().lock()),
        _ => Err("expected: PROJECT HANDLE".into()),
    }
}

fn write_isolines(project: &Path, handle: &str, output: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let (project, picture) = opened::open(project)?;
    let number = project.handles.iter().position(|one| one.id == handle).ok_or("unknown handle")?;
    let picture = Picture::new(picture.width(), picture.height(), &picture)?;
    let solution = solve(&project, &picture)?;
    let weights = weights_at_vertices(&solution, number);
    let (width, height) = (project.image.width, project.image.height);
    writeln!(output, r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" fill="none">"#)?;
    for ring in solution.domain().rings() {
        let path: Vec<String> = ring.iter().map(|corner| point(*corner)).collect();
        writeln!(output, r##"<path d="M{}Z" stroke="#888" stroke-width="2"/>"##, path.join("L"))?;
    }
    for tenth in 1..10 {
        let level = f64::from(tenth) / 10.0;
        let path = isoline(&solution, &weights, level).concat();
        writeln!(output, r##"<path d="{path}" stroke="#2558e8" stroke-opacity="{level}" stroke-width="3"/>"##)?;
    }
    writeln!(output, "</svg>")?;
    Ok(())
}

/// How much a handle moves each vertex of the mesh: directly, and by the virtual sites that follow it.
fn weights_at_vertices(solution: &Solution, handle: usize) -> Vec<f64> {
    let is_its = |site: usize| match solution.sites()[site].kind {
        SiteKind::Point { handle: of } | SiteKind::Bone { handle: of, .. } => of as usize == handle,
        _ => false,
    };
    let share = |site| -> f64 {
        let parts = solution.harmonic_weights(site).filter(|&(real, _)| is_its(real));
        parts.map(|(_, part)| part).sum()
    };
    let shares: Vec<f64> = (0..solution.sites().len()).map(share).collect();
    let weight = |vertex| solution.weights().row(vertex).map(|(site, weight)| weight * shares[site]).sum();
    (0..solution.samples()).map(weight).collect()
}

/// A straight segment for each triangle that the level crosses.
fn isoline(solution: &Solution, weights: &[f64], level: f64) -> Vec<String> {
    let vertices = solution.vertices();
    let crossing = |a: u32, b: u32| {
        let (a, b) = (a as usize, b as usize);
        let (from, to) = (weights[a] - level, weights[b] - level);
        ((from < 0.0) != (to < 0.0)).then(|| vertices[a].lerp(vertices[b], from / (from - to)))
    };
    let piece = |&[a, b, c]: &[u32; 3]| {
        let ends: Vec<DVec2> = [(a, b), (b, c), (c, a)].into_iter().filter_map(|(a, b)| crossing(a, b)).collect();
        (ends.len() == 2).then(|| format!("M{}L{}", point(ends[0]), point(ends[1])))
    };
    let inside = solution.triangles().iter().filter(|corners| corners.iter().all(|&at| (at as usize) < weights.len()));
    inside.filter_map(piece).collect()
}

fn point(p: DVec2) -> String {
    format!("{:.1} {:.1}", p.x, p.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nine_isolines_lie_on_the_way_from_the_hand() -> Result<(), Box<dyn Error>> {
        let mut drawing = Vec::new();
        write_isolines(&opened::sample("gingerbread.c2warp.json"), "left-hand", &mut drawing)?;
        let drawing = String::from_utf8(drawing)?;
        let paths: Vec<&str> = drawing.lines().filter(|line| line.contains("#2558e8")).collect();
        assert_eq!(paths.len(), 9);
        let mean_x = |path: &str| -> f64 {
            let starts = path.split('M').skip(1).filter_map(|piece| piece.split(' ').next()?.parse::<f64>().ok());
            let starts: Vec<f64> = starts.collect();
            starts.iter().sum::<f64>() / starts.len() as f64
        };
        // The hand is at the left: higher weights lie nearer to it.
        let places: Vec<f64> = paths.iter().map(|path| mean_x(path)).collect();
        assert!(places.iter().all(|x| x.is_finite()));
        assert!(places.is_sorted_by(|a, b| a > b), "{places:?}");
        Ok(())
    }
}
