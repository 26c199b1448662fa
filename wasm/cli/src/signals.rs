//! Interruptions by INT, TERM and HUP. They wait while a result gets its name, so that none leaves half of it behind.
//!
//! The signals are blocked in all threads but one, which takes them. It lets the system act as it would have acted: an
//! interrupted program ends by the signal, and one that ignores it goes on. WebAssembly has no signals.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Locked while no signal may end the program.
static NAMING: Mutex<()> = Mutex::new(());

/// Defers interruptions until the guard is dropped.
pub(crate) fn defer() -> MutexGuard<'static, ()> {
    NAMING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Begins to take signals. Threads that were started before would still be ended by them.
#[cfg(unix)]
pub(crate) fn begin() {
    use nix::sys::signal::{SigSet, Signal, raise};

    let signals = SigSet::from_iter([Signal::SIGINT, Signal::SIGTERM, Signal::SIGHUP]);
    let take = move || {
        while let Ok(signal) = signals.wait() {
            let _deferred = defer();
            let only = SigSet::from_iter([signal]);
            if only.thread_unblock().and_then(|()| raise(signal)).and_then(|()| only.thread_block()).is_err() {
                break;
            }
        }
    };
    if signals.thread_block().is_ok() && std::thread::Builder::new().spawn(take).is_err() {
        let _ = signals.thread_unblock();
    }
}

#[cfg(not(unix))]
pub(crate) fn begin() {}
