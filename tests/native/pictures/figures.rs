//! Pictures that resemble the figures of the paper.

use glam::DVec2;

use super::paint::{CLEAR, Colour, between, disc, ellipse, limb, line, rgb};

/// A figure with arms and legs on a transparent background.
pub(super) fn gingerbread(p: DVec2) -> Colour {
    let outside = [
        limb(p, (90.0, 42.0), 30.0, (90.0, 43.0), 30.0),
        limb(p, (90.0, 80.0), 26.0, (90.0, 128.0), 32.0),
        limb(p, (82.0, 86.0), 17.0, (24.0, 96.0), 15.0),
        limb(p, (98.0, 86.0), 17.0, (156.0, 96.0), 15.0),
        limb(p, (80.0, 140.0), 20.0, (58.0, 196.0), 18.0),
        limb(p, (100.0, 140.0), 20.0, (122.0, 196.0), 18.0),
    ];
    let outside = outside.into_iter().fold(f64::INFINITY, f64::min);
    let buttons = [(90.0, 84.0), (90.0, 104.0), (90.0, 124.0)];
    let icing = rgb(250, 240, 220);
    match () {
        () if outside > 0.0 => CLEAR,
        () if disc(p, (79.0, 38.0), 4.0) || disc(p, (101.0, 38.0), 4.0) => rgb(60, 30, 20),
        () if (p.distance((90.0, 46.0).into()) - 11.0).abs() < 1.5 && p.y > 49.0 => icing,
        () if disc(p, buttons[0], 5.0) => rgb(200, 40, 60),
        () if disc(p, buttons[1], 5.0) => rgb(50, 120, 200),
        () if disc(p, buttons[2], 5.0) => rgb(60, 150, 70),
        () if (-7.0..-5.0).contains(&outside) => icing,
        () => between(rgb(196, 128, 66), rgb(150, 88, 40), (p.x + p.y) / 400.0),
    }
}

/// A round tower under a sky.
pub(super) fn tower(p: DVec2) -> Colour {
    let half = 24.0 + (p.y - 70.0) / 16.0;
    let off = (p.x - 100.0).abs();
    let wall = off <= half && (70.0..=226.0).contains(&p.y);
    let crown = off <= 34.0 && (56.0..=74.0).contains(&p.y);
    let teeth = off <= 34.0 && (44.0..=56.0).contains(&p.y) && ((p.x - 66.0) / 68.0 * 7.0) as i32 % 2 == 0;
    let windows = [(100.0, 100.0), (92.0, 142.0), (108.0, 184.0)];
    let course = ((p.y - 70.0) / 13.0).floor();
    let mortar = (p.y - 70.0) % 13.0 < 1.4 || (p.x + 8.0 * (course % 2.0)).rem_euclid(16.0) < 1.4;
    match () {
        () if windows.iter().any(|&at| limb(p, at, 4.0, (at.0, at.1 + 10.0), 4.0) <= 0.0) => rgb(40, 40, 60),
        () if wall || crown || teeth => {
            let light = between(rgb(214, 196, 168), rgb(132, 112, 96), (p.x - 66.0) / 68.0);
            if mortar { between(light, rgb(80, 70, 64), 0.5) } else { light }
        }
        () if disc(p, (38.0, 44.0), 17.0) => rgb(250, 210, 90),
        () if p.y > 214.0 + 6.0 * (p.x / 30.0).sin() => {
            between(rgb(110, 160, 80), rgb(60, 110, 60), (p.y - 210.0) / 50.0)
        }
        () => between(rgb(96, 150, 210), rgb(214, 230, 240), p.y / 220.0),
    }
}

