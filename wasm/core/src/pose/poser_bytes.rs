//! A poser as bytes, for another process of the same version.

use super::poser::Poser;
use crate::error::Error;

impl Poser {
    /// The poser as bytes, for [`Poser::from_bytes`] of the same version.
    ///
    /// The bytes do not hold the drawn mesh. In the rigid mode, poses that flatten triangles differ without it:
    /// [`PosedPicture`](crate::deform::PosedPicture) adds it.
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
    /// [`Error::PoserBytes`] for bytes that do not hold a consistent poser. Consistent bytes need not come from
    /// [`Poser::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let (all, rest) = postcard::take_from_bytes(bytes).map_err(|_| Error::PoserBytes)?;
        if !rest.is_empty() {
            return Err(Error::PoserBytes);
        }
        let (rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement) = all;
        let poser = Self { rest, kinds, skeleton, solved, harmonic, automatic, rigid, picture, displacement };
        if poser.is_whole() { Ok(poser) } else { Err(Error::PoserBytes) }
    }
}
