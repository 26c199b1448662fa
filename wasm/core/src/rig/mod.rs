//! Baked rigs: an animated picture in one file, for pages without a solver.
//!
//! A [`Rig`] has the picture, the mesh with its weights, and the motions of all sites along each clip. A player blends
//! them at every vertex (eq. 1), like `web/src/render/warp.vert.glsl`. `web/docs/rig-format.md` specifies the file.
//!
//! All numbers are stored as multiples of powers of two. [`bake`](Rig::bake) chooses the coarsest powers, and the
//! fewest frames that allow linear interpolation. Every vertex stays within 0.1 px of its exact position at 60 frames
//! per second.
//!
//! - `sequence`: the exact motions of a clip. `order`: the drawing order along it. `bake`: the choice of steps.
//! - `sources`, `driven`, `shares`: data for posing the handles in the harmonic mode.
//! - `posing`, `rig_poser`: the same with a solver, for all other rigs. `probes`: test poses for choosing steps.
//! - `mesh`, `clip`: the content. `bytes`, `ascending`, `file`: numbers as bytes, rows of them, and the sections with
//!   their checksum.
//!
//! Cost: baking poses every frame once, and blends all vertices about six times per frame. Clips last up to ten
//! minutes, and all clips together have up to eight million motions of sites.

mod ascending;
mod bake;
mod bytes;
mod clip;
mod driven;
mod error;
mod file;
mod mesh;
mod order;
mod posing;
mod probes;
mod progress;
mod rig_poser;
mod sequence;
mod shares;
mod skin;
mod sources;
mod steps;

use std::collections::VecDeque;

use glam::DVec2;

pub use clip::RigClip;
pub use error::{BakeError, RigError, RigPart};
pub use rig_poser::RigPoser;

use self::{
    bytes::{Reader, Writer},
    file::{DISPLACED, Section, Tag, packed, unpacked},
    mesh::{Mesh, Weights},
    posing::Posing,
    shares::Shares,
};
use crate::{
    pose::Motion,
    project::{Blend, Handle, Project},
    solution::Solution,
};

const HEAD: Tag = *b"HEAD";
const PICTURE: Tag = *b"PICT";
const MESH: Tag = *b"MESH";
const WEIGHTS: Tag = *b"WGHT";
const DISPLACEMENTS: Tag = *b"DISP";
const SHARES: Tag = *b"SHAR";
const POSING: Tag = *b"POSR";
const CLIP: Tag = *b"CLIP";

/// An animated picture for pages without a solver.
///
/// ```
/// # use c2warp::{Picture, project::{Clip, Ease, Handle, Key, Looping, Project, Track}, solve};
/// use c2warp::rig::{Rig, RigPicture};
///
/// # let (mut project, rgba) = (Project::for_picture(40, 30), vec![255; 40 * 30 * 4]);
/// # project.handles = vec![Handle::point("left", [5.0, 15.0]), Handle::point("right", [35.0, 15.0])];
/// # let keys = [(0.0, 15.0), (0.5, 9.0)].map(|(time, y)| Key::new(time, Ease::Smooth).posed_at([[35.0, y]]));
/// # project.clips = vec![Clip::new("wave", 1.0, Looping::Repeat).with_tracks([Track::new("right", keys)])];
/// # let solution = solve(&project, &Picture::new(40, 30, &rgba)?)?;
/// # let png_file = vec![0; 100];
/// let rig = Rig::bake(&project, &solution, RigPicture { width: 40, height: 30, file: png_file })?;
/// let file = rig.to_bytes()?;
/// assert_eq!(Rig::from_bytes(&file)?, rig);
/// assert_eq!(rig.clips()[0].name, "wave");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rig {
    picture: RigPicture,
    blend: Blend,
    edges: bool,
    handles: Vec<String>,
    shares: Option<Shares>,
    posing: Option<Posing>,
    clips: Vec<RigClip>,
    mesh: Mesh,
    weights: Weights,
}

/// Selects the rigs whose handles a page can pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Posable {
    /// Rigs of the harmonic mode, unless a handle has an automatic rotation. This hardly increases their size.
    #[default]
    WithoutSolver,
    /// All rigs with handles. In the rigid mode, the file grows by about 80 kB for 150 sites.
    Always,
}

