//! Lists of different lengths in one allocation: compressed sparse rows.

use std::ops::Range;

/// Rows of items.
#[derive(Debug, Clone)]
pub(crate) struct Rows<T> {
    /// Rows + 1: the index of each row's first item.
    start: Vec<u32>,
    items: Vec<T>,
}

impl<T: Clone + Default> Rows<T> {
    /// Builds `rows` compressed rows from `(row, item)` pairs, keeping the order of the pairs within a row. Counting sort:
    /// `pairs` is called twice and must yield the same sequence.
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

    /// The range of a row's items among [`items`](Self::items).
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
    fn items_come_by_row_in_the_order_of_the_pairs() {
        let rows = Rows::from_pairs(4, || [(2, 'a'), (0, 'b'), (2, 'c'), (3, 'd'), (2, 'e')].into_iter());
        let all: Vec<&[char]> = (0..4).map(|row| rows.row(row)).collect();
        assert_eq!(all, [&['b'][..], &[], &['a', 'c', 'e'], &['d']]);
        assert_eq!((rows.range(1), rows.into_items()), (1..1, vec!['b', 'a', 'c', 'e', 'd']));
    }
}
