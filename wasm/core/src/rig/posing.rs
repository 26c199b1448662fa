//! Handles whose poses need a solver, and its data: for the rigid mode, and for automatic rotations.
//!
//! This is the content of a [`Poser`], in the coarsest steps that preserve its poses.
//!
//! Cost: a third of the bytes of the poser itself, mostly for the nodes of the rigid mode.

use glam::DVec2;

use super::{
    ascending::{read_rows, write_rows},
    bytes::{Reader, Writer},
    driven::{driven_by, kinds_of, read_driven, write_driven},
    error::RigError,
    mesh::{read_places, shares, write_places},
    sources::{Sources, turns_by_itself},
    steps::{round, value},
};
use crate::{
    pose::{Node, Poser, PoserParts, RigidParts, StiffnessField, StiffnessMask},
    project::{Handle, Rotation, Shape},
    rank::sort_by_rank,
    site::SiteKind,
    weight::Influence,
};

/// The format of the section. Readers skip sections of later formats. Format 1 has no runs, and nodes of two levels.
const FORMAT: u8 = 2;
/// The finest steps.
const MOST_BITS: u8 = 24;
/// The greatest logarithm to the base 2 of an area or a flow.
const MOST_LOG: f64 = 64.0;
/// The reason for rejecting a site number.
const UNKNOWN_SITE: &str = "refer to an unknown site";

/// Handles and their solver, in integer steps.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Posing {
    pub(super) sources: Sources,
    bits: PosingBits,
    parts: PoserParts,
    /// Lengths of runs of the rig's triangles: alternately beyond the samples, and between them. Empty if unknown.
    runs: Vec<u32>,
}

/// Numbers are multiples of 2 to the power of minus these.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct PosingBits {
    /// For rest positions of sites, in pixels.
    pub(super) place: u8,
    /// Of harmonic weights.
    pub(super) share: u8,
    /// Of the weights of links.
    pub(super) link: u8,
    /// Of logarithms to the base 2: of areas and of flows.
    pub(super) log: u8,
    /// Of positions of nodes, in pixels.
    pub(super) node: u8,
    /// Of weights at nodes.
    pub(super) weight: u8,
    /// Of their gradients, per pixel.
    pub(super) gradient: u8,
}

impl PosingBits {
    /// Steps for a picture with this longest side.
    pub(super) fn of(fineness: u8, side: u32) -> Self {
        // A gradient acts over a sixty-fourth of the picture. With finer ones poses are hardly nearer.
        let gradient = fineness + (u32::BITS - side.leading_zeros()) as u8 - 6;
        Self {
            place: 10,
            share: fineness + 2,
            link: fineness,
            log: fineness - 4,
            node: fineness - 8,
            weight: fineness,
            gradient: gradient.min(MOST_BITS),
        }
    }

    fn all(self) -> [u8; 7] {
        let Self { place, share, link, log, node, weight, gradient } = self;
        [place, share, link, log, node, weight, gradient]
    }
}

impl Posing {
    /// `None` without handles, and for the rigid mode without a picture between the sites.
    pub(super) fn of(poser: &Poser, handles: &[Handle], bits: PosingBits, runs: Vec<u32>) -> Option<Self> {
        let parts = (!handles.is_empty()).then(|| poser.parts())??;
        let rounded = Rounding { bits, parts: &parts };
        let parts = rounded.parts()?;
        let runs = if parts.rigid.is_some() { runs } else { Vec::new() };
        Some(Self { sources: Sources::new(handles, poser.skeleton()), bits, parts, runs })
    }

    /// The triangles of the rig between samples.
    pub(super) fn between(&self, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
        let mut left = triangles;
        let mut between = Vec::new();
        for (run, &length) in self.runs.iter().enumerate() {
            let (run_of, others) = left.split_at((length as usize).min(left.len()));
            if run % 2 == 1 {
                between.extend_from_slice(run_of);
            }
            left = others;
        }
        between
    }

