//! The size and the times of a film.

use std::io;

/// The size of all frames, and their times.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    /// Width in pixels, above 0.
    pub width: u32,
    /// Height in pixels, above 0.
    pub height: u32,
    /// Number of frames, above 0.
    pub frames: u32,
    /// Frames a second, above 0.
    pub rate: f64,
    /// How often the film runs.
    pub plays: Plays,
    /// ICC profile of the colours; `None` for sRGB. GIFs and sheets have no profile.
    pub profile: Option<Vec<u8>>,
}

/// How often a film runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plays {
    /// Once. It ends with its last frame.
    Once,
    /// Again and again.
    Endlessly,
}

impl Film {
    /// How long a frame is shown, in whole units; a second has `units` of them. Rounding errors do not accumulate:
    /// frame k ends at (k + 1) / rate, within half a unit.
    #[must_use]
    pub fn delay(&self, frame: u32, units: u32) -> u32 {
        let end = |frame: u32| (f64::from(frame) * f64::from(units) / self.rate).round();
        (end(frame + 1) - end(frame)) as u32
    }

    /// Number of bytes of a frame.
    pub(crate) fn frame_bytes(&self) -> usize {
        4 * self.width as usize * self.height as usize
    }

    /// # Errors
    /// If the bytes are not a frame of this film.
    pub(crate) fn check(&self, rgba: &[u8]) -> io::Result<()> {
        if rgba.len() == self.frame_bytes() {
            Ok(())
        } else {
            Err(io::Error::new(io::ErrorKind::InvalidInput, "the size of the frame differs from that of the film"))
        }
    }
}

/// Writes a film from its frames.
pub trait Encoder {
    /// Adds the next frame: straight RGBA, rows from top to bottom.
    ///
    /// # Errors
    /// If the frame and the film differ in size, or the output fails.
    fn add(&mut self, rgba: &[u8]) -> io::Result<()>;

    /// Completes the film, after its last frame.
    ///
    /// # Errors
    /// If frames are missing, or the output fails.
    fn finish(self: Box<Self>) -> io::Result<()>;
}

#[cfg(test)]
mod tests {
    use super::{Film, Plays};

    #[test]
    fn delays_add_up_to_the_duration() {
        for (rate, units) in [(30.0, 100), (24.0, 100), (23.976, 1000), (60.0, 1000), (1.0, 100)] {
            let film = Film { width: 1, height: 1, frames: 90, rate, plays: Plays::Once, profile: None };
            let sum: u32 = (0..film.frames).map(|frame| film.delay(frame, units)).sum();
            let wanted = 90.0 / rate * f64::from(units);
            assert!((f64::from(sum) - wanted).abs() <= 0.5, "{rate}: {sum} instead of {wanted}");
        }
    }
}
