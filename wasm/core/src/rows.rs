//! Compressed sparse rows: lists of different lengths in one allocation.

use std::ops::Range;

/// Rows of items, as an array of items and the offset of each row.
#[derive(Debug, Clone)]
pub(crate) struct Rows<T> {
    /// Rows + 1: the index of each row's first item, then the number of items.
    start: Vec<u32>,
    items: Vec<T>,
}

impl<T: Clone + Default> Rows<T> {
    /// Builds rows from `(row, item)` pairs by a counting sort. Items of a row keep the order of their pairs.
    ///
    /// `pairs` is called twice and must return the same sequence.
    pub(crate) fn from_pairs<I: Iterator<Item = (usize, T)>>(rows: usize, pairs: impl Fn() -> I) -> Self {
        let mut start = vec![0_u32; rows + 1];
        pairs().for_each(|(row, _)| start[row + 1] += 1);
        for row in 0..rows {
            start[row + 1] += start[row];
        }
        let (mut fill, mut items) = (start.clone(), vec![T::default(); start[rows] as usize]);
        pairs().for_each(|(row, item)| {
            items[fill[row] as usize] = item;
            fill[row] += 1;
        });
        Self { start, items }
    }
}

impl<T> Rows<T> {
    /// The items of a row.
    pub(crate) fn row(&self, row: usize) -> &[T] {
        &self.items[self.range(row)]
    }

    /// The range of a row in [`items`](Self::items).
    pub(crate) fn range(&self, row: usize) -> Range<usize> {
        self.start[row] as usize..self.start[row + 1] as usize
    }

    /// The items of all rows, row by row.
    pub(crate) fn items(&self) -> &[T] {
        &self.items
    }

    /// The items of all rows, row by row.
    pub(crate) fn into_items(self) -> Vec<T> {
        self.items
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_of_a_row_keep_the_order_of_their_pairs() {
        let rows = Rows::from_pairs(4, || [(2, 'a'), (0, 'b'), (2, 'c'), (3, 'd'), (2, 'e')].into_iter());
        let all: Vec<&[char]> = (0..4).map(|row| rows.row(row)).collect();
        assert_eq!(all, [&['b'][..], &[], &['a', 'c', 'e'], &['d']]);
        assert_eq!((rows.range(1), rows.into_items()), (1..1, vec!['b', 'a', 'c', 'e', 'd']));
    }
}
