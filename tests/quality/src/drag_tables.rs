//! The printed tables of drags, in Markdown.

use c2warp_bench::{aligned::aligned, drag::exceeded_by};

use crate::{
    distances::greatest,
    drags::{Dragged, FRAMES, SampleDrags},
    requirements::LARGEST_MOVE,
    tables::{NONE, digits, percent},
};

const DRAG_NOTES: &str = "
Handles of the editor's samples are dragged from rest through the middle of the picture and beyond, and back. The
figures are the worst of all drags and frames. Move: the largest move of a vertex in a frame, over that of the handle,
for drags of 25, 100 and 400 frames in each direction. Folded: triangles that are turned over, by area. From home: the
largest distance from rest after the release at home. In a crossing, the handle passes another one closer than the width
of a cell.
";

const HELD_NOTES: &str = "
Energies E of the poses after the release at the ends of these drags, over the optimum on a mesh of about 3,000 samples.
Exact: Jacobians of the map at the centres of triangles. Mesh: the piecewise linear map, like the optimum. Found: poses
whose optimum was found. Folds: triangles turned over.
";

const TIME_NOTES: &str = "
Milliseconds on one core. Frames are those of drags with 100 frames. The first pose, from rest, and the release are at
the end of a drag: each is the minimum of some runs, and the median of the drags. Harmonic: the same pose in the harmonic
mode.
";

const RELEASED_NOTES: &str = "
The energy of exact Jacobians after the release at the end of a drag, over the least known one. Known are the releases
after 25, 100 and 400 frames, the pose from rest, and the pose at rest near the optimum.
";

/// Formats the results of drags.
#[must_use]
pub fn drag_tables(all: &[SampleDrags]) -> String {
    [
        ("Drags", drag_table(all), DRAG_NOTES),
        ("Held poses", held_table(all), HELD_NOTES),
        ("Times of drags", time_table(all), TIME_NOTES),
        ("Released drags", released_table(all), RELEASED_NOTES),
    ]
    .map(|(title, table, notes)| format!("## {title}\n\n{table}{notes}\n"))
    .concat()
}

fn drag_table(all: &[SampleDrags]) -> String {
    let moves = FRAMES.map(|frames| format!("move, {frames} frames"));
    let over = format!("drags over {LARGEST_MOVE}");
    let header =
        ["picture", "drags", &moves[0], &moves[1], &moves[2], &over, "drags with folds", "folded", "from home, px"];
    let row = |picture: &str, kind: &str, drags: &[&Dragged]| {
        let worst = |of: &dyn Fn(&Dragged) -> f64| digits(greatest(drags.iter().map(|drag| of(drag))));
        let count = |of: &dyn Fn(&Dragged) -> bool| drags.iter().filter(|drag| of(drag)).count().to_string();
        vec![
            format!("{picture}{kind}"),
            drags.len().to_string(),
            worst(&|drag| drag.largest_moves[0]),
            worst(&|drag| drag.largest_moves[1]),
            worst(&|drag| drag.largest_moves[2]),
            count(&|drag| drag.largest_move() > LARGEST_MOVE),
            count(&|drag| drag.folded > 0.0),
            percent(greatest(drags.iter().map(|drag| drag.folded))),
            worst(&|drag| drag.from_home),
        ]
    };
    let rows = all.iter().flat_map(|sample| {
        let (crossing, free): (Vec<&Dragged>, Vec<&Dragged>) = sample.drags.iter().partition(|drag| drag.is_crossing);
        let kinds = [("", free), (", crossing", crossing)].into_iter().filter(|(_, drags)| !drags.is_empty());
        kinds.map(|(kind, drags)| row(&sample.picture, kind, &drags)).collect::<Vec<_>>()
    });
    aligned(&header, rows, 1)
}

fn held_table(all: &[SampleDrags]) -> String {
    let header = ["picture", "poses", "found", "exact, median", "worst", "mesh, median", "worst", "folds"];
    let row = |SampleDrags { picture, drags, .. }: &SampleDrags| {
        let exact: Vec<f64> = drags.iter().filter_map(|drag| drag.held.exact).collect();
        let on_mesh: Vec<f64> = drags.iter().filter_map(|drag| drag.held.on_mesh).collect();
        let folds: usize = drags.iter().map(|drag| drag.held.folds).sum();
        let [exact_median, exact_worst] = median_and_worst(&exact);
        let [mesh_median, mesh_worst] = median_and_worst(&on_mesh);
        let counts = [drags.len(), exact.len()].map(|count| count.to_string());
        let ratios = [exact_median, exact_worst, mesh_median, mesh_worst, folds.to_string()];
        std::iter::once(picture.clone()).chain(counts).chain(ratios).collect()
    };
    aligned(&header, all.iter().map(row), 1)
}

fn time_table(all: &[SampleDrags]) -> String {
    let header = ["picture", "sites", "frame, median", "99 %", "first pose", "release", "harmonic", "frame ÷ harmonic"];
    let row = |SampleDrags { picture, sites, times, .. }: &SampleDrags| {
        let ms = [times.frame, times.slow_frame, times.first, times.settle, times.harmonic];
        let figures = ms.into_iter().chain([times.frame / times.harmonic]).map(digits);
        [picture.clone(), sites.to_string()].into_iter().chain(figures).collect()
    };
    aligned(&header, all.iter().map(row), 1)
}

fn released_table(all: &[SampleDrags]) -> String {
    let row = |SampleDrags { picture, drags, .. }: &SampleDrags| {
        let ratios: Vec<f64> = drags.iter().flat_map(|drag| drag.released).collect();
        let count = ratios.len().to_string();
        [picture.clone(), count].into_iter().chain(median_and_worst(&ratios)).collect()
    };
    aligned(&["picture", "releases", "median", "worst"], all.iter().map(row), 1)
}

fn median_and_worst(values: &[f64]) -> [String; 2] {
    if values.is_empty() {
        return [NONE, NONE].map(str::to_owned);
    }
    [exceeded_by(0.5, values), greatest(values.iter().copied())].map(digits)
}
