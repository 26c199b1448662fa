//! Disjoint sets of numbers (union-find with path halving).

/// Sets of consecutive numbers from zero. The root of a set is its least number.
#[derive(Debug, Default)]
pub(crate) struct DisjointSets {
    /// For each number, another number of the same set, nearer to its root; a root points to itself.
    parents: Vec<usize>,
}

impl DisjointSets {
    /// Creates sets of one number each.
    pub(crate) fn new(length: usize) -> Self {
        Self { parents: (0..length).collect() }
    }

    /// Adds a set for the next number, and returns the number.
    pub(crate) fn add(&mut self) -> usize {
        self.parents.push(self.parents.len());
        self.parents.len() - 1
    }

    /// The least number of a set.
    pub(crate) fn root(&mut self, mut number: usize) -> usize {
        while self.parents[number] != number {
            self.parents[number] = self.parents[self.parents[number]];
            number = self.parents[number];
        }
        number
    }

    /// Unites two sets.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::DisjointSets;

    #[test]
    fn root_is_the_least_number_of_a_set() {
        let mut sets = DisjointSets::new(5);
        for (a, b) in [(4, 3), (2, 4), (0, 1)] {
            sets.join(a, b);
        }
        assert_eq!(sets.add(), 5);
        assert_eq!([0, 1, 2, 3, 4, 5].map(|number| sets.root(number)), [0, 0, 2, 2, 2, 5]);
    }
}