/// A head and shoulders.
pub(super) fn portrait(p: DVec2) -> Colour {
    let skin = between(rgb(240, 202, 170), rgb(206, 156, 124), (p.x - 50.0) / 110.0);
    let eye = |x: f64| ellipse(p, (x, 118.0), (12.0, 7.0));
    let iris = |x: f64| disc(p, (x, 118.0), 5.5) && eye(x);
    match () {
        () if iris(78.0) || iris(122.0) => rgb(50, 80, 110),
        () if eye(78.0) || eye(122.0) => rgb(250, 248, 244),
        () if line(p, (64.0, 104.0), (90.0, 102.0), 4.0) || line(p, (110.0, 102.0), (136.0, 104.0), 4.0) => {
            rgb(80, 50, 36)
        }
        () if line(p, (101.0, 118.0), (96.0, 142.0), 2.0) || line(p, (96.0, 142.0), (104.0, 144.0), 2.0) => {
            rgb(170, 110, 90)
        }
        () if ellipse(p, (100.0, 165.0), (21.0, 6.0)) => rgb(190, 70, 76),
        () if ellipse(p, (100.0, 128.0), (46.0, 62.0)) && p.y > 84.0 + (p.x - 100.0).abs() / 4.0 => skin,
        () if ellipse(p, (100.0, 112.0), (58.0, 66.0)) => {
            between(rgb(96, 56, 34), rgb(60, 34, 24), (p.x - 60.0) / 80.0)
        }
        () if (p.x - 100.0).abs() < 18.0 && (180.0..212.0).contains(&p.y) => between(skin, rgb(120, 80, 60), 0.3),
        () if ellipse(p, (100.0, 262.0), (84.0, 60.0)) => {
            if ((p.x + p.y) / 9.0) as i32 % 2 == 0 {
                rgb(52, 92, 128)
            } else {
                rgb(70, 116, 152)
            }
        }
        () => {
            let wall = between(rgb(214, 206, 190), rgb(176, 186, 180), p.x / 200.0);
            if p.x.rem_euclid(25.0) < 1.5 { between(wall, rgb(120, 120, 110), 0.5) } else { wall }
        }
    }
}

/// A symmetric moth on a transparent background.
pub(super) fn moth(p: DVec2) -> Colour {
    let q = DVec2::new((p.x - 110.0).abs(), p.y);
    let wing = limb(q, (10.0, 80.0), 26.0, (74.0, 46.0), 30.0).min(limb(q, (8.0, 96.0), 22.0, (56.0, 136.0), 24.0));
    let body = limb(q, (0.0, 50.0), 11.0, (0.0, 140.0), 7.0);
    match () {
        () if body <= 0.0 => {
            if (p.y / 7.0) as i32 % 2 == 0 {
                rgb(70, 52, 40)
            } else {
                rgb(110, 84, 60)
            }
        }
        () if wing > 0.0 => CLEAR,
        () if disc(q, (72.0, 46.0), 8.0) => rgb(30, 30, 50),
        () if disc(q, (72.0, 46.0), 13.0) || disc(q, (56.0, 134.0), 9.0) => rgb(236, 200, 110),
        () if wing > -4.0 => rgb(90, 60, 80),
        () => between(rgb(210, 130, 90), rgb(150, 90, 140), (q.x + q.y) / 220.0),
    }
}

/// A road into the distance.
pub(super) fn road(p: DVec2) -> Colour {
    let depth = (p.y - 70.0) / 110.0;
    let (middle, half) = (130.0 + 18.0 * (1.0 - depth), 6.0 + 78.0 * depth);
    let off = (p.x - middle) / half;
    match () {
        () if line(p, (28.0, 84.0), (28.0, 108.0), 5.0) => rgb(90, 60, 40),
        () if disc(p, (28.0, 74.0), 17.0) => rgb(40, 100, 60),
        () if p.y < 70.0 && disc(p, (206.0, 30.0), 13.0) => rgb(252, 220, 120),
        () if p.y < 56.0 + 14.0 * (p.x / 40.0).cos() => between(rgb(120, 170, 220), rgb(220, 232, 240), p.y / 70.0),
        () if p.y < 70.0 => between(rgb(96, 130, 110), rgb(130, 150, 130), p.x / 260.0),
        () if off.abs() < 0.04 && (30.0 / (depth + 0.12)) as i32 % 2 == 0 => rgb(240, 236, 210),
        () if (0.88..0.94).contains(&off.abs()) => rgb(240, 236, 210),
        () if off.abs() < 1.0 => between(rgb(130, 130, 136), rgb(84, 84, 92), depth),
        () => between(rgb(160, 180, 100), rgb(90, 130, 60), depth),
    }
}

/// Tiles in a gradient from one corner to the other.
pub(super) fn tiles(p: DVec2) -> Colour {
    let colour = between(rgb(70, 110, 180), rgb(220, 120, 70), (p.x / 160.0 + p.y / 120.0) / 2.0);
    let dark = ((p.x / 10.0) as i32 + (p.y / 10.0) as i32) % 2 == 0;
    if dark { between(colour, rgb(20, 20, 30), 0.35) } else { colour }
}