/// The picture of a rig.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RigPicture {
    /// In pixels, as solved.
    pub width: u32,
    /// In pixels, as solved.
    pub height: u32,
    /// A file that browsers decode: PNG, WebP or JPEG. It is stored unchanged, without checks.
    pub file: Vec<u8>,
}

impl Rig {
    /// The rig of a project's clips. Without clips, it has the pose of the handles.
    ///
    /// # Errors
    /// - [`BakeError::Pose`] if a pose of a clip cannot be computed;
    /// - [`BakeError::ClipTooLong`] for a clip of more than ten minutes, [`BakeError::TooManyMotions`] for
    ///   clips of more than eight million motions of sites together;
    /// - [`BakeError::TooFar`] if 32 bits are too few for the motions.
    pub fn bake(project: &Project, solution: &Solution, picture: RigPicture) -> Result<Self, BakeError> {
        Self::bake_with_progress(project, solution, picture, Posable::default(), &mut |_| {})
    }

    /// Like [`bake`](Self::bake), with posable handles. Reports the completed fraction, from 0 to 1, about a hundred
    /// times.
    ///
    /// # Errors
    /// The errors of [`bake`](Self::bake).
    pub fn bake_with_progress(
        project: &Project,
        solution: &Solution,
        picture: RigPicture,
        posable: Posable,
        on_progress: &mut dyn FnMut(f64),
    ) -> Result<Self, BakeError> {
        bake::bake(project, solution, picture, posable, on_progress)
    }

    /// The picture.
    #[must_use]
    pub fn picture(&self) -> &RigPicture {
        &self.picture
    }

    /// The clips, in the order of the project.
    #[must_use]
    pub fn clips(&self) -> &[RigClip] {
        &self.clips
    }

    /// Vertices at rest, in image pixels, numbered by their first use in the triangles.
    #[must_use]
    pub fn vertices(&self) -> Vec<DVec2> {
        self.mesh.at_rest()
    }

    /// The [`vertices`](Self::vertices) before the sites move them: displaced as the project says.
    #[must_use]
    pub fn displaced_vertices(&self) -> Vec<DVec2> {
        self.mesh.places().vertices
    }

    /// The number of sites.
    #[must_use]
    pub fn sites(&self) -> usize {
        self.mesh.rest.len()
    }

