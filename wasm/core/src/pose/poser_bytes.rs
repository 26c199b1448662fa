//! A poser as bytes, for another process of the same version.

use super::poser::Poser;
use crate::{error::Error, project::ShapeKind, site::SiteKind};

impl Poser {
    /// The poser as bytes, for [`Poser::from_bytes`] of the same version.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        // A derived implementation would allow reading without the checks of `from_bytes`.
        let Self { rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement } = self;
        let all = (rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement);
        postcard::to_allocvec(&all).expect("plain data can be written to memory")
    }

    /// A poser from its bytes.
    ///
    /// # Errors
    /// [`Error::PoserBytes`] for bytes that make no consistent poser. Consistent bytes need not come from
    /// [`Poser::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let (all, rest) = postcard::take_from_bytes(bytes).map_err(|_| Error::PoserBytes)?;
        if !rest.is_empty() {
            return Err(Error::PoserBytes);
        }
        let (rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement) = all;
        let poser = Self { rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement };
        let sites = poser.rest.len();
        let real = |site: u32| poser.kinds.get(site as usize).is_some_and(|kind| kind.is_real());
        let known = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => {
                poser.solved.get(handle as usize).is_some_and(|solved| solved.shape == ShapeKind::Point)
            }
            SiteKind::Bone { handle, bone } => {
                (handle as usize) < poser.solved.len() && (bone as usize) < poser.skeleton.bones.len()
            }
            SiteKind::Boundary | SiteKind::Virtual => true,
        };
        let whole = poser.kinds.len() == sites
            && poser.harmonic.len() == sites
            && poser.harmonic.iter().flatten().all(|&(site, _)| real(site))
            && poser.automatic.is_whole(real, poser.solved.len())
            && poser.rigid.as_ref().is_none_or(|rigid| rigid.is_whole(sites))
            && poser.displacement.as_ref().is_none_or(|field| field.is_whole())
            && poser.skeleton.is_consistent(poser.solved.len())
            && poser.kinds.iter().all(known);
        if whole { Ok(poser) } else { Err(Error::PoserBytes) }
    }
}
