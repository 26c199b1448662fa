//! Drawings that cannot be read or bent.

/// Why a drawing was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VectorError {
    /// The file is larger than [`MAX_BYTES`](crate::drawing::MAX_BYTES).
    #[error("this drawing has {bytes} bytes: at most {most} are read")]
    TooLarge {
        /// Its size.
        bytes: usize,
        /// The limit.
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
    /// A picture in the drawing has more pixels than any picture may have.
    #[error("a picture in this drawing has more than {most} megapixels: use a smaller one")]
    PictureTooLarge {
        /// The limit.
        most: u64,
    },
    /// Neither a size nor a view box with an area.
    #[error("this drawing has no size: give it a width, a height or a viewBox")]
    NoSize,
}
