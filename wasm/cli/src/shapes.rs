//! Points in JSON files: GeoJSON, and landmarks in the forms of COCO, labelme and plain lists.
//!
//! The file comes out in the same form: only coordinates change. Coordinates are image pixels, from the upper left
//! corner of the picture.

use std::collections::HashSet;
use std::path::Path;

use glam::DVec2;
use serde_json::{Value, json};

use crate::error::CliError;

/// The new position of a point; `None` if it has no new position.
type Place<'a> = dyn FnMut(DVec2) -> Option<DVec2> + 'a;

/// A JSON file with points.
#[derive(Debug, Clone)]
pub(crate) struct Shapes {
    file: Value,
    form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    GeoJson,
    /// `{"points": …}` with a list or with names.
    Points,
    Labelme,
    Coco,
}

impl Shapes {
    /// Whether a file is JSON rather than CSV.
    pub(crate) fn is_json(bytes: &[u8]) -> bool {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        text.iter().find(|byte| !byte.is_ascii_whitespace()).is_some_and(|byte| b"{[".contains(byte))
    }

    pub(crate) fn parse(bytes: &[u8], path: &Path) -> Result<Self, CliError> {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let file: Value =
            serde_json::from_slice(text).map_err(|reason| CliError::ShapesJson { path: path.to_owned(), reason })?;
        let form = Form::of(&file).ok_or_else(|| CliError::ShapesForm { path: path.to_owned() })?;
        Ok(Self { file, form })
    }

    /// All points, in the order of the file.
    pub(crate) fn points(&self) -> Result<Vec<DVec2>, String> {
        let mut points = Vec::new();
        self.form.visit(&mut self.file.clone(), &mut |p| {
            points.push(p);
            Some(p)
        })?;
        Ok(points)
    }

    /// Returns the file with new positions of its points, in the same order.
    pub(crate) fn placed(mut self, places: impl IntoIterator<Item = Option<DVec2>>) -> Result<Value, String> {
        let mut places = places.into_iter();
        self.form.visit(&mut self.file, &mut |_| places.next().flatten())?;
        Ok(self.file)
    }
}

impl Form {
    fn of(file: &Value) -> Option<Self> {
        const GEOJSON: [&str; 9] = [
            "FeatureCollection",
            "Feature",
            "GeometryCollection",
            "Point",
            "MultiPoint",
            "LineString",
            "MultiLineString",
            "Polygon",
            "MultiPolygon",
        ];
        match file {
            _ if file["type"].as_str().is_some_and(|kind| GEOJSON.contains(&kind)) => Some(Self::GeoJson),
            _ if file["points"].is_array() || file["points"].is_object() => Some(Self::Points),
            _ if file["shapes"].is_array() => Some(Self::Labelme),
            _ if file["annotations"].is_array() => Some(Self::Coco),
            _ => None,
        }
    }

    fn visit(self, file: &mut Value, place: &mut Place<'_>) -> Result<(), String> {
        match self {
            Self::GeoJson => geojson(file, place, "").map(|_| ()),
            Self::Points => named_points(&mut file["points"], place, "points"),
            Self::Labelme => each(&mut file["shapes"], "shapes", |shape, path| {
                let path = format!("{path}.points");
                let points = shape.get_mut("points").ok_or_else(|| format!("{path}: expected a list"))?;
                named_points(points, place, &path)
            }),
            Self::Coco => {
                let annotations = file["annotations"].as_array().into_iter().flatten();
                if annotations.map(|annotation| &annotation["image_id"]).collect::<HashSet<_>>().len() > 1 {
                    return Err("annotations: they belong to several pictures: keep those of one".to_owned());
                }
                each(&mut file["annotations"], "annotations", |annotation, path| coco(annotation, place, path))
            }
        }
    }
}

/// Visits a GeoJSON object. Returns whether all of its points have positions.
fn geojson(object: &mut Value, place: &mut Place<'_>, path: &str) -> Result<bool, String> {
    let inner = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    // A box in the file would no longer be true.
    if let Some(members) = object.as_object_mut() {
        members.shift_remove("bbox");
    }
    match object["type"].as_str() {
        Some("FeatureCollection") => {
            each(&mut object["features"], &inner("features"), |feature, path| {
                geojson(feature, place, path).map(|_| ())
            })?;
            Ok(true)
        }
        Some("Feature") => {
            let geometry = &mut object["geometry"];
            if !geometry.is_null() && !geojson(geometry, place, &inner("geometry"))? {
                *geometry = Value::Null;
            }
            Ok(true)
        }
        Some("GeometryCollection") => {
            let mut is_whole = true;
            each(&mut object["geometries"], &inner("geometries"), |geometry, path| {
                is_whole &= geojson(geometry, place, path)?;
                Ok(())
            })?;
            Ok(is_whole)
        }
        Some(_) => positions(&mut object["coordinates"], place, &inner("coordinates")),
        None => Err(format!("{}: expected a GeoJSON object", if path.is_empty() { "type" } else { path })),
    }
}

