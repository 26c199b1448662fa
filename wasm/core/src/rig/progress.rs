//! The progress of baking.

/// Number of progress reports.
const STEP: f64 = 0.01;

/// Counts frames: each is posed once, ordered once and compared once.
pub(super) struct Progress<'a> {
    all: f64,
    done: f64,
    reported: f64,
    report: &'a mut dyn FnMut(f64),
}

impl<'a> Progress<'a> {
    /// Progress for the frames of all clips.
    pub(super) fn new(frames: usize, report: &'a mut dyn FnMut(f64)) -> Self {
        Self { all: 3.0 * frames as f64, done: 0.0, reported: 0.0, report }
    }

    /// Adds frames that were posed, ordered or compared.
    pub(super) fn add(&mut self, frames: usize) {
        self.done += frames as f64;
        let part = (self.done / self.all).min(1.0);
        if part >= self.reported + STEP {
            self.reported = part;
            (self.report)(part);
        }
    }
}
