//! Pseudorandom numbers, the same on every machine: SplitMix64 (Steele, Lea and Flood 2014).

/// A sequence determined by its seed.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A whole number below `end`, which is at least 1.
    pub(super) fn below(&mut self, end: u32) -> u32 {
        // The upper half of a product is even enough, as ends are far below 2³².
        (((self.next() >> 32) * u64::from(end)) >> 32) as u32
    }

    /// A whole number from `-radius` to `radius`.
    pub(super) fn around(&mut self, radius: i32) -> i32 {
        self.below(2 * radius as u32 + 1) as i32 - radius
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    #[test]
    fn numbers_lie_in_their_range_and_depend_on_the_seed_alone() {
        let numbers = |seed| {
            let mut random = Random::new(seed);
            (0..1000).map(|_| [random.below(7) as i32, random.around(3)]).collect::<Vec<_>>()
        };
        assert_eq!(numbers(1), numbers(1));
        assert_ne!(numbers(1), numbers(2));
        for number in 0..7 {
            assert!(numbers(1).iter().filter(|[below, _]| *below == number).count() > 100);
            assert!(numbers(1).iter().filter(|[_, around]| *around == number - 3).count() > 100);
        }
    }
}
