//! A picture with unmoved handles is the picture: on cut-outs with hair, fur, glow, smoke, specks and narrow gaps.

use c2warp::{
    Picture, ResampleOptions, Solution,
    project::{DomainSpec, Handle, LooseParts, Project, Rotation},
    solve,
};
use c2warp_tests::Random;
use glam::DVec2;

use crate::alpha_shapes::{disc, stroke};

/// Side of the pictures in pixels.
const SIZE: u32 = 200;
/// Greatest difference in levels, with the rounding of colours.
const MAX_DIFFERENCE: f64 = 1.01;

/// Alpha from 0 to 1 at a place.
type Alpha = Box<dyn Fn(DVec2) -> f64>;

/// Coverage of a shape by its signed distance, at some opacity.
fn covered(depth: f64, opacity: f64) -> f64 {
    opacity * (depth + 0.5).clamp(0.0, 1.0)
}

fn place(random: &mut Random) -> DVec2 {
    f64::from(SIZE) * DVec2::new(random.unit(), random.unit())
}

/// Thin strands around a head, of about the given width and opacity.
fn strands(random: &mut Random, count: usize, width: f64, opacity: f64) -> Alpha {
    let head = DVec2::splat(100.0);
    let strands: Vec<(DVec2, DVec2, f64, f64)> = (0..count)
        .map(|_| {
            let out = DVec2::from_angle(std::f64::consts::TAU * random.unit());
            let length = 50.0 + 40.0 * random.unit();
            let width = width * (0.5 + random.unit());
            (head + 30.0 * out, head + length * out, width, opacity * (0.4 + 0.6 * random.unit()))
        })
        .collect();
    Box::new(move |p| {
        let hair = strands.iter().map(|&(a, b, width, opacity)| {
            // Thin strands cover a part of each pixel.
            let fade = 0.6 + 0.4 * libm::sin(p.distance(a) / 5.0);
            covered(stroke(a, b, width.max(1.0))(p), opacity * width.min(1.0) * fade)
        });
        hair.fold(covered(disc(head, 42.0)(p), 1.0), f64::max)
    })
}

/// A disc with a glow that fades over a number of pixels.
fn glow(fading: f64, opacity: f64) -> Alpha {
    Box::new(move |p| {
        let out = p.distance(DVec2::splat(100.0)) - 40.0;
        if out < 0.0 { 1.0 } else { opacity * libm::exp(-out / fading) }
    })
}

/// Puffs of smoke over a figure.
fn smoke(random: &mut Random) -> Alpha {
    let puffs: Vec<(DVec2, f64, f64)> = (0..8)
        .map(|_| {
            let at = DVec2::new(40.0 + 120.0 * random.unit(), 20.0 + 80.0 * random.unit());
            (at, 10.0 + 25.0 * random.unit(), 0.5 * random.unit())
        })
        .collect();
    Box::new(move |p| {
        let puff = |&(at, radius, opacity): &(DVec2, f64, f64)| {
            opacity * libm::exp(-p.distance_squared(at) / (radius * radius))
        };
        covered(disc(DVec2::new(100.0, 120.0), 45.0)(p), 1.0).max(puffs.iter().map(puff).fold(0.0, f64::max))
    })
}

/// A figure of two limbs with a soft gap between them, and specks around it.
fn specks(random: &mut Random) -> Alpha {
    let dust: Vec<DVec2> = (0..60).map(|_| place(random)).collect();
    Box::new(move |p| {
        let limb = |x: f64| stroke(DVec2::new(100.0, 60.0), DVec2::new(x, 170.0), 60.0)(p);
        let soft = |x: f64| 0.3 * libm::exp(-(limb(x) / 4.0).powi(2));
        let speck = dust.iter().map(|&at| covered(disc(at, 0.9)(p), 0.9)).fold(0.0, f64::max);
        let limbs = [70.0, 130.0].map(|x| covered(limb(x), 1.0).max(soft(x)));
        limbs[0].max(limbs[1]).max(speck)
    })
}

/// A comb with narrow gaps that are not quite empty, over a shadow.
fn comb(gap: f64, haze: f64) -> Alpha {
    Box::new(move |p| {
        let pitch = 14.0;
        let across = ((p.x - 20.0) % pitch - pitch / 2.0).abs();
        let tooth = (pitch - gap) / 2.0 - across;
        let body = (30.0 - (p.y - 100.0).abs()).min(80.0 - (p.x - 100.0).abs());
        let teeth = (75.0 - (p.y - 100.0).abs()).min(80.0 - (p.x - 100.0).abs()).min(tooth);
        let shadow = haze * libm::exp(-((p - DVec2::new(108.0, 110.0)).length() / 80.0).powi(4));
        covered(body.max(teeth), 1.0).max(shadow)
    })
}

