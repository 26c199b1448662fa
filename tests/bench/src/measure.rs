//! Measures times as the minimum of many runs after a warm-up.
//!
//! The first runs map memory, and in a page they run unoptimised code. Other work of the machine only adds time, on
//! shared machines more than half for seconds. So the minimum is the time of the program itself, and it is the most
//! reproducible statistic.

use crate::clock::Clock;

/// The effort for one measurement.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Duration of the warm-up, which has at least one run.
    pub warm_up_ms: f64,
    /// Duration of the measured runs.
    pub measured_ms: f64,
    /// The smallest number of measured runs.
    pub min_runs: usize,
}

impl Effort {
    /// For published results.
    pub const FULL: Self = Self { warm_up_ms: 250.0, measured_ms: 600.0, min_runs: 5 };
    /// For tests: one run without a reliable time.
    pub const TRIAL: Self = Self { warm_up_ms: 0.0, measured_ms: 0.0, min_runs: 1 };
}

/// Returns the results of the measured runs.
///
/// # Errors
/// The first error of a run.
pub fn repeat<T, E>(clock: Clock, effort: Effort, mut run: impl FnMut() -> Result<T, E>) -> Result<Vec<T>, E> {
    let start = clock();
    loop {
        once(&mut run)?;
        if clock() - start >= effort.warm_up_ms {
            break;
        }
    }
    let start = clock();
    let mut results = Vec::new();
    while results.len() < effort.min_runs.max(1) || clock() - start < effort.measured_ms {
        results.push(once(&mut run)?);
    }
    Ok(results)
}

/// Runs once. It is a separate call because pages switch to optimised code at calls, not during a run.
#[inline(never)]
fn once<T>(run: &mut impl FnMut() -> T) -> T {
    run()
}

/// Returns the shortest time of a run that cannot fail, in milliseconds.
pub fn min_ms(clock: Clock, effort: Effort, mut run: impl FnMut()) -> f64 {
    let timed = || {
        let start = clock();
        run();
        Ok::<_, std::convert::Infallible>(clock() - start)
    };
    match repeat(clock, effort, timed) {
        Ok(times) => minimum(times),
    }
}

/// Returns the smallest value, or NaN if there is none.
#[must_use]
pub fn minimum(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().reduce(f64::min).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    thread_local!(static NOW: Cell<f64> = const { Cell::new(0.0) });

    #[test]
    fn repeat_runs_often_enough_and_long_enough() {
        let effort = Effort { warm_up_ms: 25.0, measured_ms: 40.0, min_runs: 3 };
        for (duration, warm, counted) in [(10.0, 3, 4), (100.0, 1, 3)] {
            let mut all = 0;
            let results = repeat(
                || NOW.get(),
                effort,
                || {
                    NOW.set(NOW.get() + duration);
                    all += 1;
                    Ok::<_, ()>(all)
                },
            );
            assert_eq!(results, Ok((warm + 1..=warm + counted).collect()));
        }
        assert_eq!(repeat(|| NOW.get(), effort, || Err::<(), _>("no")), Err("no"));
    }

    #[test]
    fn minimum_of_nothing_is_nan() {
        assert_eq!(minimum([3.0, 1.0, 2.0]), 1.0);
        assert!(minimum([]).is_nan());
    }
}
