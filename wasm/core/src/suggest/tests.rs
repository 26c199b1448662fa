use std::collections::BTreeSet;

use glam::DVec2;

use super::{SuggestedHandle, SuggestedRole, suggest, suggest_beside};
use crate::{
    distance::Navigation,
    domain::{Domain, Ring},
    project::Handle,
};

fn domain(rings: &[Ring]) -> Domain {
    Domain::from_rings(rings).unwrap()
}

/// A star with its tips.
fn star(tips: usize) -> (Domain, Vec<DVec2>) {
    let corner = |at: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::PI * at as f64 / tips as f64);
        DVec2::new(200.0, 200.0) + DVec2::new(sin, -cos) * if at.is_multiple_of(2) { 190.0 } else { 70.0 }
    };
    let ring: Ring = (0..2 * tips).map(corner).collect();
    (domain(std::slice::from_ref(&ring)), ring.into_iter().step_by(2).collect())
}

/// A head with a neck on a body with a long tail.
fn animal() -> Ring {
    let corners = [
        (60, 20),
        (130, 20),
        (150, 60),
        (130, 95),
        (110, 100),
        (110, 130),
        (180, 150),
        (240, 150),
        (330, 60),
        (350, 70),
        (260, 180),
        (230, 240),
        (220, 330),
        (190, 330),
        (180, 250),
        (110, 250),
        (100, 330),
        (70, 330),
        (60, 200),
        (85, 130),
        (85, 100),
        (50, 90),
        (40, 50),
    ];
    corners.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y))).to_vec()
}

/// A limb on the axis has one end, though its tip has two corners.
#[test]
fn cross_has_four_ends() {
    for thick in [10.0, 20.0, 30.0] {
        let (near, far) = (50.0 - thick / 2.0, 50.0 + thick / 2.0);
        let right = [(near, 0.0), (far, 0.0), (far, near), (100.0, near), (100.0, far), (far, far)];
        let left = [(far, 100.0), (near, 100.0), (near, far), (0.0, far), (0.0, near), (near, near)];
        let ring: Ring = right.into_iter().chain(left).map(DVec2::from).collect();
        let ends = of_role(&suggest(&domain(&[ring]), None), SuggestedRole::End);
        assert_eq!(ends.len(), 4, "{ends:?}");
        assert_eq!(ends.iter().filter(|end| (end.x - 50.0).abs() < 2.0).count(), 2, "{ends:?}");
    }
}

fn of_role(handles: &[SuggestedHandle], role: SuggestedRole) -> Vec<DVec2> {
    handles.iter().filter(|handle| handle.role == role).map(|handle| handle.rest).collect()
}

/// Handles lie in the domain, apart from each other, and have different ids.
fn assert_usable(domain: &Domain, handles: &[SuggestedHandle]) {
    let navigation = Navigation::new(domain);
    for (at, handle) in handles.iter().enumerate() {
        assert!(navigation.located(handle.rest).is_some(), "{handle:?}");
        assert!(handles[..at].iter().all(|other| other.rest.distance(handle.rest) > 1.0), "{handle:?}");
    }
    let ids: BTreeSet<&str> = handles.iter().map(|handle| handle.id.as_str()).collect();
    assert_eq!(ids.len(), handles.len());
}

#[test]
fn ends_of_a_star_are_its_tips() {
    for tips in [4, 5, 7] {
        let (star, tips) = star(tips);
        let handles = suggest(&star, None);
        assert_usable(&star, &handles);
        let ends = of_role(&handles, SuggestedRole::End);
        assert_eq!(ends.len(), tips.len());
        for tip in tips {
            assert!(ends.iter().any(|end| end.distance(tip) < 30.0), "{tip}: {handles:?}");
        }
        let [middle] = of_role(&handles, SuggestedRole::Middle)[..] else { panic!("{handles:?}") };
        assert!(middle.distance(DVec2::splat(200.0)) < 4.0, "{middle}");
    }
}

#[test]
fn ends_of_an_animal_are_its_head_feet_and_tail() {
    let animal = domain(&[animal()]);
    let handles = suggest(&animal, None);
    assert_usable(&animal, &handles);
    assert!((5..=14).contains(&handles.len()), "{handles:?}");
    let ends = of_role(&handles, SuggestedRole::End);
    // The middle of the head, but the tips of the others.
    for end in [(95.0, 58.0), (85.0, 310.0), (205.0, 310.0), (335.0, 72.0)] {
        assert!(ends.iter().any(|p| p.distance(end.into()) < 18.0), "{end:?}: {handles:?}");
    }
}

#[test]
fn mirrored_domains_have_mirrored_handles() {
    let ring = animal();
    let mirrored: Ring = ring.iter().map(|p| DVec2::new(391.0 - p.x, p.y)).rev().collect();
    let (one, other) = (suggest(&domain(&[ring]), None), suggest(&domain(&[mirrored]), None));
    assert_eq!(one.len(), other.len());
    for handle in &one {
        let at = DVec2::new(391.0 - handle.rest.x, handle.rest.y);
        let twin = other.iter().find(|twin| twin.rest.distance(at) < 4.0 && twin.role == handle.role);
        let side = |id: &str| (id.contains("left"), id.contains("right"));
        let (twin, (left, right)) = (twin.unwrap_or_else(|| panic!("{handle:?} / {other:?}")), side(&handle.id));
        assert_eq!(side(&twin.id), (right, left), "{handle:?} {twin:?}");
    }
}

