//! The shares of handles in the motions of sites, which let a page pose the handles without a solver.
//!
//! Only the harmonic mode has shares: its motions are sums of handle motions (eq. 4). The rigid mode minimises an
//! energy for each pose.

use glam::DVec2;

use super::{
    ascending::{read_rows, write_rows},
    bytes::{Reader, Writer},
    driven::{Driven, driven_by, read_driven, write_driven},
    error::RigError,
    mesh::shares,
    sources::{Sources, turns_by_itself},
};
use crate::{
    pose::{Motion, Poser},
    project::Handle,
    rank::sort_by_rank,
};

/// The finest steps.
const MOST_BITS: u8 = 24;

/// The handles of a rig, and their shares in the motions of its sites.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shares {
    pub(super) sources: Sources,
    sites: Vec<Driven>,
    /// Shares are multiples of 2 to the power of minus this.
    bits: u8,
    /// One row for each virtual site.
    rows: Vec<Vec<Share>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Share {
    source: u32,
    share: u32,
    /// The position along the bone of the sites behind the share: a fraction in the same steps.
    along: u32,
}

/// The shares of a solution.
pub(super) struct ExactShares {
    sources: Sources,
    sites: Vec<Driven>,
    /// For each virtual site, its sources, ascending, with share and fraction along.
    rows: Vec<Vec<(u32, f64, f64)>>,
}

impl ExactShares {
    /// `None` if poses need a solver: in the rigid mode, and with automatic rotations.
    pub(super) fn of(poser: &Poser, handles: &[Handle]) -> Option<Self> {
        if poser.is_rigid() || handles.is_empty() || handles.iter().any(turns_by_itself) {
            return None;
        }
        let sources = Sources::new(handles, poser.skeleton());
        let count = handles.len() as u32;
        let sites = driven_by(poser.kinds(), &sources);
        let along = |site: usize, source: u32| match source.checked_sub(count) {
            None => 0.0,
            Some(bone) => {
                let [a, b] = sources.skeleton.bones[bone as usize].rest;
                ((poser.rest()[site] - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0)
            }
        };
        let row = |row: &Vec<(u32, f64)>| {
            let from = |&(site, weight): &(u32, f64)| match sites[site as usize] {
                Driven::Source(source) => Some((source, weight, weight * along(site as usize, source))),
                Driven::Still | Driven::Virtual => None,
            };
            let mut parts: Vec<_> = row.iter().filter_map(from).collect();
            sort_by_rank(&mut parts, |&(source, ..)| [source.into(), 0]);
            let of_source = |parts: &[(u32, f64, f64)]| {
                let sum = parts.iter().fold((0.0, 0.0), |sum, part| (sum.0 + part.1, sum.1 + part.2));
                (parts[0].0, sum.0, if sum.0 > 0.0 { sum.1 / sum.0 } else { 0.0 })
            };
            parts.chunk_by(|a, b| a.0 == b.0).map(of_source).collect()
        };
        let virtual_rows = poser.harmonic().iter().zip(&sites).filter(|(_, driven)| **driven == Driven::Virtual);
        let rows = virtual_rows.map(|(harmonic, _)| row(harmonic)).collect();
        Some(Self { sources, sites, rows })
    }

    pub(super) fn rounded(&self, bits: u8) -> Shares {
        let whole = f64::from(1_u32 << bits);
        let row = |row: &Vec<(u32, f64, f64)>| {
            let sum: f64 = row.iter().map(|&(_, share, _)| share).sum();
            let items = row.iter().enumerate().map(|(at, &(_, share, _))| (at, share));
            let rounded = shares(items, (sum * whole).round() as u32).into_iter();
            let share = |(at, share): (u32, u32)| {
                let (source, _, along) = row[at as usize];
                Share { source, share, along: (along * whole).round() as u32 }
            };
            rounded.map(share).collect()
        };
        let rows = self.rows.iter().map(row).collect();
        Shares { sources: self.sources.clone(), sites: self.sites.clone(), bits, rows }
    }

    /// The handles in the pose of the project.
    pub(super) fn handles(&self) -> &[Handle] {
        &self.sources.handles
    }
}

impl Shares {
    /// The motions of sites at these positions, with the handles posed as given.
    pub(super) fn motions(&self, rest: &[DVec2], handles: &[Handle]) -> Vec<Motion> {
        let sources = self.sources.posed(handles);
        let source = |source: u32| sources[source as usize].as_ref().expect("bars are not sources");
        let whole = f64::from(1_u32 << self.bits);
        let mut rows = self.rows.iter();
        let motion = |(&place, driven): (&DVec2, &Driven)| match *driven {
            Driven::Source(number) => source(number).own(place),
            Driven::Still => Motion::default(),
            Driven::Virtual => {
                let part = |part: &Share| {
                    let [along, share] = [part.along, part.share].map(|steps| f64::from(steps) / whole);
                    (source(part.source).spread(place, along), share)
                };
                Motion::blended(rows.next().expect("a row for each virtual site").iter().map(part))
            }
        };
        rest.iter().zip(&self.sites).map(motion).collect()
    }

    pub(super) fn write(&self, to: &mut Writer) {
        self.sources.write(to);
        write_driven(&self.sites, to);
        to.byte(self.bits);
        write_rows(self.rows.iter().map(|row| row.iter().map(|share| share.source)), to);
        let parts = || self.rows.iter().flatten();
        parts().for_each(|part| to.varint(part.share));
        parts().filter(|part| self.is_bone(part.source)).for_each(|part| to.varint(part.along));
    }

    fn is_bone(&self, source: u32) -> bool {
        source as usize >= self.sources.handles.len()
    }

    /// Reads the shares of named handles in a number of sites.
    pub(super) fn read(from: &mut Reader<'_>, names: &[String], sites: usize) -> Result<Self, RigError> {
        let sources = Sources::read(from, names)?;
        let driven = read_driven(from, &sources, sites)?;
        let bits = from.byte()?;
        from.expect(bits <= MOST_BITS, "have too many bits")?;
        let rows = driven.iter().filter(|driven| **driven == Driven::Virtual).count();
        let named = read_rows(from, rows, |source| sources.has(source), "refer to an unknown handle or bone")?;
        let unread = |source: u32| Share { source, share: 0, along: 0 };
        let rows = named.into_iter().map(|row| row.into_iter().map(unread).collect()).collect();
        let mut shares = Self { sources, sites: driven, bits, rows };
        let whole = 1_u32 << bits;
        for row in &mut shares.rows {
            let mut left = whole;
            for part in row {
                part.share = from.varint()?;
                from.expect(part.share > 0 && part.share <= left, "sum to more than 1")?;
                left -= part.share;
            }
        }
        let first_bone = shares.sources.handles.len();
        for part in shares.rows.iter_mut().flatten().filter(|part| part.source as usize >= first_bone) {
            part.along = from.varint()?;
            from.expect(part.along <= whole, "refer to a point beyond the end of a bone")?;
        }
        Ok(shares)
    }
}
