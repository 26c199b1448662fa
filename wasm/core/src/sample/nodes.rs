//! The lattice nodes inside a domain, in runs of consecutive nodes of a row.
//!
//! Cost: O(n + c log c) for n nodes inside and c crossings of the outline with rows, and the nodes around each segment.
//! Space between islands is free.

use std::ops::Range;

use glam::DVec2;

use super::lattice::{LATTICE_CLEARANCE, Lattice};
use crate::{domain::Domain, segment::segment_distance};

/// Consecutive nodes of a row.
#[derive(Debug)]
pub(super) struct Run {
    row: usize,
    columns: Range<usize>,
    /// The number of its first node.
    first: usize,
}

/// A row with its runs, from left to right.
#[derive(Debug)]
struct Row {
    row: usize,
    runs: Range<usize>,
}

/// The runs of a lattice. Their nodes are numbered run by run. The numbers before and after each run belong to no node,
/// so a step to the left or right of a node always leads to a number.
#[derive(Debug)]
struct Runs {
    lattice: Lattice,
    runs: Vec<Run>,
    /// The rows that have runs, ascending. They are stored sparsely, because a domain may be a few specks in a large
    /// box.
    rows: Vec<Row>,
}

impl Runs {
    /// The rows whose y may be between two numbers.
    fn rows_within(&self, low: f64, high: f64) -> impl Iterator<Item = &Row> {
        let rows = self.lattice.rows_within(low, high);
        let first = self.rows.partition_point(|row| row.row < rows.start);
        self.rows[first..].iter().take_while(move |row| row.row < rows.end)
    }

    /// The nodes of a row whose x may be between two numbers: runs, and columns of each.
    fn pieces(&self, row: &Row, low: f64, high: f64) -> impl Iterator<Item = (&Run, Range<usize>)> {
        let columns = self.lattice.columns_within(row.row, low, high);
        let (start, end) = (columns.start, columns.end);
        let runs = &self.runs[row.runs.clone()];
        let first = runs.partition_point(|run| run.columns.end <= start);
        let touched = runs[first..].iter().take_while(move |run| run.columns.start < end);
        touched.map(move |run| (run, start.max(run.columns.start)..end.min(run.columns.end)))
    }
}

/// A triangle between three nodes. Its base is an edge along a row.
pub(super) struct NodeTriangle {
    /// The number of the node at the left end of the base.
    pub(super) base: usize,
    /// The number of the other node.
    pub(super) apex: usize,
    /// Whether the apex is in the next row, not in the previous one.
    pub(super) is_below: bool,
    /// Steps from the top left corner of the lattice: half a spacing to the right, or a row down.
    pub(super) step: usize,
}

/// The lattice nodes inside a domain.
#[derive(Debug)]
pub(super) struct Nodes {
    runs: Runs,
    /// For each number, whether it belongs to a node that keeps its clearance.
    is_node: Vec<bool>,
}

impl Nodes {
    /// The nodes that keep their clearance from the outline's `segments` and from bones.
    pub(super) fn new(
        domain: &Domain,
        bones: &[[DVec2; 2]],
        spacing: f64,
        vertices: &[DVec2],
        segments: &[[usize; 2]],
    ) -> Self {
        let mut nodes = Self::inside(domain, spacing);
        let clearance = LATTICE_CLEARANCE * spacing;
        for &[a, b] in segments {
            nodes.clear_around(vertices[a], vertices[b], clearance);
        }
        for &[a, b] in bones {
            nodes.clear_around(a, b, clearance);
        }
        nodes
    }

