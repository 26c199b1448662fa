//! Sorts by ranks, so that many types share the machine code of one sort.
//!
//! The sort of the standard library takes ten kilobytes for each type and comparison. In total, this was a fifth of a
//! download, so all but the innermost loops use this module. The order is that of a stable sort.
//!
//! Cost: within 10 % of the standard library's sort. It allocates for more than [`FEW`] items.

use glam::DVec2;

/// A rank. The first number determines the order, and the second breaks ties.
pub(crate) type Rank = [i64; 2];

/// Up to this number of items, insertion sort is used.
const FEW: usize = 12;

/// Whole numbers in the order of [`f64::total_cmp`].
pub(crate) fn ascending(number: f64) -> i64 {
    let bits = number.to_bits() as i64;
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// Whole numbers in the opposite order of [`f64::total_cmp`].
pub(crate) fn descending(number: f64) -> i64 {
    !ascending(number)
}

/// The rank of a point in the order from top to bottom, and from left to right.
pub(crate) fn from_top(point: DVec2) -> Rank {
    [ascending(point.y), ascending(point.x)]
}

/// Sorts by rank. Items of the same rank keep their order.
pub(crate) fn sort_by_rank<T>(items: &mut [T], rank: impl Fn(&T) -> Rank) {
    if items.len() <= FEW {
        for end in 1..items.len() {
            let mut at = end;
            while at > 0 && rank(&items[at]) < rank(&items[at - 1]) {
                items.swap(at, at - 1);
                at -= 1;
            }
        }
        return;
    }
    let ranks = items.iter().map(rank).zip(0..).collect();
    for (at, other) in swaps(ranks) {
        items.swap(at as usize, other as usize);
    }
}

/// Sorts ranks, each with a number. This is the fastest sort here, because it moves no items.
#[inline(never)]
pub(crate) fn sort_ranks(ranks: &mut [(Rank, u32)]) {
    ranks.sort_unstable();
}

/// The swaps, one after another, that sort items with these ranks. Each rank has the index of its item.
#[inline(never)]
fn swaps(mut ranks: Vec<(Rank, u32)>) -> Vec<(u32, u32)> {
    sort_ranks(&mut ranks);
    let mut swaps = Vec::with_capacity(ranks.len());
    for start in 0..ranks.len() as u32 {
        // Each cycle of moves is done once. A place that has its item refers to itself.
        let mut at = start;
        loop {
            let from = std::mem::replace(&mut ranks[at as usize].1, at);
            if from == start {
                break;
            }
            swaps.push((at, from));
            at = from;
        }
    }
    swaps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matches_the_stable_sort_of_the_standard_library() {
        let numbers = [0.0, -0.0, 1.5, f64::NAN, -2.0, f64::INFINITY, 1e-300, -1e300, f64::NEG_INFINITY];
        for count in [0, 1, 2, FEW, FEW + 1, 100, 1000] {
            let items: Vec<(f64, i64, usize)> =
                (0..count).map(|at| (numbers[at * at % numbers.len()], (at * 7 % 5) as i64, at)).collect();
            let (mut sorted, mut expected) = (items.clone(), items.clone());
            sort_by_rank(&mut sorted, |&(number, whole, _)| [ascending(number), whole]);
            expected.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            assert!(sorted.iter().map(|item| item.2).eq(expected.iter().map(|item| item.2)), "{count} items");
            sort_by_rank(&mut sorted, |&(number, ..)| [descending(number), 0]);
            expected.sort_by(|a, b| b.0.total_cmp(&a.0));
            assert!(sorted.iter().map(|item| item.2).eq(expected.iter().map(|item| item.2)), "{count} items back");
        }
    }
}
