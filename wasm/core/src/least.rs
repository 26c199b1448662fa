//! Priority by a number that is not an integer, for `std::collections::BinaryHeap`.

use std::cmp::Ordering;

/// An entry of a heap that gives the least key first and, of equal keys, the least item.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Least<T> {
    pub(crate) key: f64,
    pub(crate) item: T,
}

impl<T: Ord> Ord for Least<T> {
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key).then_with(|| other.item.cmp(&self.item))
    }
}

impl<T: Ord> PartialOrd for Least<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<T: Ord> PartialEq for Least<T> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<T: Ord> Eq for Least<T> {}
