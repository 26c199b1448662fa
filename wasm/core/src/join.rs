//! Runs two computations on two cores.

/// The results of two computations. Natively, the first runs on another thread, in parallel with the second.
///
/// In WebAssembly, or if no thread can be started, they run one after the other. The computations are independent, so
/// the results are the same everywhere.
///
/// # Panics
/// If one of them panics.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn join<A: Send, B>(first: impl FnOnce() -> A + Send, second: impl FnOnce() -> B) -> (A, B) {
    use std::{sync::Mutex, thread};

    // A thread that cannot be started leaves it here.
    let open = Mutex::new(Some(first));
    let run = || open.lock().ok().and_then(|mut open| open.take()).map(|first| first());
    thread::scope(|scope| {
        let beside = thread::Builder::new().spawn_scoped(scope, run).ok();
        let second = second();
        let first = beside.map_or_else(run, |beside| beside.join().expect("the first computation does not panic"));
        (first.expect("it runs once"), second)
    })
}

#[cfg(target_family = "wasm")]
pub(crate) fn join<A, B>(first: impl FnOnce() -> A, second: impl FnOnce() -> B) -> (A, B) {
    (first(), second())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_results_are_returned() {
        let words = ["one", "three"];
        assert_eq!(join(|| words[0], || words[1].len()), ("one", 5));
    }
}
