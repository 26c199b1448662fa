use glam::{DAffine2, DVec2};

use super::Fitter;
use crate::{
    Picture, Solution,
    error::Error,
    project::{Clip, DomainSpec, Ease, Handle, Key, Looping, Project, Track},
    solve,
};

/// A boot of two bars, at a place in a picture, with sides in whole pixels.
fn boot(size: (u32, u32), at: (u32, u32), side: (u32, u32)) -> Vec<u8> {
    let inside = |x: u32, y: u32| {
        let (x, y) = (x.checked_sub(at.0).map(|x| x / side.0), y.checked_sub(at.1).map(|y| y / side.1));
        matches!((x, y), (Some(0..3), Some(0..10)) | (Some(0..8), Some(7..10)))
    };
    let pixels = (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y)));
    pixels.flat_map(|(x, y)| [90, 60, 30, if inside(x, y) { 255 } else { 0 }]).collect()
}

/// A project for a boot at (10, 20) with sides of 6 px, in a picture of 80 × 100 px.
fn project() -> Project {
    let toe = Handle::point("toe", [50.0, 70.0]).posed_at([[56.0, 58.0]]).turned(-10.0);
    let top = Handle::point("top", [19.0, 26.0]);
    let leg = Handle::bar("leg", [[19.0, 40.0], [19.0, 60.0]]).posed_at([[21.0, 40.0], [17.0, 60.0]]);
    let keys = [Key::new(0.0, Ease::Smooth).posed_at([[50.0, 70.0]]), Key::new(1.0, Ease::Smooth).turned(20.0)];
    let clip = Clip::new("tap", 2.0, Looping::Repeat).with_tracks([Track::new("toe", keys)]);
    Project::for_picture(80, 100).with_handles([toe, top, leg]).with_clips([clip])
}

fn solved(project: &Project, picture: &Picture<'_>) -> (Solution, Project) {
    (solve(project, picture).unwrap(), project.clone())
}

/// The maximum distance of a warp from another one that is mapped, over points of the boot.
fn difference(one: &(Solution, Project), other: &(Solution, Project), map: &DAffine2) -> f64 {
    let [pose, other_pose] = [one, other].map(|(solution, project)| solution.pose(project).unwrap());
    let points = (0..30).map(|i| DVec2::new(12.0 + f64::from(i % 3) * 6.0, 22.0 + f64::from(i) * 1.8));
    let differences = points.map(|p| {
        let [at, other_at] =
            [one.0.map(&pose, p).unwrap().posed, other.0.map(&other_pose, map.transform_point2(p)).unwrap().posed];
        map.transform_point2(at).distance(other_at)
    });
    differences.fold(0.0, f64::max)
}

#[test]
fn picture_of_twice_the_size_gets_the_warp_twice_as_large() {
    let (small, large) = (boot((80, 100), (10, 20), (6, 6)), boot((160, 200), (20, 40), (12, 12)));
    let [small, large] = [Picture::new(80, 100, &small).unwrap(), Picture::new(160, 200, &large).unwrap()];
    let twice = DAffine2::from_scale(DVec2::splat(2.0));
    let first = solved(&project(), &small);
    for fitter in [Fitter::by_box(project()), Fitter::by_alpha(project(), &small).unwrap()] {
        let fitted = fitter.fit(&large).unwrap();
        assert!(fitted.moved.is_empty());
        assert_eq!((fitted.project.image.width, fitted.project.image.height), (160, 200));
        let clip = &fitted.project.clips[0].tracks[0].keys;
        assert!(clip[0].posed.as_ref().unwrap()[0].distance(DVec2::new(100.0, 140.0)) < 1e-9);
        assert_eq!(fitted.project.handles[0].rotation, (-10.0).into());
        // Contours of a larger picture are rounded in other places.
        let apart = difference(&first, &solved(&fitted.project, &large), &twice);
        assert!(apart < 0.7, "{apart}");
    }
}

#[test]
fn moved_and_scaled_outline_gets_the_same_warp_there() {
    let (own, other) = (boot((80, 100), (10, 20), (6, 6)), boot((300, 160), (140, 30), (12, 12)));
    let [own, other] = [Picture::new(80, 100, &own).unwrap(), Picture::new(300, 160, &other).unwrap()];
    let fitted = Fitter::by_alpha(project(), &own).unwrap().fit(&other).unwrap();
    assert!(fitted.moved.is_empty());
    let map = DAffine2::from_scale_angle_translation(DVec2::splat(2.0), 0.0, DVec2::new(120.0, -10.0));
    let toe = fitted.project.handles[0].shape.rest()[0];
    assert!(toe.distance(map.transform_point2(DVec2::new(50.0, 70.0))) < 0.5, "{toe}");
    let apart = difference(&solved(&project(), &own), &solved(&fitted.project, &other), &map);
    assert!(apart < 0.7, "{apart}");
}

