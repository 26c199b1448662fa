//! Work on many inputs on several cores.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Stack size of a thread in bytes, equal to that of a main thread.
const STACK: usize = 8 << 20;

/// The number of cores; 1 if it is unknown, or if threads are not supported.
pub(crate) fn cores() -> NonZero<usize> {
    thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN)
}

/// Works on all items, in their order, with up to `threads` at a time. The calling thread is one of them.
///
/// If no thread can be started, as in WebAssembly, the calling thread does all the work.
pub(crate) fn each<T: Sync>(threads: NonZero<usize>, items: &[T], work: impl Fn(usize, &T) + Sync) {
    let next = AtomicUsize::new(0);
    let run = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else { break };
            work(index, item);
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.get().min(items.len()) {
            if thread::Builder::new().stack_size(STACK).spawn_scoped(scope, run).is_err() {
                break;
            }
        }
        run();
    });
}
