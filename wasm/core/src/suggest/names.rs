//! Names of handles by where they lie.

use std::collections::HashMap;

use glam::DVec2;

/// Gives each handle an id by its place in a rectangle and its role, such as `top-left-end`. Equal ids get numbers.
pub(super) fn ids(places: &[(DVec2, &str)], low: DVec2, high: DVec2) -> Vec<String> {
    let words = places.iter().map(|&(p, role)| named((p - low) / (high - low).max(DVec2::splat(1e-9)), role));
    let mut counts: HashMap<String, usize> = HashMap::new();
    words
        .map(|word| {
            let count = counts.entry(word.clone()).or_default();
            *count += 1;
            if *count == 1 { word } else { format!("{word}-{count}") }
        })
        .collect()
}

/// The name of a place, with coordinates from 0 to 1.
fn named(at: DVec2, role: &str) -> String {
    let third = |t: f64, names: [&'static str; 2]| match t {
        t if t < 0.36 => names[0],
        t if t > 0.64 => names[1],
        _ => "",
    };
    let words = [third(at.y, ["top", "bottom"]), third(at.x, ["left", "right"])];
    let middle = if words == ["", ""] && role != "middle" { "middle" } else { "" };
    let words = if role == "middle" { ["", ""] } else { words };
    let words = [words[0], words[1], middle, role];
    words.iter().filter(|word| !word.is_empty()).copied().collect::<Vec<_>>().join("-")
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::ids;

    #[test]
    fn ids_tell_the_place_and_are_unique() {
        let places = [([5.0, 5.0], "end"), ([8.0, 9.0], "end"), ([50.0, 50.0], "middle"), ([50.0, 95.0], "joint")];
        let places: Vec<(DVec2, &str)> = places.into_iter().map(|(p, role)| (p.into(), role)).collect();
        let ids = ids(&places, DVec2::ZERO, DVec2::splat(100.0));
        assert_eq!(ids, ["top-left-end", "top-left-end-2", "middle", "bottom-joint"]);
    }
}
