//! The sources that move the sites of a rig.

use super::{
    bytes::{Reader, Writer},
    error::RigError,
    sources::Sources,
};
use crate::site::SiteKind;

/// The cause of a site's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Driven {
    /// Other sites around it.
    Virtual,
    /// None: it does not move.
    Still,
    /// It is a site of this source.
    Source(u32),
}

/// The causes of motion for sites of these kinds.
pub(super) fn driven_by(kinds: &[SiteKind], sources: &Sources) -> Vec<Driven> {
    let handles = sources.handles.len() as u32;
    let driven = |kind: &SiteKind| match *kind {
        SiteKind::Point { handle } => Driven::Source(handle),
        SiteKind::Bone { bone, .. } => Driven::Source(handles + bone),
        SiteKind::Boundary => Driven::Still,
        SiteKind::Virtual => Driven::Virtual,
    };
    kinds.iter().map(driven).collect()
}

/// The kinds of sites with these causes.
pub(super) fn kinds_of(driven: &[Driven], sources: &Sources) -> Vec<SiteKind> {
    let handles = sources.handles.len() as u32;
    let kind = |driven: &Driven| match *driven {
        Driven::Virtual => SiteKind::Virtual,
        Driven::Still => SiteKind::Boundary,
        Driven::Source(source) => match source.checked_sub(handles) {
            None => SiteKind::Point { handle: source },
            Some(bone) => SiteKind::Bone { handle: sources.skeleton.bones[bone as usize].handle, bone },
        },
    };
    driven.iter().map(kind).collect()
}

pub(super) fn write_driven(driven: &[Driven], to: &mut Writer) {
    for driven in driven {
        to.varint(match *driven {
            Driven::Virtual => 0,
            Driven::Still => 1,
            Driven::Source(source) => source + 2,
        });
    }
}

/// Reads the causes of a number of sites.
pub(super) fn read_driven(from: &mut Reader<'_>, sources: &Sources, sites: usize) -> Result<Vec<Driven>, RigError> {
    from.expect(from.has(Some(sites)), "end too early")?;
    let mut driven = Vec::with_capacity(sites);
    for _ in 0..sites {
        let kind = from.varint()?;
        let is_known = kind < 2 || sources.has(kind as usize - 2);
        from.expect(is_known, "refer to an unknown handle or bone")?;
        driven.push(match kind {
            0 => Driven::Virtual,
            1 => Driven::Still,
            source => Driven::Source(source - 2),
        });
    }
    Ok(driven)
}
