//! How long something takes: the least of many runs, after some that do not count.
//!
//! The first runs pay for memory that is not mapped yet, and in a page for code that is not optimised yet. Whatever else a
//! machine does only ever adds to a time, on shared ones more than half for seconds on end: so the least is what the program
//! itself takes, and the one figure that is much the same in two runs.

use crate::clock::Clock;

/// How much work goes into one figure.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Runs that do not count go on for this long; there is at least one.
    pub warm_up_ms: f64,
    /// Runs that count go on for this long.
    pub measured_ms: f64,
    /// The least number of runs that count.
    pub least_runs: usize,
}

impl Effort {
    /// For figures to be printed.
    pub const FULL: Self = Self { warm_up_ms: 250.0, measured_ms: 600.0, least_runs: 5 };
    /// For trying out whether a case runs at all.
    pub const TRIAL: Self = Self { warm_up_ms: 0.0, measured_ms: 0.0, least_runs: 1 };
}

/// What each run that counts has to tell.
///
/// # Errors
/// The first error of a run.
pub fn runs<T, E>(clock: Clock, effort: Effort, mut run: impl FnMut() -> Result<T, E>) -> Result<Vec<T>, E> {
    let start = clock();
    loop {
        once(&mut run)?;
        if clock() - start >= effort.warm_up_ms {
            break;
        }
    }
    let start = clock();
    let mut told = Vec::new();
    while told.len() < effort.least_runs.max(1) || clock() - start < effort.measured_ms {
        told.push(once(&mut run)?);
    }
    Ok(told)
}

/// One run, as a call of its own: pages go over to optimised code where a function is called, not while one runs.
#[inline(never)]
fn once<T>(run: &mut impl FnMut() -> T) -> T {
    run()
}

/// The least time of a run that cannot fail.
pub fn least_ms(clock: Clock, effort: Effort, mut run: impl FnMut()) -> f64 {
    let timed = || {
        let start = clock();
        run();
        Ok::<_, std::convert::Infallible>(clock() - start)
    };
    match runs(clock, effort, timed) {
        Ok(times) => least(times),
    }
}

/// The least value; not a number where there is none.
#[must_use]
pub fn least(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().reduce(f64::min).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    thread_local!(static NOW: Cell<f64> = const { Cell::new(0.0) });

    #[test]
    fn runs_until_there_are_enough_and_they_took_long_enough() {
        let effort = Effort { warm_up_ms: 25.0, measured_ms: 40.0, least_runs: 3 };
        for (duration, warm, counted) in [(10.0, 3, 4), (100.0, 1, 3)] {
            let mut all = 0;
            let told = runs(
                || NOW.get(),
                effort,
                || {
                    NOW.set(NOW.get() + duration);
                    all += 1;
                    Ok::<_, ()>(all)
                },
            );
            assert_eq!(told, Ok((warm + 1..=warm + counted).collect()));
        }
        assert_eq!(runs(|| NOW.get(), effort, || Err::<(), _>("no")), Err("no"));
    }

    #[test]
    fn nothing_has_no_least() {
        assert_eq!(least([3.0, 1.0, 2.0]), 1.0);
        assert!(least([]).is_nan());
    }
}
