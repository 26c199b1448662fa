//! Checks whether a mesh with a skirt draws a whole picture at rest.
//!
//! Each pixel is sampled at 4 × 4 points, as in the rasteriser. The number of triangles that cover a point is the
//! number of edges to its left, counted with their direction. Edges between two triangles cancel out, and are left out.
//!
//! Cost: n log n for the edges in each row of points, and a visit of the visible pixels outside. It stops at the first
//! pixel that is drawn wrongly.

use glam::DVec2;

use super::skirt::Skirt;
use crate::opacity::Opacity;

/// Number of previous edges with which an edge along the outline may cancel out.
const RECENT: usize = 6;
/// Corners are rounded to 1/256 px, as the rasteriser does.
const SUBPIXELS: f64 = 256.0;
/// Number of sample points along the side of a pixel.
const PLACES: i64 = 4;
/// Distance between sample points in subpixels. The first one lies half of this inside the pixel.
const STEP: i64 = 64;
/// Greatest error of a pixel, in levels. With rounding it is one level.
const MAX_ERROR: f32 = 0.75;

/// Whether the mesh inside the `outline` of samples and its skirt draw every visible pixel exactly once.
pub(super) fn shows_all(samples: &[DVec2], outline: &[Vec<u32>], skirt: &Skirt, opacity: &Opacity) -> bool {
    let edges = edges(samples, outline, skirt);
    let [width, height] = opacity.size().to_array().map(|side| side as i64);
    let mut errors = vec![0.0; width as usize];
    let (mut next, mut crossed, mut crossings) = (0, Vec::<Edge>::new(), Vec::new());
    for row in 0..height * PLACES {
        if row % PLACES == 0 {
            errors.fill(0.0);
        }
        let y = row * STEP + STEP / 2;
        while let Some(edge) = edges.get(next).filter(|edge| edge.top[1] <= y) {
            crossed.push(*edge);
            next += 1;
        }
        crossed.retain(|edge| edge.bottom[1] > y);
        crossings.clear();
        crossings.extend(crossed.iter().map(|edge| (edge.first_place(y).clamp(0, width * PLACES), edge.turn)));
        crossings.sort_unstable();
        let (mut from, mut count) = (0, 0);
        for &(to, turn) in crossings.iter().chain(&[(width * PLACES, 0)]) {
            if from < to && count != 1 {
                let pixel = |place: i64| (place / PLACES) as u32;
                for x in opacity.visible((row / PLACES) as u32, pixel(from), pixel(to - 1) + 1) {
                    let left = i64::from(x) * PLACES;
                    let places = to.min(left + PLACES) - from.max(left);
                    let level = f32::from(opacity.level(x, (row / PLACES) as u32));
                    // Drawn over itself, a pixel becomes more opaque.
                    let error = if count == 0 { level } else { level * (1.0 - level / 255.0) * (count - 1) as f32 };
                    let sum = &mut errors[x as usize];
                    *sum += error.abs() * places as f32 / (PLACES * PLACES) as f32;
                    if *sum > MAX_ERROR {
                        return false;
                    }
                }
            }
            from = from.max(to);
            count += turn;
        }
    }
    true
}

/// The edges of the outline and the skirt that do not cancel out, from top to bottom.
fn edges(samples: &[DVec2], outline: &[Vec<u32>], skirt: &Skirt) -> Vec<Edge> {
    let mut edges = Vec::new();
    let mut walls = outline
        .iter()
        .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)))
        .map(|(&a, &b)| [a, b].map(|v| rounded(samples[v as usize])));
    for (at, triangle) in skirt.triangles.iter().enumerate() {
        // Two triangles lie beside each segment of the outline.
        if at % 2 == 0 {
            walls.next().into_iter().for_each(|wall| add(&mut edges, wall));
        }
        let [a, b, c] = triangle.map(|v| rounded(skirt.place(samples, v)));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let [b, c] = if area < 0 { [c, b] } else { [b, c] };
        [[a, b], [b, c], [c, a]].into_iter().for_each(|ends| add(&mut edges, ends));
    }
    walls.for_each(|wall| add(&mut edges, wall));
    edges.sort_unstable_by_key(|edge| edge.top[1]);
    edges
}

