//! The mesh of a rig with its weights, as integers.
//!
//! Vertices are numbered by their first use in the triangles. So a corner is a small step back from the number of
//! vertices so far, and neighbours have similar numbers. Positions and weights are stored as differences from the
//! previous vertex.

use std::sync::Arc;

use glam::DVec2;

use super::{
    bytes::{Reader, Writer},
    error::RigError,
    skin::Skin,
    steps::{round, value},
};
use crate::{
    rank::{descending, sort_by_rank},
    weight::SparseWeights,
};

/// The finest steps: 2⁻¹⁶ pixels, and weights of 24 bits.
const MOST_PLACE_BITS: u8 = 16;
const MOST_WEIGHT_BITS: u8 = 24;

/// Vertices, triangles, and the rest positions of the sites that move them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mesh {
    /// Positions are multiples of 2 to the power of minus this, in pixels.
    pub(super) place_bits: u8,
    pub(super) vertices: Vec<[i32; 2]>,
    /// The displacement of each vertex before sites move it; `None` if nothing is displaced.
    pub(super) displacements: Option<Vec<[i32; 2]>>,
    /// In drawing order.
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) rest: Vec<[i32; 2]>,
}

/// The weights of the vertices.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Weights {
    /// The weights of a vertex sum to 2 to the power of this.
    pub(super) bits: u8,
    /// Vertices + 1.
    pub(super) offsets: Vec<u32>,
    pub(super) sites: Vec<u32>,
    pub(super) shares: Vec<u32>,
}

impl Mesh {
    /// A mesh with the given rest positions. `None` if a position is too far away.
    pub(super) fn rounded(at_rest: &[DVec2], skin: &Skin, triangles: &[[u32; 3]], place_bits: u8) -> Option<Self> {
        let place = |p: &DVec2| Some([round(p.x, place_bits)?, round(p.y, place_bits)?]);
        let places = |places: &[DVec2]| places.iter().map(place).collect::<Option<Vec<_>>>();
        let vertices = places(at_rest)?;
        let displaced = if at_rest == skin.vertices { None } else { Some(places(&skin.vertices)?) };
        let by = |(to, from): (&[i32; 2], &[i32; 2])| Some([to[0].checked_sub(from[0])?, to[1].checked_sub(from[1])?]);
        let displacements = displaced.map(|displaced| displaced.iter().zip(&vertices).map(by).collect::<Option<_>>());
        Some(Self {
            place_bits,
            displacements: match displacements {
                Some(displacements) => Some(displacements?),
                None => None,
            },
            vertices,
            triangles: triangles.to_vec(),
            rest: skin.rest.iter().map(place).collect::<Option<_>>()?,
        })
    }

    pub(super) fn skin(&self, weights: &Weights) -> Skin {
        Skin { weights: weights.sparse(), ..self.places() }
    }

    /// A skin without weights.
    pub(super) fn places(&self) -> Skin {
        let mut vertices = self.at_rest();
        for (vertex, by) in vertices.iter_mut().zip(self.displacements.iter().flatten()) {
            *vertex += self.place(by);
        }
        let rest = Arc::from_iter(self.rest.iter().map(|place| self.place(place)));
        Skin { vertices, weights: SparseWeights::with_capacity(0), rest }
    }

    /// The vertices at rest.
    pub(super) fn at_rest(&self) -> Vec<DVec2> {
        self.vertices.iter().map(|place| self.place(place)).collect()
    }

    fn place(&self, &[x, y]: &[i32; 2]) -> DVec2 {
        DVec2::new(value(x, self.place_bits), value(y, self.place_bits))
    }

    pub(super) fn write(&self, to: &mut Writer) {
        to.byte(self.place_bits);
        to.count(self.vertices.len());
        to.count(self.triangles.len());
        to.count(self.rest.len());
        [&self.vertices, &self.rest].into_iter().for_each(|places| write_places(places, to));
        let mut seen = 0;
        for &corner in self.triangles.iter().flatten() {
            to.varint(seen - corner);
            seen += u32::from(corner == seen);
        }
    }

    pub(super) fn read(from: &mut Reader<'_>) -> Result<Self, RigError> {
        let place_bits = from.byte()?;
        from.expect(place_bits <= MOST_PLACE_BITS, "stores positions with too many bits")?;
        let [vertices, triangles, sites] = [from.count(2)?, from.count(3)?, from.count(2)?];
        let vertices = read_places(from, vertices)?;
        let rest = read_places(from, sites)?;
        let mut seen = 0_u32;
        let mut corner = || {
            let back = from.varint()?;
            from.expect(back <= seen, "has a corner before the first vertex")?;
            let corner = seen - back;
            seen += u32::from(back == 0);
            Ok(corner)
        };
        let triangle = |_| Ok([corner()?, corner()?, corner()?]);
        let triangles = (0..triangles).map(triangle).collect::<Result<_, RigError>>()?;
        from.expect(seen as usize == vertices.len(), "has triangles that do not match its vertices")?;
        Ok(Self { place_bits, vertices, displacements: None, triangles, rest })
    }

    pub(super) fn write_displacements(&self, to: &mut Writer) {
        self.displacements.iter().for_each(|by| write_places(by, to));
    }

    pub(super) fn read_displacements(&mut self, from: &mut Reader<'_>) -> Result<(), RigError> {
        from.expect(from.has(self.vertices.len().checked_mul(2)), "ends too early")?;
        self.displacements = Some(read_places(from, self.vertices.len())?);
        Ok(())
    }
}