#[test]
fn large_islands_come_first_and_crumbs_have_no_handle() {
    let square = |x: f64, y: f64, side: f64| {
        // Not upright, so not a picture.
        [(0.0, 0.1), (0.9, 0.0), (1.0, 0.9), (0.1, 1.0)].map(|(u, v)| DVec2::new(x + u * side, y + v * side)).to_vec()
    };
    let at = |i: usize| DVec2::new((i % 10) as f64, (i / 10) as f64) * 40.0;
    let many: Vec<Ring> = (0..60).map(|i| square(at(i).x, at(i).y, 20.0 + (i % 7) as f64)).collect();
    let many = domain(&many);
    let handles = suggest(&many, None);
    assert_usable(&many, &handles);
    assert_eq!(of_role(&handles, SuggestedRole::Middle).len(), 14);
    let few = domain(&[square(0.0, 0.0, 100.0), square(150.0, 0.0, 60.0), square(120.0, 120.0, 4.0)]);
    let handles = suggest(&few, None);
    assert_usable(&few, &handles);
    assert_eq!(of_role(&handles, SuggestedRole::Middle).len(), 2);
    assert!(handles.iter().all(|handle| handle.rest.y < 110.0 || handle.rest.x < 110.0));
}

#[test]
fn tiny_and_thin_domains_have_handles() {
    let point = domain(&[vec![DVec2::new(7.0, 7.5), DVec2::new(7.5, 7.0), DVec2::new(8.0, 7.5), DVec2::new(7.5, 8.0)]]);
    assert_eq!(suggest(&point, None).len(), 1);
    let pixel = domain(&[[(3.0, 3.0), (4.0, 3.0), (4.0, 4.0), (3.0, 4.0)].map(DVec2::from).to_vec()]);
    assert_eq!(suggest(&pixel, None).len(), 1);
    // A line as thin as a pixel across a large picture.
    let line = domain(&[[(10.0, 10.0), (3900.0, 2900.0), (3899.4, 2900.8), (9.4, 10.8)].map(DVec2::from).to_vec()]);
    let handles = suggest(&line, None);
    assert_usable(&line, &handles);
    assert_eq!(of_role(&handles, SuggestedRole::End).len(), 2);
    assert!(handles.len() >= 5, "{handles:?}");
}

#[test]
fn suggests_the_requested_number_of_handles() {
    let (star, _) = star(5);
    let picture = Domain::rectangle(640, 480);
    for count in [1, 2, 3, 8, 20, 60] {
        for domain in [&star, &picture] {
            let handles = suggest(domain, Some(count));
            assert_usable(domain, &handles);
            assert_eq!(handles.len(), count);
        }
    }
}

#[test]
fn pictures_without_an_outline_have_even_rows() {
    let handles = suggest(&Domain::rectangle(640, 480), None);
    let ids: Vec<&str> = handles.iter().map(|handle| handle.id.as_str()).collect();
    let rows = ["top-left", "top", "top-right", "left", "middle", "right", "bottom-left", "bottom", "bottom-right"];
    assert_eq!(ids, rows);
    assert!(handles.iter().all(|handle| handle.role == SuggestedRole::Spread));
}

/// The way from each suggested handle to the nearest of the given handles.
fn ways_to(domain: &Domain, suggested: &[SuggestedHandle], there: &[DVec2]) -> Vec<f64> {
    let way = |handle: &SuggestedHandle| there.iter().map(|p| p.distance(handle.rest)).fold(f64::INFINITY, f64::min);
    assert_usable(domain, suggested);
    suggested.iter().map(way).collect()
}

#[test]
fn existing_handles_keep_their_positions() {
    let (star, tips) = star(5);
    let all = suggest(&star, None);
    assert_eq!(suggest_beside(&star, &[]), all);
    // One by eye near a tip, and one in the middle.
    let there = [tips[1].lerp(DVec2::splat(200.0), 0.12), DVec2::new(206.0, 197.0)];
    let handles = [Handle::point("hand", there[0]), Handle::point("middle", there[1])];
    let suggested = suggest_beside(&star, &handles);
    let ways = ways_to(&star, &suggested, &there);
    assert!(ways.iter().all(|&way| way > 40.0), "{suggested:?}");
    assert_eq!(of_role(&suggested, SuggestedRole::End).len(), 4);
    assert!(suggested.iter().all(|handle| handle.id != "middle" && handle.id != "hand"));
    // All of them exist already.
    let full: Vec<Handle> = all.iter().map(|handle| Handle::point(handle.id.clone(), handle.rest)).collect();
    assert_eq!(suggest_beside(&star, &full), []);
}