#[test]
fn added_part_or_turned_outline_keeps_handles_on_their_parts() {
    let own = boot((80, 100), (10, 20), (6, 6));
    let own = Picture::new(80, 100, &own).unwrap();
    let fitter = Fitter::by_alpha(project(), &own).unwrap();
    // A thin feather on the boot changes its box by half.
    let mut feathered = boot((120, 140), (10, 60), (6, 6));
    for y in 20..70 {
        feathered[(y * 120 + 15) * 4 + 3] = 255;
        feathered[(y * 120 + 16) * 4 + 3] = 255;
    }
    let picture = Picture::new(120, 140, &feathered).unwrap();
    let toe = fitter.fit(&picture).unwrap().project.handles[0].shape.rest()[0];
    assert!(toe.distance(DVec2::new(50.0, 110.0)) < 6.0, "{toe}");
    // The boot turned by half a turn.
    let turned: Vec<u8> = own.rgba().as_chunks::<4>().0.iter().rev().flatten().copied().collect();
    let picture = Picture::new(80, 100, &turned).unwrap();
    let toe = fitter.fit(&picture).unwrap().project.handles[0].shape.rest()[0];
    assert!(toe.distance(DVec2::new(30.0, 30.0)) < 0.5, "{toe}");
}

#[test]
fn handles_outside_move_inside_with_their_poses_or_are_named() {
    // The boot of the other picture is 2 px lower, and so the handle at its rim lies outside.
    let rim = Handle::point("rim", [19.0, 20.5]).posed_at([[25.0, 14.0]]);
    let keys = [Key::new(0.0, Ease::Hold).posed_at([[19.0, 10.0]])];
    let clip = Clip::new("lift", 1.0, Looping::None).with_tracks([Track::new("rim", keys)]);
    let project = project().with_handles([rim]).with_clips([clip]);
    let lower = boot((80, 100), (10, 22), (6, 6));
    let picture = Picture::new(80, 100, &lower).unwrap();
    let fitted = Fitter::by_box(project.clone()).fit(&picture).unwrap();
    assert_eq!(fitted.moved.len(), 1);
    assert_eq!(fitted.moved[0].id, "rim");
    let shape = &fitted.project.handles[0].shape;
    let by = shape.rest()[0] - DVec2::new(19.0, 20.5);
    assert!(by.x == 0.0 && by.y > 1.5 && by.y <= 4.0 && (by.length() - fitted.moved[0].distance).abs() < 1e-12);
    assert_eq!(shape.posed()[0], DVec2::new(25.0, 14.0) + by);
    assert_eq!(fitted.project.clips[0].tracks[0].keys[0].posed, Some(vec![DVec2::new(19.0, 10.0) + by]));
    solve(&fitted.project, &picture).unwrap();

    let far = boot((80, 100), (10, 32), (6, 6));
    let error = Fitter::by_box(project).fit(&Picture::new(80, 100, &far).unwrap()).unwrap_err();
    assert_eq!(error.handles(), ["rim"]);
    assert!(matches!(error, Error::HandleFarOutside { .. }), "{error}");
}

#[test]
fn drawn_domain_is_mapped_and_cut_at_the_borders() {
    let ring = [[0.0, 0.0], [80.0, 0.0], [80.0, 100.0], [0.0, 100.0]].map(DVec2::from).to_vec();
    let mut project = project();
    project.domain = Some(DomainSpec::polygon(vec![ring]));
    let opaque = vec![255; 37 * 53 * 4];
    let picture = Picture::new(37, 53, &opaque).unwrap();
    let fitted = Fitter::by_box(project).fit(&picture).unwrap();
    let corners = [[0.0, 0.0], [37.0, 0.0], [37.0, 53.0], [0.0, 53.0]].map(DVec2::from).to_vec();
    assert_eq!(fitted.project.domain, Some(DomainSpec::polygon(vec![corners])));
    solve(&fitted.project, &picture).unwrap();
}

#[test]
fn pictures_without_outline_are_refused() {
    let (own, opaque) = (boot((80, 100), (10, 20), (6, 6)), vec![255; 80 * 100 * 4]);
    let [own, opaque] = [&own, &opaque].map(|rgba| Picture::new(80, 100, rgba).unwrap());
    assert_eq!(Fitter::by_alpha(project(), &opaque).unwrap_err(), Error::NoOutline);
    assert_eq!(Fitter::by_alpha(project(), &own).unwrap().fit(&opaque).unwrap_err(), Error::NoOutline);
}
