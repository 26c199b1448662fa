//! Determines whether two projects with their pictures have the same solution.

use crate::{
    error::Error,
    fill_key::FillKey,
    picture::Picture,
    prepared_domain::DomainKey,
    project::{DomainSpec, Project},
    solve_input::{SolveInput, check_picture},
};

/// Everything that a solution depends on: equal keys have equal solutions. Poses of handles, clips and colours are not
/// included, except colours if the picture is filled behind the domain.
///
/// ```
/// use c2warp::{Picture, SolveKey, project::{Handle, Project}};
///
/// let [red, blue] = [[255, 0, 0, 255], [0, 0, 255, 255]].map(|colour| colour.repeat(40 * 30));
/// let [red, blue] = [Picture::new(40, 30, &red)?, Picture::new(40, 30, &blue)?];
/// let hand = Handle::point("hand", [10.0, 15.0]);
/// let [still, raised] = [hand.clone(), hand.posed_at([[10.0, 5.0]])].map(|hand| {
///     Project::for_picture(40, 30).with_handles([hand])
/// });
/// assert_eq!(SolveKey::new(&still, &red)?, SolveKey::new(&raised, &blue)?);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SolveKey {
    domain: DomainKey,
    input: SolveInput,
    /// The alpha of each pixel, if the outline depends on it and a pixel is not opaque.
    alpha: Option<Vec<u8>>,
    /// The fill with its source pixels.
    fill: Option<(FillKey, Vec<u8>)>,
}

impl SolveKey {
    /// The key of a project with its picture.
    ///
    /// # Errors
    /// - [`Error::PictureMismatch`].
    /// - [`Error::Project`] if [`Project::check`] fails.
    /// - [`Error::TooManyHandles`], [`Error::TooManyCorners`], [`Error::PoseNotFinite`].
    pub fn new(project: &Project, picture: &Picture<'_>) -> Result<Self, Error> {
        check_picture(project.image.size(), picture)?;
        let follows_alpha = matches!(project.domain, None | Some(DomainSpec::Alpha { .. }));
        let alpha = (follows_alpha && picture.has_transparency())
            .then(|| picture.rgba().as_chunks::<4>().0.iter().map(|pixel| pixel[3]).collect());
        let fill = FillKey::of(project).map(|key| (key, picture.rgba().to_vec()));
        Ok(Self { domain: DomainKey::of(project), input: SolveInput::new(project)?, alpha, fill })
    }
}
