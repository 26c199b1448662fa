//! The triangular lattice inside the domain (section V-B).
//!
//! Cost: O(n log n) for n nodes inside, plus the rows that each edge of the outline crosses. Space between islands
//! costs nothing. Known limit: the number of samples is approximate.

use std::{collections::BTreeMap, ops::Range};

use glam::DVec2;

use crate::{domain::Domain, segment::segment_distance};

/// Least distance of lattice points from the outline and from bones, as a multiple of the spacing.
///
/// Closer points make slivers. It is not one half: on outlines parallel to the lattice, rounding would decide then.
pub(super) const LATTICE_CLEARANCE: f64 = 0.47;
/// Height of a lattice row as a multiple of the spacing: √3 / 2.
pub(super) const ROW_HEIGHT: f64 = 0.866_025_403_784_438_6;

/// A difference below this fraction of its terms has lost three digits to cancellation.
const CANCELLATION: f64 = 1e-3;

/// The spacing for about `count` points on lattice and outline together.
pub(super) fn spacing(domain: &Domain, count: usize) -> f64 {
    let area = domain.area();
    let lengths = domain.edges().map(|(a, b)| a.distance(b));
    let perimeter: f64 = lengths.sum();
    let corners: usize = domain.rings().iter().map(Vec::len).sum();
    let wanted = (count as f64 - corners as f64).max(count as f64 / 4.0);
    // With u = 1 / spacing, the outline has perimeter · u points.
    // The lattice has (area − LATTICE_CLEARANCE · perimeter / u) · u² / ROW_HEIGHT points.
    positive_root(area / ROW_HEIGHT, perimeter * (1.0 - LATTICE_CLEARANCE / ROW_HEIGHT), wanted)
}

/// The positive x with `quadratic / x² + linear / x = wanted`. All three must be positive.
fn positive_root(quadratic: f64, linear: f64, wanted: f64) -> f64 {
    let root = (linear * linear + 4.0 * quadratic * wanted).sqrt();
    let difference = root - linear;
    // Two forms of the same root. In a domain that is nearly all outline, the difference would have no correct digits.
    if difference > CANCELLATION * root { 2.0 * quadratic / difference } else { (root + linear) / (2.0 * wanted) }
}

/// Lattice points inside the domain that keep their clearance from the outline's `segments` and from bones.
pub(super) fn inner_points(
    domain: &Domain,
    bones: &[[DVec2; 2]],
    spacing: f64,
    vertices: &[DVec2],
    segments: &[[usize; 2]],
) -> Vec<DVec2> {
    let lattice = Lattice::new(domain, spacing);
    let mut inside = lattice.inside(domain);
    let clearance = LATTICE_CLEARANCE * spacing;
    for &[a, b] in segments {
        lattice.clear_around(&mut inside, vertices[a], vertices[b], clearance);
    }
    for &[a, b] in bones {
        lattice.clear_around(&mut inside, a, b, clearance);
    }
    let nodes = inside.iter().flat_map(|(&row, runs)| runs.iter().flat_map(move |run| run.nodes(row)));
    nodes.map(|(row, column)| lattice.node(row, column)).collect()
}

/// Consecutive nodes of a row, each inside the domain or not.
struct Run {
    columns: Range<usize>,
    inside: Vec<bool>,
}

impl Run {
    /// Row and column of each node inside.
    fn nodes(&self, row: usize) -> impl Iterator<Item = (usize, usize)> {
        self.columns.clone().zip(&self.inside).filter(|(_, inside)| **inside).map(move |(column, _)| (row, column))
    }
}

/// The runs of each row that has any, ascending. It is sparse: a domain may be a few specks in a large box.
type RowRuns = BTreeMap<usize, Vec<Run>>;

/// The lattice over a domain's bounding box. One node is at the centre of the box.
struct Lattice {
    centre: DVec2,
    spacing: f64,
    rows: usize,
    columns: usize,
}

impl Lattice {
    fn new(domain: &Domain, spacing: f64) -> Self {
        let (low, high) = domain.bounds();
        let half = (high - low) / 2.0;
        let rows = 2 * (half.y / (spacing * ROW_HEIGHT)) as usize + 1;
        let columns = 2 * ((half.x / spacing) as usize + 1);
        Self { centre: (low + high) / 2.0, spacing, rows, columns: columns + 1 }
    }

    /// The position of a node. Every other row is shifted by half a step.
    fn node(&self, row: usize, column: usize) -> DVec2 {
        let (j, i) = (self.row_step(row), column as f64 - (self.columns / 2) as f64);
        let shift = if self.is_shifted(row) { 0.5 } else { 0.0 };
        self.centre + DVec2::new((i + shift) * self.spacing, j * self.spacing * ROW_HEIGHT)
    }

    fn row_step(&self, row: usize) -> f64 {
        row as f64 - (self.rows / 2) as f64
    }

    fn is_shifted(&self, row: usize) -> bool {
        row.abs_diff(self.rows / 2) % 2 == 1
    }

