//! The domain as square cells, with integer distances inside it.
//!
//! A unit is a fifth of a cell. Steps cost 5, 7 and 11 (Borgefors, "Distance transformations in digital images",
//! 1986): the error is at most 2 %. Integer sums are exact, so equal ways tie exactly, and mirrored domains have
//! mirrored distances.
//!
//! Cost: linear in the cells.

use glam::DVec2;

use crate::{
    domain::{Domain, cells_inside},
    rank::sort_by_rank,
};

/// Units per side of a cell.
pub(super) const UNITS: u32 = 5;
/// The distance of an unreachable cell.
pub(super) const FAR: u32 = u32::MAX;
/// Approximate number of cells that cover a domain.
const CELLS: f64 = 120_000.0;
/// Maximum number of cells that cover its bounding box.
const BOX_CELLS: f64 = 6e5;
/// Smallest useful cell of a picture, in pixels.
const LEAST_SIDE: f64 = 0.25;
/// Margin of empty cells around the domain, so that no step leaves the grid.
const MARGIN: usize = 2;
/// A number above the cost of each step.
const BUCKETS: u32 = 12;

/// A grid of cells, centred on the bounding box of a domain.
pub(super) struct Cells {
    /// Side of a cell in pixels.
    pub(super) side: f64,
    columns: usize,
    /// Centre of the first cell.
    first: DVec2,
    /// Whether the centre of a cell is in the domain.
    inside: Vec<bool>,
}

impl Cells {
    pub(super) fn new(domain: &Domain) -> Self {
        let (low, high) = domain.bounds();
        let size = high - low;
        let (fine, coarse) = ((domain.area() / CELLS).sqrt(), (size.x * size.y / BOX_CELLS).sqrt());
        let side = fine.max(coarse).max(LEAST_SIDE);
        let counts = (size / side).ceil().max(DVec2::ONE) + 2.0 * MARGIN as f64;
        let (columns, rows) = (counts.x as usize, counts.y as usize);
        let first = (low + high) / 2.0 - (counts - 1.0) * (side / 2.0);
        let inside = cells_inside(domain.rings(), [columns, rows], |p| (p - first) / side);
        let mut cells = Self { side, columns, first, inside };
        if coarse > fine {
            // Lines in a wide box may be thinner than a cell, and would fall apart.
            cells.add_outline(domain);
        }
        cells
    }

    /// Adds the cells that the outline passes, each of which shares a side with the next.
    fn add_outline(&mut self, domain: &Domain) {
        for ring in domain.rings() {
            let mut last = self.cell_of(ring[0]);
            for (at, &a) in ring.iter().enumerate() {
                let b = ring[(at + 1) % ring.len()];
                let steps = (a.distance(b) / self.side * 2.0).ceil().max(1.0);
                for step in 1..=steps as usize {
                    let cell = self.cell_of(a.lerp(b, step as f64 / steps));
                    let corner = cell / self.columns * self.columns + last % self.columns;
                    (self.inside[cell], self.inside[corner]) = (true, true);
                    last = cell;
                }
            }
        }
    }

    /// The cell that a point lies in. The point must be in the bounding box.
    fn cell_of(&self, p: DVec2) -> usize {
        let at = ((p - self.first) / self.side).round();
        at.y as usize * self.columns + at.x as usize
    }

