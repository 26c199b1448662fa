//! Ids of handles: their names, or else their positions.
//!
//! The names of a mirrored picture are mirrored: only left and right are exchanged.

use glam::DVec2;

use super::placing::Place;
use crate::rank::{ascending, sort_by_rank};

/// Handles within this share of the width from the axis are on neither side of it.
const ON_AXIS: f64 = 0.03;
/// How much higher a handle must be to come before one that is farther out, as a share of that distance.
const OUTWARDS: f64 = 0.5;

/// Gives each handle an id: its name, or else its position in the bounding box, such as `top-left`. Places with equal
/// positions get sides if they lie on both sides of the axis. Equal names get numbers. No id reads like an id in
/// `taken`.
pub(super) fn ids(places: &[Place], low: DVec2, high: DVec2, taken: &[&str]) -> Vec<String> {
    let size = (high - low).max(DVec2::splat(1e-9));
    let shares: Vec<DVec2> = places.iter().map(|place| (place.at - low) / size).collect();
    let positions: Vec<String> = shares.iter().map(|at| position(at.y, third(at.x))).collect();
    let mut words: Vec<String> = places
        .iter()
        .zip(&positions)
        .map(|(place, position)| place.name.as_ref().unwrap_or(position).clone())
        .collect();
    for mut members in groups(&positions) {
        members.retain(|&k| places[k].name.is_none());
        if members.iter().all(|&k| (shares[k].x - 0.5).abs() > ON_AXIS) && is_on_both_sides(&members, &shares) {
            for k in members {
                words[k] = position(shares[k].y, if shares[k].x < 0.5 { "left" } else { "right" });
            }
        }
    }
    let mut known: Vec<String> = taken.iter().map(|id| read(id)).collect();
    let mut ids = vec![String::new(); words.len()];
    for mut members in groups(&words) {
        // From top to bottom, and at about the same height from the outside in.
        let key = |k: usize| shares[k].y - OUTWARDS * (shares[k].x - 0.5).abs();
        sort_by_rank(&mut members, |&k| [ascending(key(k)), ascending(shares[k].x)]);
        for k in members {
            let numbered =
                |number: usize| if number == 1 { words[k].clone() } else { format!("{}-{number}", words[k]) };
            ids[k] = (1..).map(numbered).find(|id| !known.contains(id)).expect("numbers do not end");
            known.push(ids[k].clone());
        }
    }
    ids
}

/// The indices of equal names.
fn groups(words: &[String]) -> Vec<Vec<usize>> {
    let equal = |k: usize| (0..words.len()).filter(move |&other| words[other] == words[k]);
    let first = (0..words.len()).filter(|&k| equal(k).next() == Some(k));
    first.map(|k| equal(k).collect()).collect()
}

fn is_on_both_sides(members: &[usize], shares: &[DVec2]) -> bool {
    let left = members.iter().filter(|&&k| shares[k].x < 0.5).count();
    left > 0 && left < members.len()
}

/// An id as displayed: editors show hyphens as spaces. The words here contain only ASCII letters.
fn read(id: &str) -> String {
    let letter = |letter| match letter {
        ',' => None,
        '_' | ' ' => Some('-'),
        other => Some(other.to_ascii_lowercase()),
    };
    id.trim().chars().filter_map(letter).collect()
}

/// The side of a position in the outer thirds of the width.
fn third(x: f64) -> &'static str {
    match x {
        x if x < 0.36 => "left",
        x if x > 0.64 => "right",
        _ => "",
    }
}

/// The words for a position, with heights from 0 to 1.
fn position(y: f64, side: &str) -> String {
    let height = match y {
        y if y < 0.36 => "top",
        y if y > 0.64 => "bottom",
        _ => "",
    };
    match (height, side) {
        ("", "") => "middle".to_owned(),
        ("", only) | (only, "") => only.to_owned(),
        _ => format!("{height}-{side}"),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::{super::SuggestedRole::Spread, Place, ids};

    fn named(places: &[([f64; 2], &str)], taken: &[&str]) -> Vec<String> {
        let name = |name: &str| (!name.is_empty()).then(|| name.to_owned());
        let place = |&(at, given): &([f64; 2], &str)| Place { at: at.into(), role: Spread, name: name(given) };
        let places: Vec<Place> = places.iter().map(place).collect();
        ids(&places, DVec2::ZERO, DVec2::splat(100.0), taken)
    }

    #[test]
    fn ids_contain_the_position_and_are_unique() {
        let places = [([5.0, 5.0], ""), ([8.0, 9.0], ""), ([50.0, 50.0], ""), ([50.0, 95.0], ""), ([3.0, 3.0], "head")];
        assert_eq!(named(&places, &[]), ["top-left", "top-left-2", "middle", "bottom", "head"]);
    }

    #[test]
    fn mirrored_positions_have_mirrored_ids() {
        let legs = [(8.0, 90.0), (30.0, 95.0), (44.0, 86.0), (56.0, 86.0), (70.0, 95.0), (92.0, 90.0)];
        let end = |(x, y): (f64, f64)| ([x, y], "");
        let mirrored = |(x, y): (f64, f64)| end((100.0 - x, y));
        let exchanged = |id: &String| id.replace("left", "?").replace("right", "left").replace('?', "right");
        let ids = named(&legs.map(end), &[]);
        assert_eq!(ids.iter().map(exchanged).collect::<Vec<_>>(), named(&legs.map(mirrored), &[]));
        assert!(ids.iter().all(|id| id.contains("left") != id.contains("right")), "{ids:?}");
    }

    #[test]
    fn ids_do_not_read_like_taken_ones() {
        let places = [([5.0, 5.0], ""), ([50.0, 50.0], "left-arm-end")];
        assert_eq!(named(&places, &["Top left", "Left arm, end"]), ["top-left-2", "left-arm-end-2"]);
    }
}
