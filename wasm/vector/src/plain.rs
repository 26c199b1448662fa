//! A drawing in a plain form: paths, groups and definitions, as usvg writes it.

/// A drawing that can be bent.
#[derive(Debug, Clone)]
pub struct PlainDrawing {
    /// SVG as usvg writes it.
    pub(crate) text: String,
    size: [f64; 2],
}

impl PlainDrawing {
    /// A drawing by its plain text, and its width and height.
    #[must_use]
    pub fn new(text: String, size: [f64; 2]) -> Self {
        Self { text, size }
    }

    /// Width and height in its own units.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// The drawing at rest, as SVG with shapes as paths and with nothing that needs another file.
    #[must_use]
    pub fn plain_svg(&self) -> &str {
        &self.text
    }
}
