//! Visited flags of a graph search that are cleared in O(1): each item stores the number of the last search that
//! visited it.

/// Visited flags of the items 0 to n − 1.
#[derive(Debug, Clone)]
pub(super) struct VisitStamps {
    /// For each item, the last search that visited it.
    last: Vec<u32>,
    search: u32,
}

impl VisitStamps {
    /// `count` items, none of them visited.
    pub(super) fn new(count: usize) -> Self {
        Self { last: vec![0; count], search: 1 }
    }

    /// Clears all flags.
    pub(super) fn clear(&mut self) {
        self.search += 1;
    }

    /// Marks an item as visited. Returns whether it was unvisited before.
    pub(super) fn mark(&mut self, at: u32) -> bool {
        std::mem::replace(&mut self.last[at as usize], self.search) != self.search
    }

    /// Whether an item is marked.
    pub(super) fn has(&self, at: u32) -> bool {
        self.last[at as usize] == self.search
    }
}
