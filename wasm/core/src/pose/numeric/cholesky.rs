//! The factorisation L D Lᵀ of a symmetric positive definite matrix: sparse Cholesky, with a fixed order of all
//! sums.
//!
//! Rows form groups of up to three, the unknowns of one site. The group with the fewest neighbours is eliminated first
//! (minimum degree: Tinney and Walker 1967). The columns of a group have their entries in the same rows, so they are
//! stored and processed together (supernodes). Unlike [`elimination`](super::elimination), it accepts entries of any
//! sign, and its accuracy depends on the condition of the matrix.
//!
//! Cost: for 200 sites of three rows, 40,000 entries and about 50 µs for a solution.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use crate::rank::sort_by_rank;

/// Maximum number of rows in a group.
const MAX_WIDTH: usize = 3;

/// A group of columns.
#[derive(Debug, Clone)]
struct Supernode {
    /// Number of columns. Their diagonal rows follow those of the previous supernode.
    width: usize,
    /// End of the rows below; they begin at the end of the previous supernode's.
    end: u32,
    /// Entries below the diagonal within the group: (1, 0), (2, 0), (2, 1).
    inner: [f64; 3],
    /// Reciprocals of D.
    inverses: [f64; MAX_WIDTH],
}

#[derive(Debug, Clone)]
pub(crate) struct Cholesky {
    /// Row of the matrix that each pivot eliminates.
    pivots: Vec<u32>,
    supernodes: Vec<Supernode>,
    /// The rows below each supernode, as pivot numbers.
    rows: Vec<u32>,
    /// For each of these rows, one value for each column of the supernode.
    values: Vec<f64>,
}

/// The columns finished so far.
struct Columns {
    /// End of the entries of each column; they begin at the end of the previous column's.
    ends: Vec<usize>,
    /// Entries below the diagonal: pivot number, value.
    entries: Vec<(u32, f64)>,
    inverses: Vec<f64>,
}