    /// The triangles: first those of the static background, then those of the solution in their order.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.mesh.triangles
    }

    /// The vertices at a frame of a clip, from 0 to its last one. Fractional frames are valid.
    ///
    /// # Panics
    /// If the clip does not exist.
    #[must_use]
    pub fn posed_vertices(&self, clip: usize, frame: f64) -> Vec<DVec2> {
        let motions = self.clips[clip].motions_at(frame, self.sites());
        self.mesh.skin(&self.weights).posed(&motions, self.blend)
    }

    /// The handles, posed as in the project. `None` if the rig cannot be posed.
    #[must_use]
    pub fn handles(&self) -> Option<&[Handle]> {
        let without_solver = self.shares.as_ref().map(|shares| &shares.sources);
        let sources = without_solver.or_else(|| self.posing.as_ref().map(|posing| &posing.sources))?;
        Some(&sources.handles)
    }

    /// The solver that poses the handles. `None` if no solver is needed, or if the rig cannot be posed.
    #[must_use]
    pub fn poser(&self) -> Option<RigPoser> {
        let mut poser = RigPoser::new(self.posing.clone()?);
        let weights = self.mesh.skin(&self.weights).weights;
        poser.set_mesh(&self.vertices(), &self.mesh.triangles, &weights).ok()?;
        Some(poser)
    }

    /// The vertices with the handles posed as given, in the order of [`handles`](Self::handles). `None` for other
    /// handles, and for rigs that need [a solver](Self::vertices_posed_with).
    #[must_use]
    pub fn vertices_posed_by(&self, handles: &[Handle]) -> Option<Vec<DVec2>> {
        let shares = self.shares.as_ref().filter(|shares| shares.sources.fit(handles))?;
        let skin = self.mesh.skin(&self.weights);
        let motions = shares.motions(&skin.rest, handles);
        Some(skin.posed(&motions, self.blend))
    }

    /// The vertices with these motions of the sites.
    ///
    /// # Panics
    /// If the number of motions differs from the number of sites.
    #[must_use]
    pub fn vertices_posed_with(&self, motions: &[Motion]) -> Vec<DVec2> {
        assert_eq!(motions.len(), self.sites(), "one motion for each site");
        self.mesh.skin(&self.weights).posed(motions, self.blend)
    }

    /// The indices of the triangles in the drawing order at a frame of a clip.
    ///
    /// # Panics
    /// If the clip does not exist.
    #[must_use]
    pub fn drawing_order(&self, clip: usize, frame: f64) -> Vec<u32> {
        let order = &self.clips[clip].order_at(frame).triangles;
        if order.is_empty() { (0..self.mesh.triangles.len() as u32).collect() } else { order.to_vec() }
    }

    /// The file.
    ///
    /// # Errors
    /// [`BakeError::TooLarge`] above 4 GB, or above 512 MiB of deflated sections.
    pub fn to_bytes(&self) -> Result<Vec<u8>, BakeError> {
        let written = |tag: Tag, write: &dyn Fn(&mut Writer)| {
            let mut writer = Writer::default();
            write(&mut writer);
            Section { tag, bytes: writer.into_bytes() }
        };
        let mut sections = vec![
            written(HEAD, &|to| self.write_head(to)),
            Section { tag: PICTURE, bytes: self.picture.file.clone() },
            written(MESH, &|to| self.mesh.write(to)),
            written(WEIGHTS, &|to| self.weights.write(to)),
        ];
        let is_displaced = self.mesh.displacements.is_some();
        if is_displaced {
            sections.push(written(DISPLACEMENTS, &|to| self.mesh.write_displacements(to)));
        }
        sections.extend(self.shares.iter().map(|shares| written(SHARES, &|to| shares.write(to))));
        sections.extend(self.posing.iter().map(|posing| written(POSING, &|to| posing.write(to))));
        sections.extend(self.clips.iter().map(|clip| written(CLIP, &|to| clip.write(to, self.sites()))));
        packed(if is_displaced { DISPLACED } else { 1 }, &sections)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// A [`RigError`] for bytes that are not a rig of a known version, or are damaged.
    pub fn from_bytes(file: &[u8]) -> Result<Self, RigError> {
        let (version, mut sections) = unpacked(file)?;
        let is_displaced = version == DISPLACED;
        // Sections of other names belong to later versions.
        sections.retain(|Section { tag, .. }| {
            [HEAD, PICTURE, MESH, WEIGHTS, SHARES, POSING, CLIP].contains(tag) || is_displaced && *tag == DISPLACEMENTS
        });
        let head = next(&mut sections, HEAD, RigPart::Head)?;
        let picture = next(&mut sections, PICTURE, RigPart::Picture)?;
        let mesh = next(&mut sections, MESH, RigPart::Mesh)?;
        let weights = next(&mut sections, WEIGHTS, RigPart::Weights)?;
        let mut from = Reader::new(RigPart::Head, &head);
        let mut rig = Self::read_head(&mut from, picture)?;
        from.end()?;
        let mut from = Reader::new(RigPart::Mesh, &mesh);
        rig.mesh = Mesh::read(&mut from)?;
        from.end()?;
        let mut from = Reader::new(RigPart::Weights, &weights);
        rig.weights = Weights::read(&mut from, rig.mesh.vertices.len(), rig.sites())?;
        from.end()?;
        if is_displaced {
            let displacements = next(&mut sections, DISPLACEMENTS, RigPart::Displacements)?;
            let mut from = Reader::new(RigPart::Displacements, &displacements);
            rig.mesh.read_displacements(&mut from)?;
            from.end()?;
        }
        if sections.front().is_some_and(|section| section.tag == SHARES) {
            let shares = next(&mut sections, SHARES, RigPart::Shares)?;
            let mut from = Reader::new(RigPart::Shares, &shares);
            rig.shares = Some(Shares::read(&mut from, &rig.handles, rig.sites())?);
            from.end()?;
        }
        if sections.front().is_some_and(|section| section.tag == POSING) {
            let posing = next(&mut sections, POSING, RigPart::Posing)?;
            let mut from = Reader::new(RigPart::Posing, &posing);
            rig.posing = Posing::read(&mut from, Some(&rig.handles), Some(rig.sites()))?;
            // A later format is ignored: clips still play.
            if rig.posing.is_some() {
                from.end()?;
            }
        }
        for Section { tag, bytes } in sections {
            let mut from = Reader::new(RigPart::Clip, &bytes);
            from.expect(tag == CLIP, "is in the wrong position")?;
            let clip = RigClip::read(&mut from, rig.sites(), rig.mesh.triangles.len())?;
            from.expect(rig.clips.iter().all(|other| other.name != clip.name), "has the name of another clip")?;
            from.end()?;
            rig.clips.push(clip);
        }
        let is_missing = RigError::Part { part: RigPart::Clip, reason: "is missing" };
        if rig.clips.is_empty() { Err(is_missing) } else { Ok(rig) }
    }

    fn write_head(&self, to: &mut Writer) {
        to.varint(self.picture.width);
        to.varint(self.picture.height);
        to.byte(u8::from(self.blend == Blend::Rigid) | u8::from(self.edges) << 1);
        to.count(self.handles.len());
        self.handles.iter().for_each(|handle| to.text(handle));
    }

    /// Reads a rig without mesh and clips.
    fn read_head(from: &mut Reader<'_>, picture: Vec<u8>) -> Result<Self, RigError> {
        let [width, height] = [from.varint()?, from.varint()?];
        from.expect(width > 0 && height > 0, "describes an empty picture")?;
        let flags = from.byte()?;
        from.expect(flags < 4, "has an unknown setting")?;
        let handles = (0..from.count(1)?).map(|_| from.text()).collect::<Result<_, _>>()?;
        Ok(Self {
            picture: RigPicture { width, height, file: picture },
            blend: if flags & 1 == 0 { Blend::Linear } else { Blend::Rigid },
            edges: flags & 2 != 0,
            handles,
            shares: None,
            posing: None,
            clips: Vec::new(),
            mesh: Mesh {
                place_bits: 0,
                vertices: Vec::new(),
                displacements: None,
                triangles: Vec::new(),
                rest: Vec::new(),
            },
            weights: Weights { bits: 0, offsets: vec![0], sites: Vec::new(), shares: Vec::new() },
        })
    }
}

