//! The rotation of a handle.

/// The rotation of a handle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rotation {
    /// Degrees, clockwise on the screen, as y points down.
    Degrees(f64),
    /// Automatic: fitted to the surrounding handles.
    Auto,
}

impl Default for Rotation {
    fn default() -> Self {
        Self::Degrees(0.0)
    }
}

impl From<f64> for Rotation {
    fn from(degrees: f64) -> Self {
        Self::Degrees(degrees)
    }
}