pub(super) fn write_places(places: &[[i32; 2]], to: &mut Writer) {
    for axis in 0..2 {
        let mut before = 0_i32;
        for place in places {
            to.signed(place[axis].wrapping_sub(before));
            before = place[axis];
        }
    }
}

pub(super) fn read_places(from: &mut Reader<'_>, count: usize) -> Result<Vec<[i32; 2]>, RigError> {
    let mut places = vec![[0; 2]; count];
    for axis in 0..2 {
        let mut before = 0_i32;
        for place in &mut places {
            before = before.wrapping_add(from.signed()?);
            place[axis] = before;
        }
    }
    Ok(places)
}

impl Weights {
    pub(super) fn rounded(weights: &SparseWeights, bits: u8) -> Self {
        let mut rounded = Self { bits, offsets: vec![0], sites: Vec::new(), shares: Vec::new() };
        for vertex in 0..weights.len() {
            for (site, share) in shares(weights.row(vertex), 1 << bits) {
                rounded.sites.push(site);
                rounded.shares.push(share);
            }
            rounded.offsets.push(rounded.sites.len() as u32);
        }
        rounded
    }

    fn sparse(&self) -> SparseWeights {
        let weights = self.shares.iter().map(|&share| f64::from(share) / f64::from(1_u32 << self.bits)).collect();
        SparseWeights::from_parts(self.offsets.clone(), self.sites.clone(), weights).expect("rows of a mesh")
    }

    pub(super) fn write(&self, to: &mut Writer) {
        to.byte(self.bits);
        let rows = || self.offsets.windows(2).map(|row| row[0] as usize..row[1] as usize);
        rows().for_each(|row| to.count(row.len()));
        for row in rows() {
            let mut next = 0;
            for &site in &self.sites[row] {
                to.varint(site - next);
                next = site + 1;
            }
        }
        let mut before = 0..0;
        for row in rows() {
            // The first weight is 1 minus the others.
            for entry in row.clone().skip(1) {
                to.signed(self.shares[entry] as i32 - self.share_in(&before, self.sites[entry]) as i32);
            }
            before = row;
        }
    }

    pub(super) fn read(from: &mut Reader<'_>, vertices: usize, sites: usize) -> Result<Self, RigError> {
        let bits = from.byte()?;
        from.expect(bits <= MOST_WEIGHT_BITS, "have too many bits")?;
        from.expect(from.has(Some(vertices)), "end too early")?;
        let mut offsets = vec![0_u32];
        let mut entries = 0_usize;
        for _ in 0..vertices {
            entries = entries.saturating_add(from.varint()? as usize);
            from.expect(from.has(Some(entries)), "end too early")?;
            offsets.push(entries as u32);
        }
        let mut weights = Self { bits, offsets, sites: Vec::with_capacity(entries), shares: vec![0; entries] };
        for vertex in 0..vertices {
            let mut next = 0_usize;
            for _ in weights.offsets[vertex]..weights.offsets[vertex + 1] {
                let site = next.saturating_add(from.varint()? as usize);
                from.expect(site < sites, "refer to an unknown site")?;
                weights.sites.push(site as u32);
                next = site + 1;
            }
        }
        let whole = 1_i64 << bits;
        let mut before = 0..0;
        for vertex in 0..vertices {
            let row = weights.offsets[vertex] as usize..weights.offsets[vertex + 1] as usize;
            let mut left = whole;
            for entry in row.clone().skip(1) {
                let share = i64::from(weights.share_in(&before, weights.sites[entry])) + i64::from(from.signed()?);
                left -= share;
                from.expect(share >= 0 && left >= 0, "do not sum to 1")?;
                weights.shares[entry] = share as u32;
            }
            if let Some(first) = row.clone().next() {
                weights.shares[first] = left as u32;
            }
            before = row;
        }
        Ok(weights)
    }

    /// The weight of a site in a row, 0 if the row lacks it.
    fn share_in(&self, row: &std::ops::Range<usize>, site: u32) -> u32 {
        let at = self.sites[row.clone()].binary_search(&site);
        at.map_or(0, |at| self.shares[row.start + at])
    }
}

/// Rounds weights to integers with exactly this sum, by the largest remainders. Weights of 0 are left out.
pub(super) fn shares(row: impl Iterator<Item = (usize, f64)>, whole: u32) -> Vec<(u32, u32)> {
    let row: Vec<(usize, f64)> = row.collect();
    let sum: f64 = row.iter().map(|(_, weight)| weight).sum();
    let exact = |&(site, weight): &(usize, f64)| (site as u32, weight / sum * f64::from(whole));
    let mut shares: Vec<(u32, u32)> = row.iter().map(exact).map(|(site, share)| (site, share as u32)).collect();
    let mut by_remainder: Vec<usize> = (0..row.len()).collect();
    let remainder = |&at: &usize| exact(&row[at]).1.fract();
    sort_by_rank(&mut by_remainder, |at| [descending(remainder(at)), 0]);
    let given: u32 = shares.iter().map(|(_, share)| share).sum();
    for &at in by_remainder.iter().cycle().take(whole.saturating_sub(given) as usize * usize::from(!row.is_empty())) {
        shares[at].1 += 1;
    }
    shares.retain(|(_, share)| *share > 0);
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_sum_to_the_whole() {
        assert_eq!(
            shares([(0, 1.0 / 3.0), (1, 1.0 / 3.0), (4, 1.0 / 3.0)].into_iter(), 256),
            [(0, 86), (1, 85), (4, 85)]
        );
        assert_eq!(shares([(0, 1e-9), (7, 1.0)].into_iter(), 4096), [(7, 4096)]);
        assert_eq!(shares(std::iter::empty(), 4096), []);
    }
}