    /// The nodes inside a domain by the even-odd rule: those between the crossings of each row with the outline.
    fn inside(domain: &Domain, spacing: f64) -> Self {
        let lattice = Lattice::new(domain, spacing);
        let mut crossings: Vec<(usize, f64)> = Vec::new();
        for (a, b) in domain.edges() {
            let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
            for row in lattice.rows_within(low.y, high.y) {
                let y = lattice.node(row, 0).y;
                if low.y <= y && y < high.y {
                    crossings.push((row, low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x)));
                }
            }
        }
        crossings.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let mut nodes = Self { runs: Runs { lattice, runs: Vec::new(), rows: Vec::new() }, is_node: vec![false] };
        for of_row in crossings.chunk_by(|a, b| a.0 == b.0) {
            let (row, first) = (of_row[0].0, nodes.runs.runs.len());
            of_row.chunks_exact(2).for_each(|span| nodes.push_span(row, first, span[0].1, span[1].1));
            let runs = first..nodes.runs.runs.len();
            if !runs.is_empty() {
                nodes.runs.rows.push(Row { row, runs });
            }
        }
        nodes
    }

    /// Adds the nodes of a row between two crossings. The runs of the row begin with `first`.
    fn push_span(&mut self, row: usize, first: usize, low: f64, high: f64) {
        let Self { runs: Runs { lattice, runs, .. }, is_node } = self;
        let columns = within(lattice, row, lattice.columns_within(row, low, high), low, high);
        if columns.is_empty() {
            return;
        }
        match runs[first..].last_mut() {
            // No node lies between the two spans.
            Some(last) if last.columns.end == columns.start => {
                is_node.pop();
                last.columns.end = columns.end;
            }
            _ => runs.push(Run { row, columns: columns.clone(), first: is_node.len() }),
        }
        is_node.resize(is_node.len() + columns.len(), true);
        is_node.push(false);
    }

    /// Removes the nodes closer to a segment than `clearance`.
    fn clear_around(&mut self, a: DVec2, b: DVec2, clearance: f64) {
        let Self { runs, is_node } = self;
        let (low, high) = (a.min(b) - clearance, a.max(b) + clearance);
        for row in runs.rows_within(low.y, high.y) {
            for (run, columns) in runs.pieces(row, low.x, high.x) {
                for column in columns {
                    if segment_distance(runs.lattice.node(run.row, column), a, b) < clearance {
                        is_node[run.number(column)] = false;
                    }
                }
            }
        }
    }

    pub(super) fn lattice(&self) -> &Lattice {
        &self.runs.lattice
    }

    /// One more than the maximum number.
    pub(super) fn numbers(&self) -> usize {
        self.is_node.len()
    }

    /// Whether a number is that of a node.
    pub(super) fn is_node(&self, number: usize) -> bool {
        self.is_node[number]
    }

    /// Number and position of each node, row by row from left to right.
    pub(super) fn positions(&self) -> impl Iterator<Item = (usize, DVec2)> {
        let Self { runs: Runs { lattice, runs, .. }, is_node } = self;
        let of_run = move |run: &'_ Run| {
            let (row, first) = (run.row, run.first);
            run.columns.clone().zip(first..).map(move |(column, number)| (number, lattice.node(row, column)))
        };
        runs.iter().flat_map(of_run).filter(|&(number, _)| is_node[number])
    }

    /// Number, row and column of the positions on runs that may lie in a box.
    pub(super) fn in_box(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = (usize, usize, usize)> {
        let pieces = self.runs.rows_within(low.y, high.y).flat_map(move |row| self.runs.pieces(row, low.x, high.x));
        pieces.flat_map(|(run, columns)| columns.map(|column| (run.number(column), run.row, column)))
    }

    /// Calls `visit` with the numbers of the positions in a convex region, part of a row at a time. The region lies
    /// between two y, and a horizontal line crosses it between the two x that `span` returns.
    pub(super) fn visit_spans(
        &self,
        low: f64,
        high: f64,
        span: impl Fn(f64) -> Option<[f64; 2]>,
        mut visit: impl FnMut(Range<usize>),
    ) {
        let lattice = self.lattice();
        for row in self.runs.rows_within(low, high) {
            let Some([left, right]) = span(lattice.node(row.row, 0).y) else { continue };
            for (run, columns) in self.runs.pieces(row, left, right) {
                let columns = within(lattice, row.row, columns, left, right);
                if !columns.is_empty() {
                    visit(run.number(columns.start)..run.number(columns.start) + columns.len());
                }
            }
        }
    }

    /// Calls `visit` with each triangle between three nodes.
    pub(super) fn visit_triangles(&self, mut visit: impl FnMut(NodeTriangle)) {
        let Runs { runs, rows, .. } = &self.runs;
        for pair in rows.windows(2).filter(|pair| pair[0].row + 1 == pair[1].row) {
            let (mut upper, mut lower) = (&runs[pair[0].runs.clone()], &runs[pair[1].runs.clone()]);
            while let ([above, above_next @ ..], [below, below_next @ ..]) = (upper, lower) {
                let strip = pair[0].row;
                self.visit_between(above, below, |base, apex, along| {
                    visit(NodeTriangle { base, apex, is_below: true, step: strip + along });
                });
                self.visit_between(below, above, |base, apex, along| {
                    visit(NodeTriangle { base, apex, is_below: false, step: strip + along });
                });
                if above.columns.end <= below.columns.end {
                    upper = above_next;
                } else {
                    lower = below_next;
                }
            }
        }
    }

    /// Calls `visit` with the base and the apex of each triangle between two runs, and its half steps to the right.
    fn visit_between(&self, base: &Run, apex: &Run, mut visit: impl FnMut(usize, usize, usize)) {
        let shift = self.shift(base.row);
        let from = base.columns.start.max(apex.columns.start.saturating_sub(shift));
        let to = (base.columns.end - 1).min(apex.columns.end.saturating_sub(shift));
        if from >= to {
            return;
        }
        let first = (base.number(from), apex.number(from + shift), 2 * from + shift);
        for at in 0..to - from {
            let (left, tip) = (first.0 + at, first.1 + at);
            if self.is_node[left] && self.is_node[left + 1] && self.is_node[tip] {
                visit(left, tip, first.2 + 2 * at);
            }
        }
    }

    /// Columns from the left end of a base in a row to the apex.
    fn shift(&self, row: usize) -> usize {
        usize::from(self.runs.lattice.is_shifted(row))
    }
}

