//! The weights of many points, as compressed sparse rows (eq. 2).
//!
//! Cost: 12 bytes for each entry, and 4 for each point.

/// Initial capacity, in supports over a point: the average under the paper's rule. Smooth supports need more.
const EXPECTED_COVER: usize = 3;

/// The weights w_i of points (eq. 2): a sparse matrix of points × sites.
///
/// Row `p` holds the sites that move point `p` and their weights, ascending by site. A row sums to 1 within rounding.
/// If no support reaches the point, its row is empty: it does not move.
///
/// ```
/// # use c2warp::{Picture, project::{Handle, Project}, solve};
/// # let (mut project, rgba) = (Project::for_picture(40, 30), vec![255; 40 * 30 * 4]);
/// # project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
/// # let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
/// let weights = solution.weights_of(&[[5.0, 15.0].into(), [12.0, 9.0].into()]);
/// assert_eq!(weights.row(0).collect::<Vec<_>>(), [(0, 1.0)]);
/// assert!((weights.row(1).map(|(_, weight)| weight).sum::<f64>() - 1.0).abs() < 1e-12);
/// // The same as three arrays, for libraries of sparse matrices.
/// let (offsets, sites, values) = weights.into_parts();
/// assert_eq!((offsets.len(), sites.len()), (3, values.len()));
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SparseWeights {
    offsets: Vec<u32>,
    sites: Vec<u32>,
    weights: Vec<f64>,
}

impl SparseWeights {
    /// A matrix without rows, with capacity for `points` rows.
    pub(crate) fn with_capacity(points: usize) -> Self {
        let mut offsets = Vec::with_capacity(points + 1);
        offsets.push(0);
        Self {
            offsets,
            sites: Vec::with_capacity(EXPECTED_COVER * points),
            weights: Vec::with_capacity(EXPECTED_COVER * points),
        }
    }

    /// A matrix from compressed arrays, as returned by [`into_parts`](Self::into_parts); `None` if they are
    /// inconsistent.
    #[must_use]
    pub fn from_parts(offsets: Vec<u32>, sites: Vec<u32>, weights: Vec<f64>) -> Option<Self> {
        let is_consistent = offsets.first() == Some(&0)
            && offsets.is_sorted()
            && offsets.last().is_some_and(|&entries| entries as usize == sites.len())
            && sites.len() == weights.len();
        is_consistent.then_some(Self { offsets, sites, weights })
    }

    /// Appends `points` rows from dense columns, one for each site in ascending order. Skips zero weights.
    pub(crate) fn push_rows<'a, const N: usize>(
        &mut self,
        points: usize,
        columns: &(impl ExactSizeIterator<Item = (u32, &'a [f64; N])> + Clone),
    ) {
        let mut at = self.sites.len();
        let room = at + points * columns.len();
        self.sites.resize(room, 0);
        self.weights.resize(room, 0.0);
        for point in 0..points {
            for (site, weights) in columns.clone() {
                // Always written, and overwritten if the weight is zero: faster than an unpredictable branch.
                (self.sites[at], self.weights[at]) = (site, weights[point]);
                at += usize::from(weights[point] > 0.0);
            }
            self.offsets.push(at as u32);
        }
        self.sites.truncate(at);
        self.weights.truncate(at);
    }

    /// Appends a row: sites in ascending order, and their weights.
    pub(crate) fn push_row(&mut self, row: impl Iterator<Item = (usize, f64)>) {
        for (site, weight) in row {
            self.sites.push(site as u32);
            self.weights.push(weight);
        }
        self.offsets.push(self.sites.len() as u32);
    }

    /// Normalises the `(point, φ)` lists of all sites, in the order of the sites, into rows for `points` points (eq.
    /// 2). Also returns Σφ at each point.
    pub(crate) fn normalised(points: usize, by_site: &[Vec<(u32, f64)>]) -> (Self, Vec<f64>) {
        let mut offsets = vec![0_u32; points + 1];
        let mut sums = vec![0.0; points];
        for &(point, phi) in by_site.iter().flatten() {
            offsets[point as usize + 1] += 1;
            sums[point as usize] += phi;
        }
        for i in 1..offsets.len() {
            offsets[i] += offsets[i - 1];
        }
        let entries = offsets[points] as usize;
        let (mut sites, mut weights) = (vec![0; entries], vec![0.0; entries]);
        let mut fill = offsets.clone();
        for (site, list) in by_site.iter().enumerate() {
            for &(point, phi) in list {
                let at = &mut fill[point as usize];
                sites[*at as usize] = site as u32;
                weights[*at as usize] = phi / sums[point as usize];
                *at += 1;
            }
        }
        (Self { offsets, sites, weights }, sums)
    }

    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether the matrix has no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Points + 1: the index of each point's first entry in [`sites`](Self::sites) and [`weights`](Self::weights), then
    /// the number of entries.
    #[must_use]
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// Entries: the index of the site.
    #[must_use]
    pub fn sites(&self) -> &[u32] {
        &self.sites
    }

    /// Entries: the weight, from 0 to 1.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// [`offsets`](Self::offsets), [`sites`](Self::sites) and [`weights`](Self::weights), without a copy.
    #[must_use]
    pub fn into_parts(self) -> (Vec<u32>, Vec<u32>, Vec<f64>) {
        (self.offsets, self.sites, self.weights)
    }

    /// The sites that move a point, and their weights, ascending by site.
    ///
    /// # Panics
    /// If `point` is out of bounds.
    pub fn row(&self, point: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.offsets[point] as usize..self.offsets[point + 1] as usize;
        self.sites[range.clone()].iter().zip(&self.weights[range]).map(|(&site, &weight)| (site as usize, weight))
    }

    /// The weights of a point, in the order of [`row`](Self::row).
    pub(super) fn row_mut(&mut self, point: usize) -> &mut [f64] {
        &mut self.weights[self.offsets[point] as usize..self.offsets[point + 1] as usize]
    }

    /// A matrix with a copy of the row of each owner.
    pub(crate) fn copied(&self, owners: &[u32]) -> Self {
        let mut copies = Self::with_capacity(owners.len());
        for &owner in owners {
            let range = self.offsets[owner as usize] as usize..self.offsets[owner as usize + 1] as usize;
            copies.sites.extend_from_slice(&self.sites[range.clone()]);
            copies.weights.extend_from_slice(&self.weights[range]);
            copies.offsets.push(copies.sites.len() as u32);
        }
        copies
    }

    /// Appends a copy of the row of each owner.
    pub(crate) fn push_copies(&mut self, owners: &[u32]) {
        for &owner in owners {
            let range = self.offsets[owner as usize] as usize..self.offsets[owner as usize + 1] as usize;
            self.sites.extend_from_within(range.clone());
            self.weights.extend_from_within(range);
            self.offsets.push(self.sites.len() as u32);
        }
    }
}
