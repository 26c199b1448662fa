//! Tests of the drawing order where a picture overlaps itself.

use c2warp::{
    Picture, ResampleOptions, Solution,
    deform::Pose,
    project::{Handle, PoseMode, Project, Rotation, Support},
};
use c2warp_tests::Random;
use glam::DVec2;

use crate::handles::{bar, point_handle, polygon};
use crate::scenes::{SIZE, project, solved};

const RED: [u8; 4] = [220, 30, 30, 255];
const BLUE: [u8; 4] = [30, 30, 220, 255];

/// Returns a hip with two legs that cross.
fn crossing(depths: [f64; 3]) -> Project {
    let ring = [(60, 40), (340, 40), (340, 360), (230, 360), (230, 140), (170, 140), (170, 360), (60, 360)];
    let ring = ring.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y))).to_vec();
    let moves = [((200.0, 70.0), (200.0, 70.0)), ((115.0, 340.0), (285.0, 330.0)), ((285.0, 340.0), (115.0, 330.0))];
    let moves = moves.map(|(rest, posed)| (DVec2::from(rest), DVec2::from(posed)));
    let mut project = project(&[ring], &moves.map(|(rest, _)| rest), Support::Smooth);
    project.pose.density = 20;
    let posed = |(id, (rest, posed)): (usize, (DVec2, DVec2))| {
        let degrees = [0.0, -35.0, 35.0][id];
        point_handle(id, rest, posed, degrees).at_depth(depths[id])
    };
    project.handles = moves.into_iter().enumerate().map(posed).collect();
    project
}

fn posed(project: &Project) -> (Solution, Pose) {
    let solution = solved(project).expect("a valid scene");
    let pose = solution.poser().pose(&project.handles, project.pose.blend).expect("finite");
    (solution, pose)
}

/// The same handle where it rests.
fn point_at_rest(handle: &Handle) -> Handle {
    Handle::point(handle.id.clone(), handle.shape.rest()[0]).at_depth(handle.depth)
}

/// Warps a figure that is red on the left and blue on the right.
fn warped(project: &Project) -> Vec<u8> {
    let (solution, pose) = posed(project);
    let rgba: Vec<u8> = (0..SIZE * SIZE).flat_map(|at| if at % SIZE < SIZE / 2 { RED } else { BLUE }).collect();
    let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
    solution.warped(&picture, &pose, ResampleOptions::default()).expect("a fair size").rgba
}

/// Returns the numbers of red and of blue pixels around the crossing of the legs.
fn at_the_crossing(project: &Project) -> [usize; 2] {
    let rgba = warped(project);
    let around = (240..260).flat_map(|y| (190..210).map(move |x| ((y * SIZE + x) * 4) as usize));
    let pixels: Vec<&[u8]> = around.map(|at| &rgba[at..at + 4]).collect();
    [RED, BLUE].map(|colour| pixels.iter().filter(|pixel| **pixel == colour).count())
}

#[test]
fn nearer_leg_covers_the_other() {
    for depth in [1.0, 1e-3, 1e6] {
        assert_eq!(at_the_crossing(&crossing([0.0, depth, -depth])), [400, 0]);
        assert_eq!(at_the_crossing(&crossing([0.0, -depth, depth])), [0, 400]);
    }
}

/// The upper arm of a C, red, is moved over the lower arm, blue. Along the bars only one colour may show.
#[test]
fn one_bar_covers_another_completely() {
    let c = [(60, 60), (340, 60), (340, 140), (90, 140), (90, 160), (340, 160), (340, 240), (60, 240)];
    let c = c.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y))).to_vec();
    for new_handle in [bar, polygon] {
        let new_handle = |id, rest: &[(f64, f64)], posed: &[(f64, f64)]| new_handle(id, rest, posed);
        let mut project = project(std::slice::from_ref(&c), &[], Support::Smooth);
        let (upper, lower) =
            ([(120.0, 100.0), (220.0, 98.0), (320.0, 100.0)], [(120.0, 200.0), (220.0, 202.0), (320.0, 200.0)]);
        let over = upper.map(|(x, y)| (x + 10.0, y + 100.0));
        project.handles = vec![new_handle("upper", &upper, &over), new_handle("lower", &lower, &lower)];
        let (solution, pose) = posed(&project);
        let rgba: Vec<u8> = (0..SIZE * SIZE).flat_map(|at| if at / SIZE < 150 { RED } else { BLUE }).collect();
        let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
        let rgba = solution.warped(&picture, &pose, ResampleOptions::default()).expect("a fair size").rgba;
        let along = (140..320).map(|x| ((200 * SIZE + x) * 4) as usize);
        let colours: Vec<&[u8]> = along.map(|at| &rgba[at..at + 4]).collect();
        assert!(colours.iter().all(|colour| *colour == colours[0]), "{colours:?}");
    }
}

#[test]
fn inverse_map_finds_the_nearer_leg() {
    let at = |depth: f64| {
        let (solution, pose) = posed(&crossing([0.0, depth, -depth]));
        solution.rest_point(&pose, DVec2::new(200.0, 250.0)).expect("both legs are there").x
    };
    assert!(at(1.0) < 200.0 && at(-1.0) > 200.0, "{} and {}", at(1.0), at(-1.0));
}

