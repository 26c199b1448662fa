//! Promises about every solution, pose and error.

use c2warp::glam::DVec2;
use c2warp::{
    Error, Solution,
    deform::{PictureMesh, PosedPicture},
    pose::Poser,
    project::{Project, Shape},
    site::SiteKind,
};

/// Tolerance for the sum of some hundred weights, each rounded to 1e-16.
const SUM_TOLERANCE: f64 = 1e-12;

/// Between two bones or edges of a held outline that meet at an acute angle, a cell may reach so much farther than its
/// support. Those of both sides cover the rest.
const BETWEEN_LINES: f64 = 1.1;

/// Checks that an error is one line for people.
pub(crate) fn expect_sentence(error: &str) {
    assert!(!error.is_empty() && !error.contains('\n'), "{error:?}");
}

/// Returns a result that was accepted, and checks the error of one that was refused.
pub(crate) fn accepted<T>(result: Result<T, Error>) -> Option<T> {
    result.map_err(|error| expect_sentence(&error.to_string())).ok()
}

/// Checks a solution and its pose.
pub(crate) fn check(solution: &Solution, project: &Project) {
    let has_bones = project.handles.iter().any(|handle| !matches!(handle.shape, Shape::Point { .. }));
    let has_lines = has_bones || project.fix_boundary;
    for site in solution.sites() {
        let is_between = has_lines && matches!(site.kind, SiteKind::Point { .. } | SiteKind::Virtual);
        let reach = if is_between { BETWEEN_LINES } else { 1.0 };
        assert!(site.rest.is_finite() && site.cell_radius < reach * site.support_radius, "{site:?}");
    }
    let weights = solution.weights();
    for vertex in 0..weights.len() {
        check_weights(weights.row(vertex), solution.vertices()[vertex]);
    }
    for (index, site) in solution.sites().iter().enumerate().filter(|(_, site)| site.kind.is_real()) {
        if site.kind.handle().is_some() {
            let weights = solution.weights_at(site.rest).expect("a site lies in the domain");
            check_weights(weights.iter().copied(), site.rest);
            assert!(weights.iter().any(|&(at, _)| at == index), "{site:?} has no weight at its own place");
        }
    }
    let Some(pose) = accepted(solution.pose(project)) else { return };
    assert!(solution.posed_vertices(&pose).iter().all(|p| p.is_finite()));
    assert_eq!(solution.drawn_triangles(&pose).len(), solution.triangles().len());
    let poser = Poser::from_bytes(&solution.poser().to_bytes()).expect("bytes of this version");
    let mesh = PictureMesh {
        vertices: solution.vertices().to_vec(),
        triangles: solution.triangles().to_vec(),
        samples: solution.samples(),
        weights: solution.weights().clone(),
        background: Vec::new(),
    };
    let copy = PosedPicture::new(mesh, poser, project.handles.clone()).expect("the mesh of the solution");
    let again = copy.poser().pose(&project.handles, project.pose.blend).expect("the poser itself poses the handles");
    for &p in solution.vertices().iter().take(20) {
        let (here, there) = (solution.map(&pose, p), solution.map(&again, p));
        assert_eq!(here.map(|mapped| mapped.posed), there.map(|mapped| mapped.posed));
    }
}

/// Checks that weights are finite, not negative, and sum to 1 unless there are none.
fn check_weights(weights: impl Iterator<Item = (usize, f64)>, at: DVec2) {
    let (mut sum, mut is_empty) = (0.0, true);
    for (site, weight) in weights {
        assert!(weight.is_finite() && weight >= 0.0, "site {site} has the weight {weight} at {at}");
        (sum, is_empty) = (sum + weight, false);
    }
    assert!(is_empty || (sum - 1.0_f64).abs() <= SUM_TOLERANCE, "weights at {at} sum to {sum}");
}
