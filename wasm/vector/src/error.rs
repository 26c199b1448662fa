//! Errors about drawings that cannot be read or bent.

/// Why a drawing was rejected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VectorError {
    /// The file is larger than [`MAX_BYTES`](crate::MAX_BYTES), perhaps after decompression.
    #[error("this drawing has more than {} MB: simplify it", most >> 20)]
    TooLarge {
        /// The limit in bytes.
        most: usize,
    },
    /// The file is not well-formed XML.
    #[error("this is not a drawing: {0}")]
    Xml(String),
    /// The root element is not `<svg>`.
    #[error("this is not a drawing: the first element is <{0}>, not <svg>")]
    Root(String),
    /// The number of elements and texts exceeds the limit, perhaps after copying used elements.
    #[error("this drawing has more than {most} elements: simplify it")]
    TooManyElements {
        /// The limit.
        most: u32,
    },
    /// An element has more attributes than the limit.
    #[error("an element of this drawing has more than {most} attributes: remove some")]
    TooManyAttributes {
        /// The limit.
        most: usize,
    },
    /// Copies of used paths and pictures have too many bytes.
    #[error("elements of this drawing are used too often: use smaller ones, or use them less")]
    TooManyCopies,
    /// Resolving the selectors or custom properties of style sheets takes too long.
    #[error("the style sheets of this drawing take too long: simplify them")]
    TooManyStyles,
    /// Drawing it would take too long, mostly for elements with this name.
    #[error("this drawing takes too long to draw, mostly because of its <{cause}>: simplify it")]
    TooSlow {
        /// The name of the elements.
        cause: &'static str,
    },
    /// Drawing it would take too much memory, mostly for elements with this name.
    #[error("this drawing takes too much memory to draw, mostly because of its <{cause}>: simplify it")]
    TooMuchMemory {
        /// The name of the elements.
        cause: &'static str,
    },
    /// Elements are nested too deeply.
    #[error("elements of this drawing are nested more than {most} deep: ungroup some")]
    TooDeep {
        /// The limit.
        most: usize,
    },
    /// The number of path segments exceeds the limit.
    #[error("the paths of this drawing have more than {most} nodes: simplify them")]
    TooManyNodes {
        /// The limit.
        most: usize,
    },
    /// A picture in the drawing has too many pixels.
    #[error("a picture in this drawing has more than {most} megapixels: use a smaller one")]
    PictureTooLarge {
        /// The limit.
        most: u64,
    },
    /// The drawing has neither a size nor a view box with an area.
    #[error("this drawing has no size: give it a width, a height or a viewBox")]
    NoSize,
}