/// The mesh interpolates linearly between samples. At a spacing of h its error is k h² / 8 for a second derivative k.
/// Here h is about 2.5 px. A move of 8 px that fades out over 200 px has k of a few hundredths at most. So the error is
/// well below 0.1 px.
#[test]
fn inverse_map_returns_the_rest_position() {
    let corners = [(40.0, 40.0), (360.0, 40.0), (360.0, 360.0), (40.0, 360.0)].map(DVec2::from).to_vec();
    let mut project = project(&[corners], &[(100.0, 200.0), (300.0, 200.0)].map(DVec2::from), Support::Smooth);
    project.samples = 20_000;
    project.handles[0] = point_handle(0, DVec2::new(100.0, 200.0), DVec2::new(103.0, 207.0), 0.0);
    let (solution, pose) = posed(&project);
    // Rounding decides whether a vertex on the outline is inside.
    let inner = |&(p, _): &(&DVec2, DVec2)| p.min_element() > 41.0 && p.max_element() < 359.0;
    let vertices = solution.vertices().iter().zip(solution.posed_vertices(&pose));
    for (&p, posed) in vertices.filter(inner).step_by(37) {
        let back = solution.rest_point(&pose, posed).expect("a vertex of what is drawn");
        assert!(back.distance(p) < 1e-9, "{p} came back as {back}");
    }
    for p in (0..60).map(|i| DVec2::new(60.0 + 4.7 * f64::from(i), 70.0 + 73.0 * f64::from(i % 4) + 0.3)) {
        let mapped = solution.map(&pose, p).expect("inside");
        let back = solution.rest_point(&pose, mapped.posed).expect("inside what is drawn");
        assert!(back.distance(p) < 0.1, "{p} came back as {back}");
    }
    // The background around the ring stays. Everything outside the picture is empty.
    assert_eq!(solution.rest_point(&pose, DVec2::ZERO), Some(DVec2::ZERO));
    assert_eq!(solution.rest_point(&pose, DVec2::NEG_ONE), None);
}

#[test]
fn equal_depths_keep_the_drawing_order() {
    let flat = warped(&crossing([0.0; 3]));
    assert!(warped(&crossing([7.3; 3])) == flat && warped(&crossing([-1e9; 3])) == flat);
    let drawn = |depth: f64| {
        let (solution, pose) = posed(&crossing([depth; 3]));
        solution.drawn_triangles(&pose).into_owned()
    };
    assert_eq!(drawn(7.3), drawn(0.0));
    // At rest nothing crosses.
    let mut still = crossing([7.3; 3]);
    still.handles.iter_mut().for_each(|handle| *handle = point_at_rest(handle));
    let (solution, pose) = posed(&still);
    assert_eq!(solution.drawn_triangles(&pose), solution.triangles());
}

#[test]
fn depths_reorder_the_triangles() {
    let (solution, pose) = posed(&crossing([0.0, 1.0, 2.0]));
    let (mut drawn, mut all) = (solution.drawn_triangles(&pose).into_owned(), solution.triangles().to_vec());
    assert!(drawn != all);
    drawn.sort_unstable();
    all.sort_unstable();
    assert!(drawn == all);
}

/// Whether a place lies in a triangle of either orientation.
fn contains(corners: [DVec2; 3], p: DVec2) -> bool {
    let [a, b, c] = corners;
    let sides = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
}

/// Handles on a bent figure split the legs into cells of many depths and places in the order of the mesh. Wherever both
/// legs lie, the same one must be drawn.
#[test]
fn crossing_legs_stay_whole_when_handles_are_added() {
    let mut random = Random(30);
    let mut seen = [0; 2];
    for scene in 0..24 {
        let mut depth = || if scene % 2 == 0 { 0.0 } else { (4.0 * random.unit()).round() - 2.0 };
        let mut project = crossing([depth(), depth(), depth()]);
        project.pose.mode = PoseMode::Rigid;
        let (bent, pose) = posed(&project);
        for id in 3..4 + random.below(4) as usize {
            let rest = DVec2::new(70.0 + 260.0 * random.unit(), 50.0 + 300.0 * random.unit());
            let is_free = project.handles.iter().all(|handle| handle.shape.rest()[0].distance(rest) > 15.0);
            if let (true, Some(mapped)) = (is_free, bent.map(&pose, rest)) {
                let depth = if scene % 2 == 0 { 0.0 } else { random.below(3) as f64 };
                let added = point_handle(id, rest, mapped.posed, 0.0).turned(Rotation::Auto);
                project.handles.push(added.at_depth(depth));
            }
        }
        let (solution, pose) = posed(&project);
        let (rest, posed) = (solution.vertices(), solution.posed_vertices(&pose));
        let leg = |p: DVec2| (p.y > 150.0).then_some(usize::from(p.x > 200.0));
        let places: Vec<DVec2> = (0..60 * 60)
            .map(|at| DVec2::new(50.5 + 5.0 * f64::from(at % 60), 140.5 + 4.0 * f64::from(at / 60)))
            .collect();
        let drawn = solution.rest_points(&pose, &places);
        let mut tops = [0; 2];
        for (place, drawn) in places.iter().zip(drawn) {
            let there = |own: usize| {
                let of_leg = |t: &&[u32; 3]| t.iter().all(|&vertex| leg(rest[vertex as usize]) == Some(own));
                let mut triangles = solution.triangles().iter().filter(of_leg);
                triangles.any(|t| contains(t.map(|vertex| posed[vertex as usize]), *place))
            };
            if let Some(top) = drawn.and_then(leg)
                && there(0)
                && there(1)
            {
                tops[top] += 1;
            }
        }
        assert!(tops[0] == 0 || tops[1] == 0, "scene {scene}: legs show at {tops:?} places of their crossing");
        assert!(tops[0] + tops[1] > 20, "scene {scene}: the legs do not cross");
        seen[usize::from(tops[1] > 0)] += 1;
    }
    assert!(seen[0] > 0 && seen[1] > 0, "{seen:?}");
}