    /// The nodes between the crossings of each row with the outline, marked if inside by the even-odd rule.
    fn inside(&self, domain: &Domain) -> RowRuns {
        let mut crossings: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
        for (a, b) in domain.edges() {
            let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
            for row in self.rows_within(low.y, high.y) {
                let y = self.node(row, 0).y;
                if low.y <= y && y < high.y {
                    crossings.entry(row).or_default().push(low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x));
                }
            }
        }
        crossings.into_iter().map(|(row, crossings)| (row, self.runs(row, crossings))).collect()
    }

    /// The runs of a row between its crossings with the outline.
    fn runs(&self, row: usize, mut crossings: Vec<f64>) -> Vec<Run> {
        crossings.sort_by(f64::total_cmp);
        let mut runs: Vec<Run> = Vec::new();
        for span in crossings.chunks_exact(2) {
            let columns = self.columns_within(row, span[0], span[1]);
            // A node close to two spans belongs to the runs of both: merge them.
            let run = match runs.last_mut() {
                Some(last) if last.columns.end >= columns.start => last,
                _ => {
                    runs.push(Run { columns: columns.start..columns.start, inside: Vec::new() });
                    runs.last_mut().expect("a run was just pushed")
                }
            };
            run.columns.end = run.columns.end.max(columns.end);
            run.inside.resize(run.columns.len(), false);
            for column in columns {
                let x = self.node(row, column).x;
                run.inside[column - run.columns.start] |= span[0] < x && x < span[1];
            }
        }
        runs
    }

    /// Unmarks the nodes closer to a segment than `clearance`.
    fn clear_around(&self, inside: &mut RowRuns, a: DVec2, b: DVec2, clearance: f64) {
        let (low, high) = (a.min(b) - clearance, a.max(b) + clearance);
        for (&row, runs) in inside.range_mut(self.rows_within(low.y, high.y)) {
            let columns = self.columns_within(row, low.x, high.x);
            let first = runs.partition_point(|run| run.columns.end <= columns.start);
            for run in runs[first..].iter_mut().take_while(|run| run.columns.start < columns.end) {
                for column in columns.start.max(run.columns.start)..columns.end.min(run.columns.end) {
                    if segment_distance(self.node(row, column), a, b) < clearance {
                        run.inside[column - run.columns.start] = false;
                    }
                }
            }
        }
    }

    /// Rows that may have a y between two numbers.
    fn rows_within(&self, low: f64, high: f64) -> Range<usize> {
        let step = |y: f64| (y - self.centre.y) / (self.spacing * ROW_HEIGHT) + (self.rows / 2) as f64;
        range(step(low), step(high), self.rows)
    }

    /// Columns of a row that may have an x between two numbers.
    fn columns_within(&self, row: usize, low: f64, high: f64) -> Range<usize> {
        let shift = if self.is_shifted(row) { 0.5 } else { 0.0 };
        let step = |x: f64| (x - self.centre.x) / self.spacing - shift + (self.columns / 2) as f64;
        range(step(low), step(high), self.columns)
    }
}

/// The integers from just below `low` to just above `high`, within `0..count`.
fn range(low: f64, high: f64, count: usize) -> Range<usize> {
    let end = ((high.ceil() + 1.0).max(0.0) as usize).min(count);
    (low.floor().max(0.0) as usize).min(end)..end
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::contains;

    #[test]
    fn spacing_is_exact_for_thin_domains() {
        for area in [1e6, 1.0, 1e-6, 1e-12, 1e-18] {
            let x = positive_root(area, 2000.0, 10_000.0);
            let found = area / (x * x) + 2000.0 / x;
            assert!((found - 10_000.0).abs() < 1e-6, "{found} points for an area of {area}");
        }
    }

    #[test]
    fn no_nodes_between_distant_specks() {
        let square = |at: f64| {
            let corners = [(at, at), (at + 1.0, at), (at + 1.0, at + 1.0), (at, at + 1.0)];
            corners.map(DVec2::from).to_vec()
        };
        let domain = Domain::from_polygon(&[square(10.0), square(3000.0)], 4000, 4000).expect("two squares");
        // The whole box would have 50 billion nodes.
        let found = inner_points(&domain, &[], spacing(&domain, 10_000), &[], &[]);
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
            let found = inner_points(&domain, &[], spacing, &vertices, &segments);
            let lattice = Lattice::new(&domain, spacing);
            let nodes = (0..lattice.rows).flat_map(|row| (0..lattice.columns).map(move |column| (row, column)));
            let is_inside = |p: DVec2| domain.rings().iter().filter(|ring| contains(ring, p)).count() == 1;
            let is_clear = |p: &DVec2| is_inside(*p) && domain.distance_to_outline(*p) >= LATTICE_CLEARANCE * spacing;
            let expected: Vec<DVec2> = nodes.map(|(row, column)| lattice.node(row, column)).filter(is_clear).collect();
            assert_eq!(found, expected, "hole at {at}, {width} wide");
        }
    }
}