    /// Poses the handles.
    pub(super) fn poser(&self) -> Poser {
        let Sources { handles, skeleton } = &self.sources;
        Poser::from_parts(&self.parts, skeleton, handles).expect("the parts were checked")
    }

    pub(super) fn write(&self, to: &mut Writer) {
        let Self { sources, bits, parts, runs } = self;
        to.byte(FORMAT);
        to.count(sources.handles.len());
        to.count(parts.rest.len());
        sources.write(to);
        write_driven(&driven_by(&parts.kinds, sources), to);
        sources.handles.iter().for_each(|handle| to.byte(turns_by_itself(handle).into()));
        to.byte(parts.rigid.is_some().into());
        bits.all().iter().for_each(|&bits| to.byte(bits));
        write_places(&parts.rest.iter().map(|&place| steps_of(place, bits.place)).collect::<Vec<_>>(), to);
        write_rows(parts.harmonic.iter().map(|row| row.iter().map(|&(site, _)| site)), to);
        parts.harmonic.iter().flatten().for_each(|&(_, share)| to.varint(steps(share, bits.share) as u32));
        to.count(parts.pseudo_edges.len());
        write_pairs(parts.pseudo_edges.iter().map(|&(i, j, _)| [i, j]), to);
        write_logs(parts.pseudo_edges.iter().map(|&(.., flow)| flow), bits.log, to);
        to.count(parts.adjacent.len());
        write_pairs(parts.adjacent.iter().copied(), to);
        if let Some(rigid) = &parts.rigid {
            self.write_rigid(rigid, to);
            to.count(runs.len());
            runs.iter().for_each(|&length| to.varint(length));
        }
    }

    fn write_rigid(&self, RigidParts { links, nodes, stiffness }: &RigidParts, to: &mut Writer) {
        let bits = self.bits;
        to.count(links.len());
        write_pairs(links.iter().map(|&(i, j, _)| [i, j]), to);
        links.iter().for_each(|&(.., weight)| to.varint(steps(weight, bits.link) as u32));
        let polygons = self.sources.handles.iter().filter(|handle| matches!(handle.shape, Shape::Polygon { .. }));
        polygons.for_each(|handle| to.number(handle.stiffness));
        to.byte(stiffness.mask().is_some().into());
        if let Some(StiffnessMask { size, columns, rows, values }) = stiffness.mask() {
            size.to_array().iter().for_each(|&side| to.number(side));
            [columns, rows].iter().for_each(|&&side| to.varint(side));
            values.iter().for_each(|&value| to.byte(value));
        }
        to.count(nodes.len());
        let nodes = || nodes.iter();
        write_places(&nodes().map(|node| steps_of(node.at, bits.node)).collect::<Vec<_>>(), to);
        write_logs(nodes().map(|node| node.area), bits.log, to);
        write_rows(nodes().map(|node| node.influences.iter().map(|one| one.site as u32)), to);
        // The first one is 1 minus the others.
        let others = || nodes().flat_map(|node| node.influences.iter().skip(1));
        others().for_each(|one| to.varint(steps(one.weight, bits.weight) as u32));
        others().for_each(|one| to.signed(steps(one.gradient.x, bits.gradient)));
        others().for_each(|one| to.signed(steps(one.gradient.y, bits.gradient)));
    }