/// Visits positions in lists of lists. Returns whether all of them have new positions.
fn positions(value: &mut Value, place: &mut Place<'_>, path: &str) -> Result<bool, String> {
    if value.as_array().is_some_and(|list| list.first().is_some_and(Value::is_number)) {
        let p = point(value, path)?;
        let found = place(p);
        if let Some(found) = found {
            (value[0], value[1]) = (json!(found.x), json!(found.y));
        }
        return Ok(found.is_some());
    }
    let mut is_whole = true;
    each(value, path, |inner, path| {
        is_whole &= positions(inner, place, path)?;
        Ok(())
    })?;
    Ok(is_whole)
}

/// Visits points in a list or by names. A point without a new position becomes null; null remains null.
fn named_points(points: &mut Value, place: &mut Place<'_>, path: &str) -> Result<(), String> {
    let mut visit = |value: &mut Value, path: &str| {
        if value.is_null() {
            return Ok(());
        }
        match place(point(value, path)?) {
            Some(found) => (value[0], value[1]) = (json!(found.x), json!(found.y)),
            None => *value = Value::Null,
        }
        Ok(())
    };
    match points {
        Value::Object(members) => {
            members.iter_mut().try_for_each(|(name, value)| visit(value, &format!("{path}.{name}")))
        }
        list => each(list, path, visit),
    }
}

/// Visits the keypoints, polygons and the box of a COCO annotation. The box becomes the bounding box of its four moved
/// sides.
fn coco(annotation: &mut Value, place: &mut Place<'_>, path: &str) -> Result<(), String> {
    if let Some(keypoints) = annotation.get_mut("keypoints") {
        let path = format!("{path}.keypoints");
        let list = keypoints.as_array_mut().filter(|list| list.len() % 3 == 0);
        for (at, triple) in list.ok_or(format!("{path}: expected x, y, visibility, …"))?.chunks_exact_mut(3).enumerate()
        {
            // Without visibility, a keypoint is not labelled.
            if triple[2].as_f64() != Some(0.0) {
                let found = place(flat_point(triple, &format!("{path}[{}]", 3 * at))?);
                let [x, y] = found.map_or([0.0; 2], |found| found.to_array());
                (triple[0], triple[1]) = (json!(x), json!(y));
                if found.is_none() {
                    triple[2] = json!(0);
                }
            }
        }
    }
    if annotation["segmentation"].is_array() {
        // A polygon of which a corner has no place would be a false one.
        let mut are_whole = Vec::new();
        each(&mut annotation["segmentation"], &format!("{path}.segmentation"), |polygon, path| {
            let mut is_whole = true;
            let list = polygon.as_array_mut().filter(|list| list.len() % 2 == 0);
            for (at, pair) in list.ok_or(format!("{path}: expected x, y, …"))?.chunks_exact_mut(2).enumerate() {
                match place(flat_point(pair, &format!("{path}[{}]", 2 * at))?) {
                    Some(found) => (pair[0], pair[1]) = (json!(found.x), json!(found.y)),
                    None => is_whole = false,
                }
            }
            are_whole.push(is_whole);
            Ok(())
        })?;
        let mut are_whole = are_whole.into_iter();
        annotation["segmentation"].as_array_mut().into_iter().for_each(|polygons| {
            polygons.retain(|_| are_whole.next().unwrap_or(true));
        });
    }
    if let Some(sides) = annotation.get("bbox").filter(|sides| !sides.is_null()).cloned() {
        let numbers: Vec<f64> = sides.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        let [x, y, width, height] = numbers[..] else {
            return Err(format!("{path}.bbox: expected x, y, width, height"));
        };
        let along = (0..=BOX_POINTS).map(|k| f64::from(k) / f64::from(BOX_POINTS));
        let sides = along.flat_map(|t| [(t, 0.0), (t, 1.0), (0.0, t), (1.0, t)]);
        let places = sides.map(|(u, v)| DVec2::new(x + u * width, y + v * height)).filter_map(place);
        let around = places.fold(None, |known: Option<[DVec2; 2]>, p| {
            Some(known.map_or([p, p], |[low, high]| [low.min(p), high.max(p)]))
        });
        annotation["bbox"] =
            around.map_or(Value::Null, |[low, high]| json!([low.x, low.y, high.x - low.x, high.y - low.y]));
    }
    Ok(())
}

/// Pieces of each side of a box.
const BOX_POINTS: u32 = 16;