/// The bytes of the next section, which must have this tag.
fn next(sections: &mut VecDeque<Section>, tag: Tag, part: RigPart) -> Result<Vec<u8>, RigError> {
    match sections.pop_front() {
        Some(section) if section.tag == tag => Ok(section.bytes),
        _ => Err(RigError::Part { part, reason: "is missing" }),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{
        deform::HandlePose,
        picture::Picture,
        project::{Clip, Displacement, Ease, Handle, Key, Looping, PoseMode, Track},
        solve::solve,
    };

    /// A small rig with two clips and two drawing orders.
    fn rig() -> Rig {
        rig_of(None, PoseMode::Harmonic)
    }

    /// The same in the rigid mode. Its poses need a solver.
    fn solved_rig() -> Rig {
        rig_of(None, PoseMode::Rigid)
    }

    /// The same, with its left half displaced.
    fn displaced_rig() -> Rig {
        let values = (0..5).flat_map(|_| [90, -40, 60, -20, 0, 0, 0, 0, 0, 0]).collect();
        rig_of(Some(Displacement::new(5, 5, values)), PoseMode::Harmonic)
    }

    fn rig_of(displacement: Option<Displacement>, mode: PoseMode) -> Rig {
        let rgba = vec![255; 24 * 18 * 4];
        let mut project = Project::for_picture(24, 18);
        (project.samples, project.displacement, project.pose.mode) = (100, displacement, mode);
        project.handles = vec![
            Handle::point("left", [4.0, 9.0]),
            Handle::point("right", [20.0, 9.0]),
            Handle::bar("top", [[9.0, 3.0], [15.0, 3.0]]),
        ];
        let keys = [(0.0, 9.0), (0.1, 4.0)].map(|(time, y)| Key::new(time, Ease::Smooth).posed_at([[20.0, y]]));
        let wave = Clip::new("wave", 0.2, Looping::Repeat).with_tracks([Track::new("right", keys)]);
        project.clips = vec![wave, Clip::new("still", 1.0, Looping::None)];
        let solution = solve(&project, &Picture::new(24, 18, &rgba).unwrap()).unwrap();
        let picture = RigPicture { width: 24, height: 18, file: b"a picture".to_vec() };
        let mut rig = Rig::bake_with_progress(&project, &solution, picture, Posable::Always, &mut |_| {}).unwrap();
        let triangles = (0..rig.triangles().len() as u32).rev().collect();
        rig.clips[0].orders.push(order::Order { frame: 3, crosses: true, triangles });
        let triangles = rig.clips[0].orders[1].triangles.clone();
        rig.clips[0].orders.push(order::Order { frame: 5, crosses: false, triangles });
        rig
    }

    fn version_of(sections: &[Section]) -> u32 {
        if sections.iter().any(|section| section.tag == DISPLACEMENTS) { DISPLACED } else { 1 }
    }

    /// Reads sections, and poses the rig if they are one.
    fn try_out(sections: &[Section]) -> Result<(), RigError> {
        let rig = Rig::from_bytes(&packed(version_of(sections), sections).unwrap())?;
        for (index, clip) in rig.clips().iter().enumerate() {
            for frame in [0.0, 0.5, f64::from(clip.last_frame)] {
                assert_eq!(rig.posed_vertices(index, frame).len(), rig.vertices().len());
                assert_eq!(rig.drawing_order(index, frame).len(), rig.triangles().len());
            }
        }
        if let Some(poser) = rig.poser() {
            let poses: Vec<HandlePose> = poser.handles().iter().map(HandlePose::from).collect();
            if let Ok(motions) = poser.motions(&poses) {
                assert_eq!(rig.vertices_posed_with(&motions).len(), rig.vertices().len());
            }
        } else if let Some(handles) = rig.handles() {
            assert_eq!(rig.vertices_posed_by(handles).unwrap().len(), rig.vertices().len());
        }
        Ok(())
    }

    #[test]
    fn a_rig_returns_from_its_bytes() {
        for (rig, version) in [(rig(), 1), (solved_rig(), 1), (displaced_rig(), 2)] {
            let file = rig.to_bytes().unwrap();
            assert_eq!(file[8], version);
            assert_eq!(Rig::from_bytes(&file), Ok(rig));
        }
    }

    #[test]
    fn a_displaced_rig_has_displacements() {
        let rig = displaced_rig();
        assert_ne!(rig.vertices(), rig.displaced_vertices());
        let mut sections = Vec::from(unpacked(&rig.to_bytes().unwrap()).unwrap().1);
        assert_eq!(sections[4].tag, DISPLACEMENTS);
        // The first version does not know such a section.
        let plain = Rig::from_bytes(&packed(1, &sections).unwrap()).unwrap();
        assert_eq!(plain.displaced_vertices(), rig.vertices());
        for end in 0..sections[4].bytes.len() {
            let cut = Section { tag: DISPLACEMENTS, bytes: sections[4].bytes[..end].to_vec() };
            let whole = std::mem::replace(&mut sections[4], cut);
            assert!(try_out(&sections).is_err(), "{end} bytes");
            sections[4] = whole;
        }
        sections.remove(4);
        let error = Rig::from_bytes(&packed(2, &sections).unwrap()).unwrap_err();
        assert_eq!(error.to_string(), "this rig is damaged: the displacement is missing");
    }

    #[test]
    fn cut_and_altered_files_are_refused() {
        let file = rig().to_bytes().unwrap();
        for end in 0..file.len() {
            assert!(Rig::from_bytes(&file[..end]).is_err(), "{end} bytes");
        }
        for at in 0..file.len() {
            for flip in [0x01, 0x80, 0xff] {
                let mut altered = file.clone();
                altered[at] ^= flip;
                assert!(Rig::from_bytes(&altered).is_err(), "{flip:x} at byte {at}");
            }
        }
        assert!(Rig::from_bytes(&[&file[..], &[0]].concat()).is_err());
    }

    #[test]
    fn later_versions_are_named() {
        let mut file = rig().to_bytes().unwrap();
        file[8] = 3;
        assert_eq!(Rig::from_bytes(&file), Err(RigError::Version { found: 3 }));
        assert_eq!(Rig::from_bytes(b"\x89PNG\r\n\x1a\n"), Err(RigError::NotARig));
    }

    #[test]
    fn unknown_sections_are_skipped_and_missing_ones_refused() {
        let rig = rig();
        let sections = || Vec::from(unpacked(&rig.to_bytes().unwrap()).unwrap().1);
        let mut more = sections();
        more.insert(2, Section { tag: *b"MORE", bytes: vec![1, 2, 3] });
        assert_eq!(Rig::from_bytes(&packed(1, &more).unwrap()), Ok(rig.clone()));
        for missing in 0..4 {
            let mut fewer = sections();
            fewer.remove(missing);
            assert!(try_out(&fewer).is_err());
        }
        let mut without_clips = sections();
        without_clips.truncate(5);
        assert!(try_out(&without_clips).is_err());
        // Then poses need a solver.
        let mut without_shares = sections();
        without_shares.remove(4);
        assert_eq!(Rig::from_bytes(&packed(1, &without_shares).unwrap()).unwrap().handles(), None);
    }

    #[test]
    fn cut_sections_are_refused() {
        for rig in [rig(), solved_rig()] {
            refuse_cut_sections(&rig);
        }
    }

    fn refuse_cut_sections(rig: &Rig) {
        let sections = unpacked(&rig.to_bytes().unwrap()).unwrap().1;
        for (at, section) in sections.iter().enumerate().filter(|(_, section)| section.tag != PICTURE) {
            for end in 0..section.bytes.len() {
                let cut = |(index, other): (usize, &Section)| Section {
                    tag: other.tag,
                    bytes: if index == at { other.bytes[..end].to_vec() } else { other.bytes.clone() },
                };
                let cut: Vec<Section> = sections.iter().enumerate().map(cut).collect();
                assert!(try_out(&cut).is_err(), "{end} bytes of section {at}");
            }
        }
    }

    #[test]
    fn poses_of_a_later_format_are_skipped() {
        let rig = solved_rig();
        let mut sections = Vec::from(unpacked(&rig.to_bytes().unwrap()).unwrap().1);
        assert_eq!(sections[4].tag, POSING);
        assert!(RigPoser::from_section(&sections[4].bytes).is_ok());
        sections[4].bytes = vec![3, 99, 99];
        let read = Rig::from_bytes(&packed(1, &sections).unwrap()).unwrap();
        assert_eq!((read.handles(), read.clips()), (None, rig.clips()));
        let error = RigPoser::from_section(&sections[4].bytes).unwrap_err();
        assert_eq!(error.to_string(), "this rig is damaged: the poses have an unknown format");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, cases: 64, ..ProptestConfig::default() })]

        #[test]
        fn any_contents_are_read_or_refused(
            at: proptest::sample::Index,
            byte: u8,
            other: proptest::sample::Index,
            kind in 0..3,
        ) {
            let rig = [rig, displaced_rig, solved_rig][kind as usize]();
            let mut sections = Vec::from(unpacked(&rig.to_bytes().unwrap()).unwrap().1);
            for section in sections.iter_mut().filter(|section| section.tag != PICTURE) {
                let bytes = &mut section.bytes;
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            let _ = try_out(&sections);
            let count = sections.len();
            let bytes = &mut sections[other.index(count)].bytes;
            bytes.insert(at.index(bytes.len()), byte);
            let _ = try_out(&sections);
        }

        #[test]
        fn random_bytes_are_refused(bytes in proptest::collection::vec(any::<u8>(), 0..99)) {
            prop_assert!(Rig::from_bytes(&bytes).is_err());
            let section = Section { tag: HEAD, bytes };
            prop_assert!(try_out(&[section]).is_err());
        }
    }
}