    /// Reads handles of these names, or numbered ones. `None` for a section of another format.
    pub(super) fn read(
        from: &mut Reader<'_>,
        names: Option<&[String]>,
        sites: Option<usize>,
    ) -> Result<Option<Self>, RigError> {
        let format = from.byte()?;
        if !(1..=FORMAT).contains(&format) {
            return Ok(None);
        }
        let (handles, count) = (from.count(1)?, from.count(3)?);
        from.expect(names.is_none_or(|names| names.len() == handles), "have other handles")?;
        from.expect(handles > 0 && sites.is_none_or(|sites| sites == count), "have other sites")?;
        let numbered: Vec<String> = match names {
            Some(names) => names.to_vec(),
            None => (0..handles).map(|handle| handle.to_string()).collect(),
        };
        let mut sources = Sources::read(from, &numbered)?;
        let kinds = kinds_of(&read_driven(from, &sources, count)?, &sources);
        for handle in &mut sources.handles {
            let turns = from.byte()?;
            from.expect(turns < 2, "contain an invalid handle")?;
            if turns == 1 {
                handle.rotation = Rotation::Auto;
            }
        }
        let is_rigid = from.byte()?;
        from.expect(is_rigid < 2, "have an unknown mode")?;
        let mut bits = [0; 7];
        for bits in &mut bits {
            *bits = from.byte()?;
            from.expect(*bits <= MOST_BITS, "have too many bits")?;
        }
        let [place, share, link, log, node, weight, gradient] = bits;
        let bits = PosingBits { place, share, link, log, node, weight, gradient };
        let rest = read_places(from, count)?.iter().map(|&steps| place_of(steps, place)).collect();
        let rows = kinds.iter().filter(|kind| !kind.is_real()).count();
        let mut harmonic = Vec::new();
        for sites in read_rows(from, rows, |site| site < count, UNKNOWN_SITE)? {
            harmonic.push(sites.into_iter().map(|site| (site, 0.0)).collect::<Vec<_>>());
        }
        for (_, weight) in harmonic.iter_mut().flatten() {
            *weight = read_fraction(from, share)?;
        }
        let edges = from.count(3)?;
        let pairs = read_pairs(from, edges, count)?;
        let flows = read_logs(from, edges, log)?;
        let pseudo_edges = pairs.into_iter().zip(flows).map(|([i, j], flow)| (i, j, flow)).collect();
        let adjacent = from.count(2)?;
        let adjacent = read_pairs(from, adjacent, handles)?;
        let rigid = if is_rigid == 1 { Some(read_rigid(from, format, &mut sources, bits, count)?) } else { None };
        let runs = if is_rigid == 1 && format > 1 { from.count(1)? } else { 0 };
        let runs = (0..runs).map(|_| from.varint()).collect::<Result<_, _>>()?;
        let parts = PoserParts { rest, kinds, harmonic, pseudo_edges, adjacent, rigid };
        let is_whole = Poser::from_parts(&parts, &sources.skeleton, &sources.handles).is_some();
        from.expect(is_whole, "contradict one another")?;
        Ok(Some(Self { sources, bits, parts, runs }))
    }
}

fn read_rigid(
    from: &mut Reader<'_>,
    format: u8,
    sources: &mut Sources,
    bits: PosingBits,
    sites: usize,
) -> Result<RigidParts, RigError> {
    let count = from.count(3)?;
    let pairs = read_pairs(from, count, sites)?;
    let weight = |[i, j]: [u32; 2]| Ok((i, j, read_fraction(from, bits.link)?));
    let links = pairs.into_iter().map(weight).collect::<Result<_, RigError>>()?;
    for handle in sources.handles.iter_mut().filter(|handle| matches!(handle.shape, Shape::Polygon { .. })) {
        handle.stiffness = from.number()?;
        from.expect((0.0..=1.0).contains(&handle.stiffness), "contain a stiffness outside 0 to 1")?;
    }
    let has_mask = from.byte()?;
    from.expect(has_mask < 2, "have an unknown kind of stiffness")?;
    let mask = if has_mask == 1 { Some(read_mask(from)?) } else { None };
    let stiffness = StiffnessField::of(mask, &sources.handles);
    let coarse = if format == 1 { from.count(5)? } else { 0 };
    let count = coarse + from.count(5)? + if format == 1 { from.count(5)? } else { 0 };
    from.expect(from.has(Some(count)), "end too early")?;
    let places = read_places(from, count)?;
    let areas = read_logs(from, count, bits.log)?;
    let rows = read_rows(from, count, |site| site < sites, UNKNOWN_SITE)?;
    let mut nodes = Vec::new();
    for ((place, area), sites) in places.into_iter().zip(areas).zip(rows) {
        from.expect(!sites.is_empty(), "contain a node that no site moves")?;
        let influence = |site: u32| Influence { site: site as usize, weight: 0.0, gradient: DVec2::ZERO };
        let influences = sites.into_iter().map(influence).collect();
        nodes.push(Node { at: place_of(place, bits.node), area, influences });
    }
    for node in &mut nodes {
        let mut left = 1.0;
        for one in &mut node.influences[1..] {
            one.weight = read_fraction(from, bits.weight)?;
            left -= one.weight;
        }
        from.expect(left >= 0.0, "contain weights that sum to more than 1")?;
        node.influences[0].weight = left;
    }
    for axis in 0..2 {
        for node in &mut nodes {
            let mut left = 0.0;
            for one in &mut node.influences[1..] {
                one.gradient[axis] = value(from.signed()?, bits.gradient);
                left -= one.gradient[axis];
            }
            node.influences[0].gradient[axis] = left;
        }
    }
    nodes.drain(..coarse);
    Ok(RigidParts { links, nodes, stiffness })
}