impl Cholesky {
    /// Factorises the matrix with the given lower entries (row, column, value); `groups` are the rows of each
    /// group, one to three.
    pub(crate) fn new(groups: &[Vec<u32>], lower: &BTreeMap<(u32, u32), f64>) -> Self {
        let count = groups.iter().map(Vec::len).sum();
        let mut group_of = vec![0; count];
        for (group, rows) in (0..).zip(groups) {
            rows.iter().for_each(|&row| group_of[row as usize] = group);
        }
        let pairs = lower.keys().map(|&(row, column)| (group_of[row as usize], group_of[column as usize]));
        let order = elimination_order(groups.len(), pairs);
        let pivots: Vec<u32> = order.iter().flat_map(|(group, _)| groups[*group as usize].iter().copied()).collect();
        let mut pivot = vec![0_u32; count];
        pivots.iter().zip(0..).for_each(|(&row, at)| pivot[row as usize] = at);
        let mut matrix: Vec<Vec<(u32, f64)>> = vec![Vec::new(); count];
        for (&(row, column), &value) in lower {
            let (i, j) = (pivot[row as usize], pivot[column as usize]);
            matrix[i.min(j) as usize].push((i.max(j), value));
        }
        let mut columns = Columns { ends: Vec::with_capacity(count), entries: Vec::new(), inverses: Vec::new() };
        // For each pivot the earlier columns with an entry in its row, and the index of that entry.
        let mut before: Vec<Vec<(usize, usize)>> = vec![Vec::new(); count];
        let mut sums = vec![0.0; count];
        let (mut supernodes, mut rows, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for (group, later) in &order {
            let of_group = |group: u32| groups[group as usize].iter().map(|&row| pivot[row as usize]);
            let mut below: Vec<u32> = later.iter().flat_map(|&other| of_group(other)).collect();
            sort_by_rank(&mut below, |&pivot| [pivot.into(), 0]);
            let structure: Vec<u32> = of_group(*group).chain(below.iter().copied()).collect();
            let width = groups[*group as usize].len();
            for at in 0..width {
                let column = structure[at] as usize;
                matrix[column].iter().for_each(|&(row, value)| sums[row as usize] += value);
                for &(earlier, entry) in &before[column] {
                    let factor = columns.entries[entry].1 / columns.inverses[earlier];
                    for &(row, value) in &columns.entries[entry..columns.ends[earlier]] {
                        sums[row as usize] -= factor * value;
                    }
                }
                columns.close(&structure[at..], &mut sums, |row, entry| before[row].push((column, entry)));
            }
            let supernode = columns.last(width, &below, &mut values);
            rows.extend(below);
            supernodes.push(Supernode { end: rows.len() as u32, ..supernode });
        }
        Self { pivots, supernodes, rows, values }
    }

    /// Replaces a right-hand side by the solution.
    pub(crate) fn solve(&self, x: &mut [DVec2]) {
        let mut y: Vec<DVec2> = self.pivots.iter().map(|&row| x[row as usize]).collect();
        let (mut first, mut start, mut value) = (0, 0, 0);
        for node in &self.supernodes {
            let (rows, values) = (&self.rows[start..node.end as usize], &self.values[value..]);
            match node.width {
                1 => forward::<1>(node, first, rows, values, &mut y),
                2 => forward::<2>(node, first, rows, values, &mut y),
                _ => forward::<3>(node, first, rows, values, &mut y),
            }
            first += node.width;
            start = node.end as usize;
            value += rows.len() * node.width;
        }
        for (at, node) in self.supernodes.iter().enumerate().rev() {
            let before = if at > 0 { self.supernodes[at - 1].end as usize } else { 0 };
            let rows = &self.rows[before..node.end as usize];
            first -= node.width;
            value -= rows.len() * node.width;
            let values = &self.values[value..];
            match node.width {
                1 => backward::<1>(node, first, rows, values, &mut y),
                2 => backward::<2>(node, first, rows, values, &mut y),
                _ => backward::<3>(node, first, rows, values, &mut y),
            }
        }
        for (&row, &value) in self.pivots.iter().zip(&y) {
            x[row as usize] = value;
        }
    }
}

impl Columns {
    /// Finishes the column whose entries in the rows of `structure`, its own first, are in `sums`, and resets
    /// these to 0. Calls `visit` with the row and the index of each entry.
    fn close(&mut self, structure: &[u32], sums: &mut [f64], mut visit: impl FnMut(usize, usize)) {
        let diagonal = std::mem::take(&mut sums[structure[0] as usize]);
        let inverse = if diagonal > 0.0 { 1.0 / diagonal } else { 0.0 };
        for &row in &structure[1..] {
            visit(row as usize, self.entries.len());
            self.entries.push((row, std::mem::take(&mut sums[row as usize]) * inverse));
        }
        self.ends.push(self.entries.len());
        self.inverses.push(inverse);
    }

