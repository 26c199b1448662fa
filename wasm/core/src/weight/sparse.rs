//! The weights of many points, as compressed sparse rows.

/// Initial capacity, in supports over a point: the average under the paper's rule; smooth supports make more.
const EXPECTED_COVER: usize = 3;

/// Weights of points: row `p` holds the sites that move point `p` and their weights, ascending by site.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SparseWeights {
    /// Points + 1: the index of each point's first entry.
    pub offsets: Vec<u32>,
    /// Entries: the site.
    pub sites: Vec<u32>,
    /// Entries: the weight. A row sums to 1, or is empty where no support reaches: that point stays.
    pub weights: Vec<f64>,
}

impl SparseWeights {
    /// No rows yet, with capacity for `points` of them.
    pub(crate) fn with_capacity(points: usize) -> Self {
        let mut offsets = Vec::with_capacity(points + 1);
        offsets.push(0);
        Self {
            offsets,
            sites: Vec::with_capacity(EXPECTED_COVER * points),
            weights: Vec::with_capacity(EXPECTED_COVER * points),
        }
    }

    /// Appends `points` rows from dense columns, one for each site in ascending order; zero weights are skipped.
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
                // Always written, and overwritten where the weight is zero: faster than an unpredictable branch.
                (self.sites[at], self.weights[at]) = (site, weights[point]);
                at += usize::from(weights[point] > 0.0);
            }
            self.offsets.push(at as u32);
        }
        self.sites.truncate(at);
        self.weights.truncate(at);
    }

    /// Normalises the `(point, φ)` lists of all sites, in order of the sites, into rows for `points` points (eq. 2). Also
    /// returns Σφ at each point.
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
        self.offsets.len().saturating_sub(1)
    }

    /// Whether there is no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The sites that move a point, and their weights.
    pub fn row(&self, point: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.offsets[point] as usize..self.offsets[point + 1] as usize;
        self.sites[range.clone()].iter().zip(&self.weights[range]).map(|(&site, &weight)| (site as usize, weight))
    }

    /// The weights of a point, in the order of [`row`](Self::row).
    pub(super) fn row_mut(&mut self, point: usize) -> &mut [f64] {
        &mut self.weights[self.offsets[point] as usize..self.offsets[point + 1] as usize]
    }

    /// Appends copies of the rows of other points.
    pub(crate) fn extend_as(&mut self, owners: &[u32]) {
        for &owner in owners {
            let range = self.offsets[owner as usize] as usize..self.offsets[owner as usize + 1] as usize;
            self.sites.extend_from_within(range.clone());
            self.weights.extend_from_within(range);
            self.offsets.push(self.sites.len() as u32);
        }
    }
}