/// Adds the edge of a polygon of positive area, unless it cancels out with one of the last edges.
fn add(edges: &mut Vec<Edge>, [from, to]: [[i64; 2]; 2]) {
    let Some(edge) = Edge::new(from, to) else { return };
    let cancels = |other: &Edge| (other.top, other.bottom, other.turn) == (edge.top, edge.bottom, -edge.turn);
    match edges.iter().rev().take(RECENT).position(cancels) {
        Some(back) => drop(edges.remove(edges.len() - 1 - back)),
        None => edges.push(edge),
    }
}

fn rounded(p: DVec2) -> [i64; 2] {
    (p * SUBPIXELS).round().to_array().map(|x| x as i64)
}

/// An edge that a row of sample points may cross, in subpixels.
#[derive(Clone, Copy)]
struct Edge {
    top: [i64; 2],
    bottom: [i64; 2],
    /// 1 if the inside lies to the right, otherwise −1.
    turn: i64,
}

impl Edge {
    /// The edge of a polygon of positive area.
    fn new(from: [i64; 2], to: [i64; 2]) -> Option<Self> {
        (from[1] != to[1]).then(|| {
            if from[1] < to[1] {
                Self { top: from, bottom: to, turn: -1 }
            } else {
                Self { top: to, bottom: from, turn: 1 }
            }
        })
    }

    /// The first sample point of a row on the edge or to the right of it.
    fn first_place(&self, y: i64) -> i64 {
        let [dx, dy] = [0, 1].map(|axis| self.bottom[axis] - self.top[axis]);
        let right = (self.top[0] - STEP / 2) * dy + dx * (y - self.top[1]);
        -(-right).div_euclid(STEP * dy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Picture;

    /// A square from 4 to 12 px in a picture of 20 × 20 px, with one more triangle outside.
    fn shows(alpha: impl Fn(u32, u32) -> u8, outside: [[f64; 2]; 3]) -> bool {
        let corners = [[4.0, 4.0], [12.0, 4.0], [12.0, 12.0], [4.0, 12.0]].map(DVec2::from);
        let vertices = outside.map(DVec2::from).into();
        let skirt = Skirt { vertices, owners: vec![0; 3], triangles: vec![[4, 5, 6]] };
        let rgba: Vec<u8> = (0..400).flat_map(|i| [0, 0, 0, alpha(i % 20, i / 20)]).collect();
        shows_all(&corners, &[vec![0, 1, 2, 3]], &skirt, &Opacity::new(&Picture::new(20, 20, &rgba).unwrap()))
    }

    fn in_square(x: u32, y: u32) -> bool {
        (4..12).contains(&x) && (4..12).contains(&y)
    }

    #[test]
    fn visible_pixels_must_be_covered_once() {
        let beside = [[12.0, 4.0], [20.0, 4.0], [12.0, 12.0]];
        let turned = [[12.0, 4.0], [12.0, 12.0], [20.0, 4.0]];
        let square = |x, y| if in_square(x, y) { 255 } else { 0 };
        let with = |at: (u32, u32), level: u8| move |x: u32, y: u32| if (x, y) == at { level } else { square(x, y) };
        for outside in [beside, turned] {
            assert!(shows(square, outside));
            assert!(shows(with((13, 5), 200), outside) && shows(with((17, 16), 1), outside));
            assert!(!shows(with((17, 16), 2), outside));
            assert!(!shows(with((3, 5), 30), outside));
            // Half of the pixel is covered.
            assert!(!shows(with((16, 7), 40), outside));
        }
    }

    #[test]
    fn translucent_pixels_must_not_be_covered_twice() {
        let over = [[6.0, 6.0], [11.0, 6.0], [6.0, 11.0]];
        assert!(shows(|x, y| if in_square(x, y) { 255 } else { 0 }, over));
        assert!(!shows(|x, y| if in_square(x, y) { 250 } else { 0 }, over));
    }
}