fn read_mask(from: &mut Reader<'_>) -> Result<StiffnessMask, RigError> {
    let size = DVec2::new(from.number()?, from.number()?);
    let [columns, rows] = [from.varint()?, from.varint()?];
    let cells = (columns as usize).checked_mul(rows as usize);
    from.expect(from.has(cells), "end too early")?;
    let values = (0..cells.unwrap_or(0)).map(|_| from.byte()).collect::<Result<_, _>>()?;
    Ok(StiffnessMask { size, columns, rows, values })
}

/// The parts of a poser in steps.
struct Rounding<'a> {
    bits: PosingBits,
    parts: &'a PoserParts,
}

impl Rounding<'_> {
    /// `None` for positions that are too far away.
    fn parts(&self) -> Option<PoserParts> {
        let Self { bits, parts } = self;
        let is_moved = |&&(site, _): &&(u32, f64)| parts.kinds[site as usize] != SiteKind::Boundary;
        let harmonic = |row: &Vec<(u32, f64)>| {
            // Sites that stay add nothing.
            let moved: Vec<(usize, f64)> =
                row.iter().filter(is_moved).map(|&(site, weight)| (site as usize, weight)).collect();
            let sum: f64 = moved.iter().map(|(_, weight)| weight).sum();
            let mut rounded = shares(moved.into_iter(), (sum * whole(bits.share)).round() as u32);
            sort_by_rank(&mut rounded, |&(site, _)| [site.into(), 0]);
            rounded.into_iter().map(|(site, steps)| (site, f64::from(steps) / whole(bits.share))).collect()
        };
        let mut pseudo_edges: Vec<_> = parts
            .pseudo_edges
            .iter()
            .filter(|(.., flow)| *flow > 0.0)
            .map(|&(i, j, flow)| (i, j, exp(log(flow, bits.log), bits.log)))
            .collect();
        sort_by_rank(&mut pseudo_edges, |&(i, j, _)| [i.into(), j.into()]);
        let mut adjacent = parts.adjacent.clone();
        sort_by_rank(&mut adjacent, |pair| pair.map(i64::from));
        let rigid = match &parts.rigid {
            Some(rigid) => Some(self.rigid(rigid)?),
            None => None,
        };
        Some(PoserParts {
            rest: parts.rest.iter().map(|&place| rounded_place(place, bits.place)).collect::<Option<_>>()?,
            kinds: parts.kinds.clone(),
            harmonic: parts.harmonic.iter().map(harmonic).collect(),
            pseudo_edges,
            adjacent,
            rigid,
        })
    }

    fn rigid(&self, rigid: &RigidParts) -> Option<RigidParts> {
        let bits = self.bits;
        // A link of no weight would not count turns.
        let link = |weight: f64| (weight * whole(bits.link)).round().max(1.0) / whole(bits.link);
        let mut links: Vec<_> = rigid.links.iter().map(|&(i, j, weight)| (i, j, link(weight))).collect();
        sort_by_rank(&mut links, |&(i, j, _)| [i.into(), j.into()]);
        let nodes = rigid.nodes.iter().map(|node| self.node(node)).collect::<Option<_>>()?;
        Some(RigidParts { links, nodes, stiffness: rigid.stiffness.clone() })
    }

    fn node(&self, node: &Node) -> Option<Node> {
        let bits = self.bits;
        let mut exact = node.influences.clone();
        sort_by_rank(&mut exact, |one| [one.site as i64, 0]);
        let rounded =
            shares(exact.iter().map(|one| one.site).zip(exact.iter().map(|one| one.weight)), 1 << bits.weight);
        let mut influences = Vec::new();
        for one in exact {
            let weight = rounded.iter().find(|(site, _)| *site as usize == one.site).map_or(0, |&(_, steps)| steps);
            let weight = f64::from(weight) / whole(bits.weight);
            let gradient = DVec2::new(
                value(round(one.gradient.x, bits.gradient)?, bits.gradient),
                value(round(one.gradient.y, bits.gradient)?, bits.gradient),
            );
            influences.push(Influence { weight, gradient, ..one });
        }
        let others: DVec2 = influences[1..].iter().map(|one| one.gradient).sum();
        influences[0].gradient = -others;
        let area = exp(log(node.area, bits.log), bits.log);
        Some(Node { at: rounded_place(node.at, bits.node)?, area, influences })
    }
}