    /// The cell of the domain nearest to a point, at most `reach` columns and rows from it. `None` if there is none.
    pub(super) fn inside_near(&self, p: DVec2, reach: i32) -> Option<usize> {
        let steps = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| DVec2::new(x.into(), y.into())));
        let around = steps.filter_map(|step| self.inside_at(p + step * self.side));
        let from_point = |&cell: &usize| self.centre(cell).distance_squared(p);
        around.min_by(|a, b| from_point(a).total_cmp(&from_point(b)))
    }

    /// The cells of the domain with their centre in a box.
    pub(super) fn inside_between(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = usize> + '_ {
        let cells = (0..self.len()).filter(|&cell| self.inside[cell]);
        cells.filter(move |&cell| {
            let p = self.centre(cell);
            p.cmpge(low).all() && p.cmple(high).all()
        })
    }

    /// The cell that a point lies in, if it is a cell of the domain.
    fn inside_at(&self, p: DVec2) -> Option<usize> {
        let at = ((p - self.first) / self.side).round();
        let rows = self.len() / self.columns;
        let is_in = at.cmpge(DVec2::ZERO).all() && at.x < self.columns as f64 && at.y < rows as f64;
        is_in.then(|| at.y as usize * self.columns + at.x as usize).filter(|&cell| self.inside[cell])
    }

    /// The cell on the other side of the vertical axis of the grid.
    pub(super) fn mirrored(&self, cell: usize) -> usize {
        let column = cell % self.columns;
        cell - column + (self.columns - 1 - column)
    }

    /// The cell on the vertical axis in the row of a cell.
    pub(super) fn on_axis(&self, cell: usize) -> usize {
        cell - cell % self.columns + self.columns / 2
    }

    /// The number of columns between a cell and the vertical axis.
    pub(super) fn columns_to_axis(&self, cell: usize) -> usize {
        (cell % self.columns).abs_diff(self.columns / 2)
    }

    pub(super) fn is_inside(&self, cell: usize) -> bool {
        self.inside[cell]
    }

    /// The share of the domain's cells whose mirror image is in the domain, too.
    pub(super) fn symmetry(&self) -> f64 {
        let cells = || (0..self.len()).filter(|&cell| self.inside[cell]);
        let both = cells().filter(|&cell| self.inside[self.mirrored(cell)]).count();
        both as f64 / cells().count().max(1) as f64
    }

    /// The middle of the wide part around a cell. Moves to the widest cell within half the distance to the outline.
    pub(super) fn widest_near(&self, clearance: &[u32], cell: usize) -> usize {
        let mut at = cell;
        loop {
            let distances = self.distances([(at, 0)], clearance[at] / 2);
            let around: Vec<usize> = (0..self.len()).filter(|&cell| distances[cell] != FAR).collect();
            let most = around.iter().map(|&cell| clearance[cell]).max().unwrap_or_default();
            if most <= clearance[at] {
                return at;
            }
            // Equally wide cells count alike, so that a symmetric part has its middle on the axis.
            let ties: Vec<usize> = around.into_iter().filter(|&cell| clearance[cell] == most).collect();
            at = self.central(&ties);
        }
    }

    /// The cell nearest to the mean of the given cells.
    pub(super) fn central(&self, of: &[usize]) -> usize {
        let mean = of.iter().map(|&cell| self.centre(cell)).sum::<DVec2>() / of.len() as f64;
        let from_mean = |&cell: &usize| self.centre(cell).distance_squared(mean);
        of.iter().copied().min_by(|a, b| from_mean(a).total_cmp(&from_mean(b))).expect("there is a cell")
    }

    pub(super) fn len(&self) -> usize {
        self.inside.len()
    }

    /// The centre of a cell, in pixels.
    pub(super) fn centre(&self, cell: usize) -> DVec2 {
        self.first + DVec2::new((cell % self.columns) as f64, (cell / self.columns) as f64) * self.side
    }

    /// Units in a distance in pixels.
    pub(super) fn units(&self, px: f64) -> u32 {
        (px / self.side * f64::from(UNITS)) as u32
    }

    /// Pixels in a distance in units.
    pub(super) fn px(&self, units: u32) -> f64 {
        f64::from(units) * self.side / f64::from(UNITS)
    }

    /// The cells of each connected part, from the largest part to the smallest. Equal parts follow each other from top
    /// to bottom.
    pub(super) fn parts(&self) -> Vec<Vec<usize>> {
        let mut is_open = self.inside.clone();
        let mut parts = Vec::new();
        for seed in 0..is_open.len() {
            if !std::mem::take(&mut is_open[seed]) {
                continue;
            }
            let mut part = vec![seed];
            let mut at = 0;
            while let Some(&cell) = part.get(at) {
                for next in [cell - self.columns, cell - 1, cell + 1, cell + self.columns] {
                    if std::mem::take(&mut is_open[next]) {
                        part.push(next);
                    }
                }
                at += 1;
            }
            sort_by_rank(&mut part, |&cell| [cell as i64, 0]);
            parts.push(part);
        }
        sort_by_rank(&mut parts, |part| [-(part.len() as i64), 0]);
        parts
    }

    /// For each cell, its distance to the outline.
    pub(super) fn clearance(&self) -> Vec<u32> {
        let is_edge = |&cell: &usize| {
            self.inside[cell]
                && [cell - self.columns, cell - 1, cell + 1, cell + self.columns].iter().any(|&next| !self.inside[next])
        };
        let edge: Vec<(usize, u32)> = (0..self.len()).filter(is_edge).map(|cell| (cell, UNITS.div_ceil(2))).collect();
        self.distances(edge, FAR)
    }

    /// Distances from sources, each with an initial distance. Distances greater than `bound` are [`FAR`].
    pub(super) fn distances(&self, sources: impl IntoIterator<Item = (usize, u32)>, bound: u32) -> Vec<u32> {
        let mut distances = vec![FAR; self.len()];
        self.shorten(&mut distances, sources, bound);
        distances
    }

    /// Reduces distances where a way from a source is shorter.
    pub(super) fn shorten(&self, distances: &mut [u32], sources: impl IntoIterator<Item = (usize, u32)>, bound: u32) {
        self.shorten_from(distances, sources.into_iter().collect(), bound);
    }

    /// The same for all kinds of sources, so that they share machine code.
    #[inline(never)]
    fn shorten_from(&self, distances: &mut [u32], mut sources: Vec<(usize, u32)>, bound: u32) {
        sources.retain(|&(_, from)| from <= bound);
        sort_by_rank(&mut sources, |&(_, from)| [-i64::from(from), 0]);
        let mut buckets: [Vec<usize>; BUCKETS as usize] = Default::default();
        let mut open = 0;
        let mut now = sources.last().map_or(0, |&(_, from)| from);
        while open > 0 || !sources.is_empty() {
            if open == 0 {
                now = sources.last().map_or(now, |&(_, from)| from.max(now));
            }
            while let Some(&(cell, from)) = sources.last().filter(|&&(_, from)| from <= now) {
                sources.pop();
                if from < distances[cell] {
                    distances[cell] = from;
                    buckets[(from % BUCKETS) as usize].push(cell);
                    open += 1;
                }
            }
            while let Some(cell) = buckets[(now % BUCKETS) as usize].pop() {
                open -= 1;
                if distances[cell] != now {
                    continue;
                }
                self.visit_steps(cell, |next, cost| {
                    let distance = now + cost;
                    if distance < distances[next] && distance <= bound {
                        distances[next] = distance;
                        buckets[(distance % BUCKETS) as usize].push(next);
                        open += 1;
                    }
                });
            }
            now += 1;
        }
    }

    /// Visits the cells that a straight step from a cell leads to, with its cost.
    fn visit_steps(&self, cell: usize, mut visit: impl FnMut(usize, u32)) {
        let w = self.columns;
        let is = |cell: usize| self.inside[cell];
        self.visit_neighbours(cell, &mut visit);
        // A long step passes between two cells.
        for (one, other, to) in [
            (cell - w, cell - w - 1, cell - 2 * w - 1),
            (cell - w, cell - w + 1, cell - 2 * w + 1),
            (cell - 1, cell - w - 1, cell - w - 2),
            (cell + 1, cell - w + 1, cell - w + 2),
            (cell - 1, cell + w - 1, cell + w - 2),
            (cell + 1, cell + w + 1, cell + w + 2),
            (cell + w, cell + w - 1, cell + 2 * w - 1),
            (cell + w, cell + w + 1, cell + 2 * w + 1),
        ] {
            if is(one) && is(other) && is(to) {
                visit(to, 11);
            }
        }
    }

    /// Visits the cells around a cell, with the cost of the step.
    pub(super) fn visit_neighbours(&self, cell: usize, mut visit: impl FnMut(usize, u32)) {
        let w = self.columns;
        let is = |cell: usize| self.inside[cell];
        for to in [cell - w, cell - 1, cell + 1, cell + w] {
            if is(to) {
                visit(to, UNITS);
            }
        }
        for (one, other, to) in [
            (cell - w, cell - 1, cell - w - 1),
            (cell - w, cell + 1, cell - w + 1),
            (cell + w, cell - 1, cell + w - 1),
            (cell + w, cell + 1, cell + w + 1),
        ] {
            if is(to) && (is(one) || is(other)) {
                visit(to, 7);
            }
        }
    }
}
