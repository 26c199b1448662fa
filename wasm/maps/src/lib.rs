//! A solved picture as numbers for other programs: maps of the warp, and the weights of sites and handles.
//!
//! The crate does not access files, so it also runs in a browser. The same input gives the same bytes.
//!
//! ```
//! use c2warp::{Picture, ResampleOptions, project::{Handle, Project}, solve};
//! use c2warp_maps::{Map, MapFormat, Maps};
//!
//! let rgba = vec![255; 40 * 30 * 4];
//! let picture = Picture::new(40, 30, &rgba)?;
//! let mut project = Project::for_picture(40, 30);
//! project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
//! let solution = solve(&project, &picture)?;
//! let pose = solution.pose(&project)?;
//! let drawing = solution.drawing(&picture, &pose, ResampleOptions::default())?;
//! let maps = Maps { solution: &solution, pose: &pose, picture, drawing: &drawing, name: "card.png" };
//! let file = maps.file(Map::Inverse, MapFormat::Exr, &mut |_| {})?;
//! assert_eq!(file[..4], [0x76, 0x2f, 0x31, 0x01]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - `maps`: the values of each map. `about`: their descriptions. `float_file`, `png_file`: the two formats.
//! - `weights`: tables of weights. `npy`: their binary format. `places`: the points of a table.
//! - `heat`: the weight of a handle as colours over the picture.

mod about;
mod error;
mod float_file;
mod heat;
mod maps;
mod npy;
mod number;
mod places;
mod png_file;
mod weights;

pub use error::{MapError, WeightsError};
pub use heat::{HEAT_RAMP, RampColour, heat_map};
pub use maps::{Map, MapFormat, Maps};
pub use number::decimal;
pub use places::Places;
pub use weights::{Columns, TableFormat, Weights};