fn each(
    list: &mut Value,
    path: &str,
    mut visit: impl FnMut(&mut Value, &str) -> Result<(), String>,
) -> Result<(), String> {
    let items = list.as_array_mut().ok_or_else(|| format!("{path}: expected a list"))?;
    items.iter_mut().enumerate().try_for_each(|(at, item)| visit(item, &format!("{path}[{at}]")))
}

fn point(value: &Value, path: &str) -> Result<DVec2, String> {
    let pair = value.as_array().filter(|pair| pair.len() >= 2);
    flat_point(pair.map_or(&[][..], |pair| &pair[..2]), path)
}

fn flat_point(numbers: &[Value], path: &str) -> Result<DVec2, String> {
    let number = |at: usize| numbers.get(at).and_then(Value::as_f64);
    let both = number(0).zip(number(1)).ok_or_else(|| format!("{path}: expected two numbers x, y"))?;
    Ok(both.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moves by 10 to the right; points at negative x have no place.
    fn moved(text: &str) -> Result<String, String> {
        let shapes = Shapes::parse(text.as_bytes(), Path::new("shapes.json")).map_err(|reason| reason.to_string())?;
        let points = shapes.points()?;
        let places = points.into_iter().map(|p| (p.x >= 0.0).then_some(p + DVec2::new(10.0, 0.0)));
        shapes.placed(places).map(|file| file.to_string())
    }

    #[test]
    fn geojson_keeps_properties_and_further_coordinates() {
        let collection = |members: &str, ring: &str, point: &str| {
            let area =
                format!(r#""id":7,"properties":{{"a":[1,2]}},"geometry":{{"type":"Polygon","coordinates":{ring}}}"#);
            let features = format!(r#"{{"type":"Feature",{area}}},{{"type":"Feature","geometry":{point}}}"#);
            format!(r#"{{"type":"FeatureCollection",{members}"features":[{features}]}}"#)
        };
        let beside = r#"{"type":"Point","coordinates":[-1,2]}"#;
        let text = collection(r#""bbox":[0,0,9,9],"#, "[[[1,2,5],[3,4],[1,2,5]]]", beside);
        let expected = collection("", "[[[11.0,2.0,5],[13.0,4.0],[11.0,2.0,5]]]", "null");
        assert_eq!(moved(&text).unwrap(), expected);
    }

    #[test]
    fn landmarks_keep_their_format() {
        for (text, expected) in [
            (
                r#"{"points":{"eye":[1,2],"ear":[-1,0]},"of":"cat"}"#,
                r#"{"points":{"eye":[11.0,2.0],"ear":null},"of":"cat"}"#,
            ),
            (r#"{"points":[[1,2],null]}"#, r#"{"points":[[11.0,2.0],null]}"#),
            (
                r#"{"shapes":[{"label":"a","points":[[1,2],[3,4]]}],"imageWidth":9}"#,
                r#"{"shapes":[{"label":"a","points":[[11.0,2.0],[13.0,4.0]]}],"imageWidth":9}"#,
            ),
            (
                r#"{"annotations":[{"keypoints":[0,0,0,1,2,2,-1,2,1],"bbox":[1,2,4,8]}]}"#,
                r#"{"annotations":[{"keypoints":[0,0,0,11.0,2.0,2,0.0,0.0,0],"bbox":[11.0,2.0,4.0,8.0]}]}"#,
            ),
            (
                r#"{"annotations":[{"segmentation":[[-1,2,3,4],[1,2]],"bbox":[-9,2,4,8]}]}"#,
                r#"{"annotations":[{"segmentation":[[11.0,2.0]],"bbox":null}]}"#,
            ),
        ] {
            assert_eq!(moved(text).as_deref(), Ok(expected));
        }
    }

    #[test]
    fn errors_name_the_position_in_the_file() {
        for (text, expected) in [
            (r#"{"points":{"eye":[1]}}"#, "points.eye: expected two numbers x, y"),
            (r#"{"type":"Polygon","coordinates":[[["a",2]]]}"#, "coordinates[0][0][0]: expected a list"),
            (r#"{"annotations":[{"keypoints":[1,2]}]}"#, "annotations[0].keypoints: expected x, y, visibility, …"),
            (
                r#"{"annotations":[{"image_id":1},{"image_id":2}]}"#,
                "annotations: they belong to several pictures: keep those of one",
            ),
            (r#"{"type":"Feature","geometry":{"type":"Point"}}"#, "geometry.coordinates: expected a list"),
        ] {
            assert_eq!(moved(text), Err(expected.to_owned()));
        }
        assert!(moved(r#"{"a":1}"#).is_err() && moved("{").is_err());
        assert!(Shapes::is_json(b" [[1, 2]]") && moved("[[1, 2]]").is_err() && !Shapes::is_json(b"x,y\n1,2"));
    }
}