    /// The last `width` columns as a supernode with entries in the rows `below`.
    fn last(&self, width: usize, below: &[u32], values: &mut Vec<f64>) -> Supernode {
        let first = self.ends.len() - width;
        let column = |at: usize| {
            let end = self.ends[first + at];
            &self.entries[end - below.len() - (width - 1 - at)..end]
        };
        for row in width..width + below.len() {
            values.extend((0..width).map(|at| column(at)[row - at - 1].1));
        }
        let mut supernode = Supernode { width, end: 0, inner: [0.0; 3], inverses: [0.0; MAX_WIDTH] };
        for (inner, (row, at)) in supernode.inner.iter_mut().zip([(1, 0), (2, 0), (2, 1)]) {
            if row < width {
                *inner = column(at)[row - at - 1].1;
            }
        }
        supernode.inverses[..width].copy_from_slice(&self.inverses[first..]);
        supernode
    }
}

/// y ← L⁻¹ y for the columns of one supernode, then D⁻¹ for their own rows.
fn forward<const WIDTH: usize>(node: &Supernode, first: usize, rows: &[u32], values: &[f64], y: &mut [DVec2]) {
    let mut own: [DVec2; WIDTH] = std::array::from_fn(|column| y[first + column]);
    if WIDTH > 1 {
        own[1] -= node.inner[0] * own[0];
    }
    if WIDTH > 2 {
        own[2] -= node.inner[1] * own[0] + node.inner[2] * own[1];
    }
    for (&row, values) in rows.iter().zip(values.chunks_exact(WIDTH)) {
        let sum = (1..WIDTH).fold(values[0] * own[0], |sum, column| sum + values[column] * own[column]);
        y[row as usize] -= sum;
    }
    for (column, own) in own.into_iter().enumerate() {
        y[first + column] = node.inverses[column] * own;
    }
}

/// y ← L⁻ᵀ y for the columns of one supernode.
fn backward<const WIDTH: usize>(node: &Supernode, first: usize, rows: &[u32], values: &[f64], y: &mut [DVec2]) {
    let mut own: [DVec2; WIDTH] = std::array::from_fn(|column| y[first + column]);
    for (&row, values) in rows.iter().zip(values.chunks_exact(WIDTH)) {
        let there = y[row as usize];
        own.iter_mut().zip(values).for_each(|(own, &value)| *own -= value * there);
    }
    if WIDTH > 2 {
        own[1] -= node.inner[2] * own[2];
        own[0] -= node.inner[1] * own[2];
    }
    if WIDTH > 1 {
        own[0] -= node.inner[0] * own[1];
    }
    y[first..first + WIDTH].copy_from_slice(&own);
}

/// The groups in the order of elimination, each with its neighbours at that time.
fn elimination_order(count: usize, pairs: impl Iterator<Item = (u32, u32)>) -> Vec<(u32, BTreeSet<u32>)> {
    let mut near: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); count];
    for (a, b) in pairs.filter(|(a, b)| a != b) {
        near[a as usize].insert(b);
        near[b as usize].insert(a);
    }
    let mut queue: BTreeSet<(usize, u32)> = BTreeSet::new();
    // Unlike `collect`, this needs no sort of its own: see `rank`.
    queue.extend((0..).zip(&near).map(|(group, list)| (list.len(), group)));
    let mut order = Vec::with_capacity(count);
    while let Some((_, group)) = queue.pop_first() {
        let around = std::mem::take(&mut near[group as usize]);
        for &at in &around {
            let list = &mut near[at as usize];
            queue.remove(&(list.len(), at));
            list.remove(&group);
            list.extend(around.iter().filter(|&&other| other != at));
            queue.insert((list.len(), at));
        }
        order.push((group, around));
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_solve() {
        const COUNT: u32 = 60;
        let mut lower = BTreeMap::new();
        for row in 0..COUNT {
            lower.insert((row, row), 3.0);
            for far in [1, 7, 20] {
                if row >= far {
                    lower.insert((row, row - far), libm::cos(f64::from(row * far)) / 2.0);
                }
            }
        }
        // Groups of one, two and three rows in turn.
        let groups: Vec<Vec<u32>> = (0..COUNT / 6)
            .map(|at| 6 * at)
            .flat_map(|from| [vec![from], vec![from + 1, from + 2], vec![from + 3, from + 4, from + 5]])
            .collect();
        let right: Vec<DVec2> = (0..COUNT).map(|i| DVec2::new(f64::from(i), libm::sin(f64::from(i)))).collect();
        let mut x = right.clone();
        Cholesky::new(&groups, &lower).solve(&mut x);
        let mut product = vec![DVec2::ZERO; x.len()];
        for (&(i, j), &value) in &lower {
            let (i, j) = (i as usize, j as usize);
            product[i] += value * x[j];
            if i != j {
                product[j] += value * x[i];
            }
        }
        for (product, right) in product.iter().zip(&right) {
            assert!(product.distance(*right) < 1e-11, "{product} in place of {right}");
        }
    }
}
