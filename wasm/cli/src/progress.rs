//! Shows the progress of long work on a terminal: one line on standard error that is gone when the work ends.
//!
//! Short work shows nothing. A thread draws the line, because a stage of a solve may take seconds. Without threads, as
//! in WebAssembly, no progress is shown.

use std::io::{self, IsTerminal, Write};
use std::sync::{Mutex, MutexGuard};
use std::thread;
use std::time::{Duration, Instant};

/// Work that takes less time shows no progress.
const SILENCE: Duration = Duration::from_secs(1);
/// Time between two drawings.
const TICK: Duration = Duration::from_millis(100);
/// Clears the line and moves to its beginning.
const CLEAR: &str = "\r\u{1b}[K";

static LINE: Mutex<Line> = Mutex::new(Line { begun: None, text: String::new(), drawn: String::new() });

/// The line of a run.
struct Line {
    /// When the work began; `None` if progress is not shown.
    begun: Option<Instant>,
    text: String,
    /// The text on the terminal, if any.
    drawn: String,
}

impl Line {
    /// Draws the text if it has changed and enough time has passed.
    fn draw(&mut self, now: Instant, mut terminal: impl Write) {
        let is_time = self.begun.is_some_and(|begun| now.duration_since(begun) >= SILENCE);
        if is_time && self.text != self.drawn {
            // Progress that cannot be shown is no reason to stop the work.
            let _ = write!(terminal, "{CLEAR}{}", self.text).and_then(|()| terminal.flush());
            self.drawn.clone_from(&self.text);
        }
    }

    /// Removes the text from the terminal.
    fn clear(&mut self, mut terminal: impl Write) {
        self.text.clear();
        if !std::mem::take(&mut self.drawn).is_empty() {
            let _ = write!(terminal, "{CLEAR}").and_then(|()| terminal.flush());
        }
    }
}

/// Starts to show progress if standard error is a terminal.
pub(crate) fn begin() {
    if !io::stderr().is_terminal() {
        return;
    }
    let drawing = || loop {
        thread::sleep(TICK);
        line().draw(Instant::now(), io::stderr());
    };
    if thread::Builder::new().spawn(drawing).is_ok() {
        line().begun = Some(Instant::now());
    }
}

/// Sets the description of the current work.
pub(crate) fn show(text: &str) {
    let mut line = line();
    if line.begun.is_some() {
        text.clone_into(&mut line.text);
    }
}

/// Shows how many items are done.
pub(crate) fn count(things: &str, done: usize, of: usize) {
    show(&format!("{things} {done} of {of}"));
}

/// Clears the line, before anything else is written to the terminal.
pub(crate) fn clear() {
    line().clear(io::stderr());
}

/// The same where the line may be in use: for the end of the program.
pub(crate) fn clear_if_free() {
    if let Ok(mut line) = LINE.try_lock() {
        line.clear(io::stderr());
    }
}

fn line() -> MutexGuard<'static, Line> {
    LINE.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_appears_after_a_second_and_leaves_nothing_behind() {
        let begun = Instant::now();
        let mut line = Line { begun: Some(begun), text: "solving".into(), drawn: String::new() };
        let mut terminal = Vec::new();
        line.draw(begun + SILENCE / 2, &mut terminal);
        line.clear(&mut terminal);
        assert!(terminal.is_empty());
        line.text = "frame 1 of 2".into();
        line.draw(begun + SILENCE, &mut terminal);
        line.draw(begun + 2 * SILENCE, &mut terminal);
        line.clear(&mut terminal);
        assert_eq!(String::from_utf8(terminal).unwrap(), format!("{CLEAR}frame 1 of 2{CLEAR}"));
    }
}