impl Run {
    /// The number of a column.
    fn number(&self, column: usize) -> usize {
        self.first + (column - self.columns.start)
    }
}

/// The columns of a row with x between two numbers, out of a larger range.
fn within(lattice: &Lattice, row: usize, mut columns: Range<usize>, low: f64, high: f64) -> Range<usize> {
    let x = |column: usize| lattice.node(row, column).x;
    while !columns.is_empty() && x(columns.start) <= low {
        columns.start += 1;
    }
    while !columns.is_empty() && x(columns.end - 1) >= high {
        columns.end -= 1;
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{domain::contains, sample::lattice::spacing};

    fn positions(domain: &Domain, spacing: f64, vertices: &[DVec2], segments: &[[usize; 2]]) -> Vec<DVec2> {
        Nodes::new(domain, &[], spacing, vertices, segments).positions().map(|(_, p)| p).collect()
    }

    #[test]
    fn no_nodes_between_distant_specks() {
        let square = |at: f64| {
            let corners = [(at, at), (at + 1.0, at), (at + 1.0, at + 1.0), (at, at + 1.0)];
            corners.map(DVec2::from).to_vec()
        };
        let domain = Domain::from_polygon(&[square(10.0), square(3000.0)], 4000, 4000).expect("two squares");
        // The whole box would have 50 billion nodes.
        let found = positions(&domain, spacing(&domain, 10_000), &[], &[]);
        assert!((9_000..11_000).contains(&found.len()), "{}", found.len());
        let halves = found.iter().filter(|p| p.x < 100.0).count();
        assert!(halves.abs_diff(found.len() / 2) < 200, "{halves} of {}", found.len());
    }

    #[test]
    fn no_clear_node_is_missing_beside_narrow_holes() {
        let outer = [(0.0, 0.0), (100.0, 0.0), (100.0, 80.0), (0.0, 80.0)].map(DVec2::from).to_vec();
        for (at, width) in (0..40).map(|i| (30.0 + 0.7 * f64::from(i), 0.1 + 0.05 * f64::from(i))) {
            let hole = [(at, 10.0), (at + width, 10.0), (at + width, 70.0), (at, 70.0)].map(DVec2::from).to_vec();
            let domain = Domain::from_polygon(&[outer.clone(), hole], 100, 80).expect("a hole inside");
            let vertices: Vec<DVec2> = domain.rings().iter().flatten().copied().collect();
            let segments: Vec<[usize; 2]> = (0..8).map(|i| [i, i / 4 * 4 + (i + 1) % 4]).collect();
            let spacing = 5.0;
            let found = positions(&domain, spacing, &vertices, &segments);
            let lattice = Lattice::new(&domain, spacing);
            let (rows, columns) = (lattice.rows_within(0.0, 80.0), lattice.columns_within(0, 0.0, 100.0));
            let nodes = rows.flat_map(|row| columns.clone().map(move |column| (row, column)));
            let is_inside = |p: DVec2| domain.rings().iter().filter(|ring| contains(ring, p)).count() == 1;
            let is_clear = |p: &DVec2| is_inside(*p) && domain.distance_to_outline(*p) >= LATTICE_CLEARANCE * spacing;
            let expected: Vec<DVec2> = nodes.map(|(row, column)| lattice.node(row, column)).filter(is_clear).collect();
            assert_eq!(found, expected, "hole at {at}, {width} wide");
        }
    }
}
