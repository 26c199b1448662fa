//! Results that several inputs share, such as one decoded picture, or one solution for many poses.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The latest results by their keys. Threads that need the same result wait for the one that computes it.
pub(crate) struct Shared<K, V> {
    entries: Mutex<Vec<(K, Entry<V>)>>,
    most: usize,
}

/// `None` before the result is available.
type Entry<V> = Arc<OnceLock<Option<Arc<V>>>>;

impl<K: PartialEq, V> Shared<K, V> {
    /// Keeps up to `most` results, so that memory is bounded.
    pub(crate) fn new(most: usize) -> Self {
        Self { entries: Mutex::new(Vec::new()), most }
    }

    /// Returns the result for a key, and computes it if it is not kept. Every input that shares an error gets its own
    /// copy.
    pub(crate) fn get<E>(&self, key: K, make: impl Fn() -> Result<V, E>) -> Result<Arc<V>, E> {
        let entry = self.entry(key);
        let mut refused = None;
        let made = entry.get_or_init(|| make().map(Arc::new).map_err(|error| refused = Some(error)).ok());
        match (made, refused) {
            (Some(value), _) => Ok(Arc::clone(value)),
            (None, Some(error)) => Err(error),
            (None, None) => make().map(Arc::new),
        }
    }

    fn entry(&self, key: K) -> Entry<V> {
        let mut entries = self.entries.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(at) = entries.iter().position(|(known, _)| *known == key) {
            // The latest stay.
            entries[at..].rotate_left(1);
        } else {
            if entries.len() == self.most {
                entries.remove(0);
            }
            entries.push((key, Entry::default()));
        }
        entries.last().map(|(_, entry)| Arc::clone(entry)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::Shared;

    #[test]
    fn results_are_computed_once_and_errors_every_time() {
        let (shared, made) = (Shared::new(2), Cell::new(0));
        let get = |key: u32| {
            let make = || {
                made.set(made.get() + 1);
                if key == 9 { Err("nine") } else { Ok(key * 10) }
            };
            shared.get(key, make).map(|value| *value)
        };
        assert_eq!([1, 2, 1, 2, 1].map(get), [10, 20, 10, 20, 10].map(Ok));
        assert_eq!(made.get(), 2);
        // The third key takes the place of the second, which was used before the first.
        assert_eq!([3, 1, 2].map(get), [30, 10, 20].map(Ok));
        assert_eq!(made.get(), 4);
        assert_eq!([9, 9].map(get), [Err("nine"); 2]);
        assert_eq!(made.get(), 6);
    }
}
