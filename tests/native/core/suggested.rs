//! Tests of suggested handles on the samples of the editor.

use std::{collections::BTreeSet, path::Path};

use c2warp::{
    Picture,
    domain::Domain,
    suggest::{SuggestedHandle, SuggestedRole, suggest},
};
use glam::DVec2;

/// Samples that bend where they are opaque.
const SAMPLES: [&str; 8] = ["cactus", "cat", "gingerbread", "giraffe", "octopus", "robot", "salamander", "snake"];

/// Handles are this many widths of their limbs apart. Round places, such as a head on a trunk, may touch.
const LEAST_WIDTHS: f64 = 0.95;

fn suggested(sample: &str) -> (Domain, Vec<SuggestedHandle>) {
    let file = format!("../web/public/samples/{sample}.png");
    let picture = image::open(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).expect("a sample").into_rgba8();
    let (width, height) = picture.dimensions();
    let pixels = Picture::new(width, height, picture.as_raw()).expect("pixels of this size");
    let domain = Domain::new(None, &pixels).expect("a sample with an outline");
    let handles = suggest(&domain, None);
    (domain, handles)
}

fn ids(sample: &str) -> BTreeSet<String> {
    suggested(sample).1.into_iter().map(|handle| handle.id).collect()
}

/// The distance from a point to the outline, which is half the width of a limb there.
fn half_width(domain: &Domain, p: DVec2) -> f64 {
    let edges = domain.rings().iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
    let distance = |(a, b): (&DVec2, &DVec2)| {
        let along = ((p - a).dot(b - a) / a.distance_squared(*b)).clamp(0.0, 1.0);
        p.distance(a.lerp(*b, along))
    };
    edges.map(distance).fold(f64::INFINITY, f64::min)
}

#[test]
fn handles_are_a_limbs_width_apart() {
    for sample in SAMPLES {
        let (domain, handles) = suggested(sample);
        assert!((5..=14).contains(&handles.len()), "{sample}: {handles:?}");
        for (at, one) in handles.iter().enumerate() {
            for other in &handles[..at] {
                let width = half_width(&domain, one.rest) + half_width(&domain, other.rest);
                let widths = one.rest.distance(other.rest) / width;
                assert!(widths >= LEAST_WIDTHS, "{sample}: {} and {}: {widths} widths", one.id, other.id);
            }
        }
    }
}

#[test]
fn each_figure_has_one_trunk() {
    for sample in SAMPLES {
        let (_, handles) = suggested(sample);
        assert_eq!(handles.iter().filter(|handle| handle.role == SuggestedRole::Middle).count(), 1, "{sample}");
    }
}

#[test]
fn names_tell_part_and_side() {
    let robot = ids("robot");
    for id in ["head", "body", "left-arm-end", "left-arm-joint", "right-leg-end", "right-leg-joint"] {
        assert!(robot.contains(id), "{id}: {robot:?}");
    }
    let salamander = ids("salamander");
    for id in ["head", "body", "tail-end", "upper-left-leg-end", "lower-right-leg-joint"] {
        assert!(salamander.contains(id), "{id}: {salamander:?}");
    }
    let giraffe = ids("giraffe");
    for id in ["head", "neck", "body", "tail-end", "left-leg-2-end", "right-leg-2-joint"] {
        assert!(giraffe.contains(id), "{id}: {giraffe:?}");
    }
}

/// The left and right limbs of a symmetric figure have equally many handles, and so have their names.
#[test]
fn pairs_of_limbs_have_pairs_of_names() {
    for sample in ["gingerbread", "octopus", "robot"] {
        let ids = ids(sample);
        for id in &ids {
            let other = id.replace("left", "?").replace("right", "left").replace('?', "right");
            assert!(ids.contains(&other), "{sample}: {other} is missing in {ids:?}");
        }
    }
}

#[test]
fn each_limb_of_an_octopus_has_a_joint_and_an_end() {
    let ids = ids("octopus");
    for limb in ["left-leg", "left-leg-2", "left-leg-3", "right-leg", "right-leg-2", "right-leg-3"] {
        for place in ["joint", "end"] {
            assert!(ids.contains(&format!("{limb}-{place}")), "{limb}: {ids:?}");
        }
    }
}
