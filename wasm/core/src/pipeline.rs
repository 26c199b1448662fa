//! The stages of a solve, each as a function of the results of earlier stages.
//!
//! Cost: see the modules that each stage calls. `web/docs/method.md` sums up the cost of each.

use std::sync::Arc;

use crate::{
    distance::{Navigation, Penumbrae, Propagation},
    error::Error,
    loose::Loose,
    pose::{HarmonicFields, Poser, PoserInput, Quadrature},
    prepared_domain::PreparedDomain,
    project::{Continuity, LooseParts, PoseMode, Weighting},
    render_mesh::{RenderMesh, leading_parts},
    sample::{CoarseSamples, Places, Samples, SamplingCache, coarse_sample_count, coarse_samples},
    site::{Obstacles, Partition, Site, SiteField, SiteGraph, SiteInserter, Tessellation, insert_virtual_sites},
    solution::Solution,
    solve_input::{LocatedHandles, SolveInput},
    solved_sites::SolvedSites,
    static_background::StaticBackground,
    weight::{Basis, SampleWeights, WeightFunctions, precedence_radii, support_radii},
};

/// The samples of a domain with handles, which are the vertices of the drawn mesh, and the coarse samples, over which
/// cells are stored (section V-B).
pub(crate) fn sample(
    cache: &mut SamplingCache,
    prepared: &PreparedDomain,
    located: &LocatedHandles,
    input: &SolveInput,
) -> (Samples, CoarseSamples) {
    let (bones, points) = (located.bone_positions(), located.point_positions());
    let coarse_count = coarse_sample_count(input.samples, input.density);
    cache.samples(prepared, Places { bones: &bones, points: &points }, input.samples, coarse_count)
}

/// The coarse samples of a domain with handles, for samples of the caller.
pub(crate) fn sample_coarsely(
    prepared: &PreparedDomain,
    located: &LocatedHandles,
    input: &SolveInput,
) -> CoarseSamples {
    let (bones, points) = (located.bone_positions(), located.point_positions());
    let count = coarse_sample_count(input.samples, input.density);
    coarse_samples(prepared, Places { bones: &bones, points: &points }, count)
}

/// Partitions the domain into the cells of real and virtual sites (sections III-B and IV-A).
///
/// # Errors
/// [`Error::TooManySites`], [`Error::TooMuchMemory`], [`Error::TooMuchWork`].
pub(crate) fn partition(
    propagation: &mut Propagation,
    prepared: &PreparedDomain,
    coarse: &CoarseSamples,
    located: &LocatedHandles,
    input: &SolveInput,
) -> Result<Partition, Error> {
    let PreparedDomain { domain, navigation, .. } = prepared;
    let obstacles = Obstacles::new(&located.skeleton, navigation, input.fix_boundary.then_some(domain));
    let mut inserter = SiteInserter::new(navigation, coarse, &obstacles, propagation, input.weighting.continuity);
    let mut tessellation = Tessellation::new(&obstacles);
    tessellation.insert_real_sites(&mut inserter, &located.points)?;
    let rounds = insert_virtual_sites(&mut inserter, &mut tessellation, input.density)?;
    inserter.measure_cells();
    // Upper bounds of the radii: the obstacles that extended fields reach only reduce them.
    let radii = support_radii(&input.weighting, inserter.sites());
    inserter.extend_fields(&radii)?;
    Ok(inserter.into_partition(rounds))
}

