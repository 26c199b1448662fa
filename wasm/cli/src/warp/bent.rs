//! A drawing with bent paths, as SVG.

use std::iter;
use std::path::Path;

use c2warp_vector::BentOptions;

use super::Arguments;
use crate::error::CliError;
use crate::output::Output;
use crate::project::LoadedProject;

/// Whether a path names an SVG file.
pub(super) fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg"))
}

/// Bends the drawing of a project, and writes it.
pub(super) fn run(arguments: &Arguments, loaded: &LoadedProject) -> Result<(), CliError> {
    let (posed, path) = (&arguments.drawing, &arguments.output);
    let of_pixels = [("--stmap", arguments.stmap.is_some()), ("--pixelated", posed.pixelated)];
    if let Some(&(option, _)) = of_pixels.iter().find(|(_, is_given)| *is_given) {
        return Err(CliError::OfPixels { option });
    }
    let drawing = loaded.drawing().ok_or_else(|| CliError::NoDrawing { path: path.clone() })?;
    let output = Output::open(path)?;
    let solution = loaded.solve()?;
    let pose = posed.pose(loaded, &solution)?;
    let options = BentOptions { scale: posed.scale, grow: posed.grow };
    let bent = drawing.bent(&solution.continued(&pose), loaded.picture()?.size(), options);
    let bent = bent.map_err(|reason| loaded.drawing_refused(reason))?;
    output.write(|writer| writer.write_all(bent.svg.as_bytes()))?;
    // Zero is subtracted from, so that no sign is printed before it.
    posed.print_origin(bent.origin.map(|start| 0.0 - posed.scale * start), iter::once(path.as_path()))
}