fn whole(bits: u8) -> f64 {
    f64::from(1_u32 << bits)
}

/// A number in steps, of which it is a multiple.
fn steps(number: f64, bits: u8) -> i32 {
    round(number, bits).expect("rounded numbers have 32 bits")
}

fn steps_of(place: DVec2, bits: u8) -> [i32; 2] {
    place.to_array().map(|number| steps(number, bits))
}

fn place_of(place: [i32; 2], bits: u8) -> DVec2 {
    place.map(|steps| value(steps, bits)).into()
}

fn rounded_place(place: DVec2, bits: u8) -> Option<DVec2> {
    Some(place_of([round(place.x, bits)?, round(place.y, bits)?], bits))
}

/// The logarithm of a positive number, in steps.
fn log(number: f64, bits: u8) -> i32 {
    steps(libm::log2(number).clamp(-MOST_LOG, MOST_LOG), bits)
}

fn exp(log: i32, bits: u8) -> f64 {
    libm::exp2(value(log, bits))
}

fn write_logs(numbers: impl Iterator<Item = f64>, bits: u8, to: &mut Writer) {
    let mut before = 0;
    for number in numbers {
        let log = log(number, bits);
        to.signed(log - before);
        before = log;
    }
}

fn read_logs(from: &mut Reader<'_>, count: usize, bits: u8) -> Result<Vec<f64>, RigError> {
    let mut log = 0_i32;
    let mut numbers = Vec::new();
    for _ in 0..count {
        log = log.wrapping_add(from.signed()?);
        from.expect(value(log, bits).abs() <= MOST_LOG, "contain a number that is too large")?;
        numbers.push(exp(log, bits));
    }
    Ok(numbers)
}

fn read_fraction(from: &mut Reader<'_>, bits: u8) -> Result<f64, RigError> {
    let steps = from.varint()?;
    from.expect(steps <= 1 << bits, "contain a weight greater than 1")?;
    Ok(f64::from(steps) / whole(bits))
}

/// Pairs in ascending order, the lesser number first. The lesser number is written relative to that of the previous
/// pair, and the greater relative to the lesser, minus 1.
fn write_pairs(pairs: impl Iterator<Item = [u32; 2]>, to: &mut Writer) {
    let mut before = 0;
    for [i, j] in pairs {
        to.varint(i - before);
        to.varint(j - i - 1);
        before = i;
    }
}

fn read_pairs(from: &mut Reader<'_>, count: usize, limit: usize) -> Result<Vec<[u32; 2]>, RigError> {
    let mut pairs = Vec::new();
    let mut i = 0_u32;
    for _ in 0..count {
        i = i.saturating_add(from.varint()?);
        let j = i.saturating_add(from.varint()?).saturating_add(1);
        from.expect(i < j && (j as usize) < limit, UNKNOWN_SITE)?;
        pairs.push([i, j]);
    }
    Ok(pairs)
}
