//! Which of many things a walk has come to, forgotten at no cost before the next walk.

/// Marks on things by their numbers.
#[derive(Debug, Clone)]
pub(super) struct Marks {
    /// The last walk that came to each.
    last: Vec<u32>,
    walk: u32,
}

impl Marks {
    /// For so many things, none of them marked.
    pub(super) fn new(count: usize) -> Self {
        Self { last: vec![0; count], walk: 1 }
    }

    /// Takes all marks away.
    pub(super) fn clear(&mut self) {
        self.walk += 1;
    }

    /// Marks a thing; whether it was not marked yet.
    pub(super) fn mark(&mut self, at: u32) -> bool {
        std::mem::replace(&mut self.last[at as usize], self.walk) != self.walk
    }

    /// Whether a thing is marked.
    pub(super) fn has(&self, at: u32) -> bool {
        self.last[at as usize] == self.walk
    }
}
