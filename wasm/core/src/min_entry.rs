//! Priority by a least floating-point key, for [`BinaryHeap`](std::collections::BinaryHeap).

use std::cmp::Ordering;

/// A heap entry. The heap pops the least key first, and the least item among equal keys.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MinEntry<T> {
    pub(crate) key: f64,
    pub(crate) item: T,
}

impl<T: Ord> Ord for MinEntry<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key).then_with(|| other.item.cmp(&self.item))
    }
}

impl<T: Ord> PartialOrd for MinEntry<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T: Ord> PartialEq for MinEntry<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T: Ord> Eq for MinEntry<T> {}
