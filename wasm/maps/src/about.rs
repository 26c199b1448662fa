//! Descriptions of the maps, for the headers of their files.

use c2warp::Extent;

use crate::maps::{Map, MapFormat, Maps};

/// Describes a map and its channels.
pub(crate) fn about(maps: &Maps<'_>, map: Map, format: MapFormat) -> String {
    let Extent { origin: [x, y], width, height } = maps.drawing.extent();
    let (name, scale) = (maps.name, maps.drawing.scale());
    let picture = format!("the picture \"{name}\" of {} x {} pixels", maps.picture.width(), maps.picture.height());
    let warped = format!("the warped picture of {width} x {height} pixels");
    let origin = format!(
        "In the warped picture, the upper left corner of the picture is {x} pixels from the left and {y} from the top, \
         and the scale is {scale}."
    );
    let uv = |of: &str| {
        format!(
            "Red is u to the right and green is v upwards, from 0 to 1 across {of}. The origin is its lower left corner, \
             and the centre of a pixel lies half a pixel from its edges."
        )
    };
    let channels = match (map, format) {
        (Map::Inverse, MapFormat::Exr) => " Blue is the growth of areas, and alpha the covered part of the pixel.",
        (Map::Inverse, MapFormat::Png) => " Alpha is the covered part of the pixel.",
        (Map::Forward, MapFormat::Exr) => " Alpha is 0 where the picture has no position.",
        (Map::Forward, MapFormat::Png) => " Alpha is 0 where the picture has no position, or one outside.",
        (Map::Stretch, MapFormat::Exr) => "",
        (Map::Stretch, MapFormat::Png) => {
            " The level is 0.5 + log2(growth) / 8: half of 65535 where nothing grows, 0 where the picture is turned over."
        }
        (Map::Disocclusion, _) => "",
    };
    let values = match map {
        Map::Inverse => format!(
            "Inverse ST map by c2warp: for each pixel of {warped}, the position in {picture} that it shows. {}",
            uv("the picture")
        ),
        Map::Forward => format!(
            "Forward ST map by c2warp: for each pixel of {picture}, its position in {warped}. {}",
            uv("the warped picture")
        ),
        Map::Stretch => format!(
            "Stretch map by c2warp, of {warped} made from {picture}. Red is the growth of areas, green and blue are the \
             greatest and the least growth of lengths. Alpha is the covered part of the pixel."
        ),
        Map::Disocclusion => format!(
            "Disocclusion mask by c2warp, of {warped} made from {picture}. Red is uncovered: the picture was there, and \
             nothing is drawn now. Green is covered: something is drawn where the picture had nothing."
        ),
    };
    format!("{values}{channels} {origin}")
}