/// Computes the weights of the samples (eq. 2), the cell graph, the harmonic fields (eq. 4), and the mesh in drawing
/// order.
///
/// # Errors
/// [`Error::TooMuchMemory`] if the samples have more than [`MAX_WEIGHTS`](crate::limits::MAX_WEIGHTS) weights.
pub(crate) fn compute_weights(
    propagation: &mut Propagation,
    prepared: Arc<PreparedDomain>,
    input: &SolveInput,
    located: LocatedHandles,
    samples: Samples,
    partition: Partition,
) -> Result<Solution, Error> {
    let LocatedHandles { skeleton, outside, .. } = located;
    let Partition { mut sites, mut fields, rounds } = partition;
    let navigation = &prepared.navigation;
    set_radii(&mut sites, &input.weighting);
    extend_fields(propagation, navigation, &sites, &mut fields);
    let graph = SiteGraph::new(&sites, &fields, &skeleton);
    let harmonic = HarmonicFields::new(&sites, &graph);
    let basis = Basis::new(input.weighting.degree, input.weighting.filling);
    let penumbrae = match input.weighting.continuity {
        Continuity::Exact => Vec::new(),
        Continuity::C2 => penumbrae(propagation, navigation, &sites, &fields),
    };
    let functions = WeightFunctions::new(navigation, &sites, (fields, penumbrae), &skeleton, basis);
    let SampleWeights { mut weights, phi_sums, nearest } = functions.of_samples(navigation, &samples)?;
    let quadrature =
        (input.mode == PoseMode::Rigid).then(|| Quadrature::new(navigation, &sites, &samples, &weights, &functions));
    let poser = Poser::new(PoserInput {
        sites: &sites,
        graph: &graph,
        harmonic: &harmonic,
        skeleton,
        handles: input.handles.clone(),
        mode: input.mode,
        quadrature,
        stiffness: input.stiffness.clone(),
        picture: input.picture,
        displacement: input.displacement.clone(),
    });
    let mut loose = Loose::default();
    let mut leading = leading_parts(&nearest, &sites, &harmonic);
    if input.loose_parts == LooseParts::Follow {
        loose = Loose::new(navigation, &samples, &functions.islands());
        let owners = loose.owners(navigation, &samples);
        weights = weights.copied(&owners);
        leading = owners.iter().map(|&owner| leading[owner as usize]).collect();
    }
    weights.push_copies(&samples.skirt.owners);
    leading.extend(samples.skirt.owners.iter().map(|&owner| leading[owner as usize]).collect::<Vec<_>>());
    Ok(Solution {
        background: prepared.background_size.map(|size| StaticBackground::new(&samples, size)).unwrap_or_default(),
        samples: samples.len(),
        feather: samples.feather.clone(),
        mesh: RenderMesh::new(samples, &leading),
        weights,
        phi_sums,
        solved: SolvedSites { sites, graph, harmonic, poser, nearest },
        rounds,
        weighting: input.weighting.clone(),
        functions,
        loose,
        handle_counts: input.handle_counts(),
        outside,
        prepared,
        #[cfg(feature = "raster")]
        fill: None,
    })
}

/// Sets r_i (eq. 3), and the precedence of point handles.
fn set_radii(sites: &mut [Site], weighting: &Weighting) {
    let supports = support_radii(weighting, sites);
    let precedence: Vec<f64> = precedence_radii(weighting, sites).collect();
    for (site, (support, precedence)) in sites.iter_mut().zip(supports.into_iter().zip(precedence)) {
        (site.support_radius, site.precedence_radius) = (support, precedence);
    }
}

/// For each site, the penumbrae in its support.
fn penumbrae(
    propagation: &mut Propagation,
    navigation: &Navigation,
    sites: &[Site],
    fields: &[SiteField],
) -> Vec<Penumbrae> {
    let of_site = |(site, field): (&Site, &SiteField)| {
        let bound = Penumbrae::field_bound(site.support_radius);
        propagation.field(navigation, field.triangle, site.rest, bound);
        propagation.penumbrae(navigation, site.support_radius)
    };
    sites.iter().zip(fields).map(of_site).collect()
}

/// Extends the fields of sites to their supports and to the sites that they may be linked with.
fn extend_fields(propagation: &mut Propagation, navigation: &Navigation, sites: &[Site], fields: &mut [SiteField]) {
    for (site, field) in sites.iter().zip(fields) {
        let bound = site.support_radius.max(SiteGraph::field_bound(site.cell_radius));
        if field.distances.bound() < bound {
            field.distances = propagation.field(navigation, field.triangle, site.rest, bound);
        }
    }
}