/// Lines of strokes as in print, around a seal: loose parts, and lines of one pixel.
fn print(random: &mut Random, width: f64) -> Alpha {
    let letters: Vec<(DVec2, DVec2)> = (0..120)
        .map(|k| {
            let at = DVec2::new(10.0 + f64::from(k % 20) * 9.0, 12.0 + f64::from(k / 20) * 32.0);
            let by = DVec2::new(7.0 * random.unit(), 12.0 * random.unit() - 4.0);
            (at, at + by + DVec2::splat(0.1))
        })
        .collect();
    Box::new(move |p| {
        let letter = letters.iter().map(|&(a, b)| covered(stroke(a, b, width)(p), 1.0)).fold(0.0, f64::max);
        let rule = if (p.y - 185.5).abs() < 0.5 || (p.x - 5.5).abs() < 0.5 { 1.0 } else { 0.0 };
        letter.max(rule).max(covered(disc(DVec2::splat(100.0), 40.0)(p), 0.97))
    })
}

/// Thirty cut-outs with their names.
fn cut_outs() -> Vec<(&'static str, Alpha)> {
    let mut random = Random(30);
    let mut all = Vec::new();
    for k in 0..5 {
        let k = f64::from(k);
        all.push(("hair", strands(&mut random, 25, 0.6 + 0.3 * k, 1.0 - 0.1 * k)));
        all.push(("fur", strands(&mut random, 200, 1.0 + 0.2 * k, 0.9)));
        all.push(("glow", glow(4.0 + 6.0 * k, 0.9 - 0.1 * k)));
        all.push(("smoke", smoke(&mut random)));
        let other: (&str, Alpha) = match k as u32 {
            0 | 2 => ("specks", specks(&mut random)),
            _ => ("print", print(&mut random, 0.5 + 0.4 * k)),
        };
        all.push(other);
        all.push(("comb", comb(0.5 + k, 0.15 * k)));
    }
    all
}

/// The pixels of a cut-out with a pattern of colours.
fn pixels(alpha: &Alpha) -> Vec<u8> {
    let pixel = |i: u32| {
        let (x, y) = (i % SIZE, i / SIZE);
        let level = 255.0 * alpha(DVec2::new(f64::from(x), f64::from(y)) + 0.5);
        [(x * 7 % 256) as u8, (y * 5 % 256) as u8, ((x + y) * 3 % 256) as u8, level.round().clamp(0.0, 255.0) as u8]
    };
    (0..SIZE * SIZE).flat_map(pixel).collect()
}

/// The greatest difference of two pictures, in levels of premultiplied colours and of alpha.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    let premultiplied = |pixel: &[u8]| {
        let alpha = f64::from(pixel[3]);
        let colour = |channel: usize| f64::from(pixel[channel]) * alpha / 255.0;
        [colour(0), colour(1), colour(2), alpha]
    };
    let apart = |(a, b): (&[u8], &[u8])| {
        let (a, b) = (premultiplied(a), premultiplied(b));
        (0..4).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
    };
    a.chunks_exact(4).zip(b.chunks_exact(4)).map(apart).fold(0.0, f64::max)
}

/// The difference between a picture and its drawing with unmoved handles.
fn change(project: &Project, solution: &Solution, picture: &Picture<'_>) -> f64 {
    let pose = solution.pose(project).expect("a pose");
    let warped = solution.warped(picture, &pose, ResampleOptions::default()).expect("a picture");
    difference(picture.rgba(), &warped.rgba)
}

/// A project with unmoved handles on a cut-out.
fn at_rest(threshold: f64, loose_parts: LooseParts, handles: Vec<Handle>) -> Project {
    let mut project = Project::for_picture(SIZE, SIZE).with_handles(handles);
    project.domain = Some(DomainSpec::Alpha { threshold });
    project.loose_parts = loose_parts;
    project.samples = 2000;
    project
}

#[test]
fn unmoved_handles_change_no_cut_out() {
    let mut failures = Vec::new();
    for (number, (name, alpha)) in cut_outs().iter().enumerate() {
        let rgba = pixels(alpha);
        let picture = Picture::new(SIZE, SIZE, &rgba).expect("a picture");
        for threshold in [0.5, 0.05, 0.95] {
            let one = vec![Handle::point("a", [100.0, 100.0])];
            let turned = Handle::point("b", [100.0, 120.0]).turned(Rotation::Degrees(0.0));
            let several = vec![Handle::point("a", [88.0, 90.0]), turned, Handle::point("c", [110.0, 92.0])];
            for (loose_parts, handles) in [(LooseParts::Stay, one), (LooseParts::Follow, several)] {
                let project = at_rest(threshold, loose_parts, handles);
                let solution = solve(&project, &picture).expect(name);
                let changed = change(&project, &solution, &picture);
                if changed > MAX_DIFFERENCE {
                    failures.push(format!("{name} {number} at {threshold}, {loose_parts:?}: {changed} levels"));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
