//! Drawings that cannot be read or bent.

/// Why a drawing was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VectorError {
    /// The file is larger than [`MAX_BYTES`](crate::MAX_BYTES), perhaps once it is unpacked.
    #[error("this drawing has more than {} MB: simplify it", most >> 20)]
    TooLarge {
        /// The limit in bytes.
        most: usize,
    },
    /// The file is no well-formed XML.
    #[error("this is not a drawing: {0}")]
    Xml(String),
    /// The root is another element.
    #[error("this is not a drawing: the first element is <{0}>, not <svg>")]
    Root(String),
    /// More elements and texts than the limit, perhaps after copies were made of elements in use.
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
    /// Paths and pictures in use have too many bytes, once copies are made of them.
    #[error("elements of this drawing are used too often: use smaller ones, or use them less")]
    TooManyCopies,
    /// Selectors or custom properties of style sheets take too long.
    #[error("the style sheets of this drawing take too long: simplify them")]
    TooManyStyles,
    /// It would take too long to draw, most of all for elements of this name.
    #[error("this drawing takes too long to draw, most of all its <{cause}>: simplify it")]
    TooSlow {
        /// The name of the elements.
        cause: &'static str,
    },
    /// It would take too much memory to draw, most of all for elements of this name.
    #[error("this drawing takes too much memory to draw, most of all its <{cause}>: simplify it")]
    TooMuchMemory {
        /// The name of the elements.
        cause: &'static str,
    },
    /// Elements lie in one another too deeply.
    #[error("elements of this drawing are nested more than {most} deep: ungroup some")]
    TooDeep {
        /// The limit.
        most: usize,
    },
    /// More segments of paths than the limit.
    #[error("the paths of this drawing have more than {most} nodes: simplify them")]
    TooManyNodes {
        /// The limit.
        most: usize,
    },
    /// Neither a size nor a view box with an area.
    #[error("this drawing has no size: give it a width, a height or a viewBox")]
    NoSize,
}