#[test]
fn bars_and_polygons_occupy_the_cells_along_and_inside_them() {
    let animal = domain(&[animal()]);
    let bar = Handle::bar("tail", [(230.0, 160.0), (340.0, 68.0)]);
    let polygon = Handle::polygon("head", [(50.0, 30.0), (125.0, 30.0), (140.0, 60.0), (120.0, 90.0), (55.0, 85.0)]);
    let suggested = suggest_beside(&animal, &[bar, polygon]);
    assert_usable(&animal, &suggested);
    assert!(!suggested.is_empty());
    for SuggestedHandle { rest, .. } in &suggested {
        assert!(!(rest.x < 145.0 && rest.y < 95.0), "{rest}: in the head");
        assert!(rest.x < 235.0, "{rest}: along the tail");
    }
}

#[test]
fn many_handles_leave_no_position() {
    let picture = Domain::rectangle(640, 480);
    let grid =
        (0..64).map(|k| Handle::point(k.to_string(), [f64::from(k % 8) * 80.0 + 40.0, f64::from(k / 8) * 60.0 + 30.0]));
    assert_eq!(suggest_beside(&picture, &grid.collect::<Vec<_>>()), []);
    // Handles beside the picture do not matter.
    assert_eq!(suggest_beside(&picture, &[Handle::point("far", [-900.0, 20.0])]).len(), 9);
    // A crowd in the middle leaves the tips.
    let (star, tips) = star(5);
    let at = |k: i32| DVec2::new(190.0 + f64::from(k % 6) * 4.0, 190.0 + f64::from(k / 6) * 4.0);
    let crowd: Vec<Handle> = (0..30).map(|k| Handle::point(k.to_string(), at(k))).collect();
    let ends = of_role(&suggest_beside(&star, &crowd), SuggestedRole::End);
    assert_eq!(ends.len(), tips.len());
}

#[test]
fn symmetric_domains_have_handles_in_pairs() {
    let oval = |k: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(k) / 24.0);
        DVec2::new(200.0 + 150.0 * sin, 200.0 - 190.0 * cos)
    };
    for symmetric in [star(5).0, star(8).0, domain(&[(0..24).map(oval).collect()])] {
        let handles = suggest(&symmetric, None);
        assert_usable(&symmetric, &handles);
        for SuggestedHandle { rest, role, .. } in &handles {
            let twin = DVec2::new(400.0 - rest.x, rest.y);
            let has_twin = handles.iter().any(|other| other.role == *role && other.rest.distance(twin) < 3.0);
            assert!(has_twin, "{rest}: {handles:?}");
        }
    }
}

/// A body with a limb that is bent at its elbow, on both sides.
#[test]
fn bent_limbs_have_joints_at_their_bends() {
    let right = [(40, 60), (150, 60), (150, -60), (180, -60), (180, 90), (40, 90), (40, 240)];
    let half: Vec<DVec2> = right.iter().map(|&(x, y)| DVec2::new(f64::from(x), f64::from(y))).collect();
    let mirrored = half.iter().rev().map(|p| DVec2::new(-p.x, p.y));
    let figure = domain(&[half.iter().copied().chain(mirrored).collect()]);
    let handles = suggest(&figure, None);
    assert_usable(&figure, &handles);
    for elbow in [DVec2::new(165.0, 75.0), DVec2::new(-165.0, 75.0)] {
        let joints = of_role(&handles, SuggestedRole::Joint);
        assert!(joints.iter().any(|joint| joint.distance(elbow) < 12.0), "{elbow}: {handles:?}");
    }
}

/// A long hair would be a limb by its length.
#[test]
fn whiskers_have_no_handles() {
    let face = |k: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(k) / 40.0);
        DVec2::new(200.0 + 100.0 * sin, 200.0 - 100.0 * cos)
    };
    // The whisker lies between two corners of the face.
    let whisker = [DVec2::new(420.0, 199.0), DVec2::new(420.0, 202.0)];
    let ring: Ring = (0..=10).map(face).chain(whisker).chain((11..40).map(face)).collect();
    let handles = suggest(&domain(&[ring]), None);
    assert!(handles.iter().all(|handle| handle.rest.x < 310.0), "{handles:?}");
}

#[test]
fn ears_belong_to_the_head() {
    // A square body with a neck, and a head with two ears.
    let right = [(14, 160), (44, 130), (44, 90), (52, 50), (30, 68), (0, 64)];
    let body = [(0, 400), (90, 400), (90, 230), (14, 205)];
    let half = body.into_iter().chain(right);
    let half: Vec<DVec2> = half.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y))).collect();
    let mirrored = half.iter().rev().filter(|p| p.x > 0.0).map(|p| DVec2::new(-p.x, p.y));
    let animal = domain(&[half.iter().copied().chain(mirrored).collect()]);
    let handles = suggest(&animal, None);
    assert_usable(&animal, &handles);
    let in_head: Vec<&SuggestedHandle> = handles.iter().filter(|handle| handle.rest.y < 150.0).collect();
    let [head] = in_head[..] else { panic!("{handles:?}") };
    assert!(head.rest.distance(DVec2::new(0.0, 110.0)) < 16.0, "{head:?}");
}
