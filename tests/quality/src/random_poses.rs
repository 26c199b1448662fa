//! The poses that are compared with the optimum: the standard ones, and six figures with handles at random.

use std::{f64::consts::TAU, path::Path};

use c2warp::project::{DomainSpec, Handle, ImageRef, Project, Rotation};
use c2warp_tests::Random;
use glam::DVec2;
use image::RgbaImage;

use crate::poses::{PosedScene, standard_poses, tiles};

/// The number of samples of the common mesh.
pub(crate) const MESH_SAMPLES: u32 = 3_000;
/// Minimum distance between handles at rest, as a fraction of the picture's longer side.
const APART: f64 = 0.17;
/// Minimum distance of handles from the outline, as the same fraction.
const INSIDE: f64 = 0.012;
/// Length of a bar, as the same fraction.
const BAR: f64 = 0.15;
/// The number of handles, and how far they move as the same fraction.
const DRAWS: [(usize, f64); 4] = [(5, 0.05), (6, 0.09), (7, 0.09), (6, 0.12)];
/// With a held boundary, handles move by this share of that.
const HELD: f64 = 0.5;
/// Side of a drawn picture in pixels.
const SIDE: f64 = 800.0;

/// Returns the poses that are compared with the optimum.
///
/// # Errors
/// If a sample picture of the editor cannot be read.
pub fn poses_beside_optimum() -> image::ImageResult<Vec<PosedScene>> {
    let mut poses = standard_poses()?;
    poses.extend(random_poses()?);
    for PosedScene { name, project, mesh_samples, .. } in &mut poses {
        name.insert_str(0, "optimum ");
        (project.samples, *mesh_samples) = (Project::for_picture(1, 1).samples, MESH_SAMPLES);
    }
    Ok(poses)
}

fn random_poses() -> image::ImageResult<Vec<PosedScene>> {
    let figures = [sample("salamander")?, sample("cat")?, sample("octopus")?, lattice(), face()?, bars()?];
    let mut random = Random(0);
    let mut poses = Vec::new();
    for Figure { name, project, picture, bars } in figures {
        for (number, (count, far)) in (1..).zip(DRAWS) {
            let mut project = project.clone();
            let far = if project.fix_boundary { HELD * far } else { far };
            project.handles = handles(&project, &picture, count, far, bars, &mut random);
            let (name, picture) = (format!("{name} {number}"), picture.clone());
            poses.push(PosedScene { name, project, mesh_samples: MESH_SAMPLES, picture });
        }
    }
    Ok(poses)
}

/// A picture, to which handles are added.
struct Figure {
    name: &'static str,
    project: Project,
    picture: RgbaImage,
    /// How many of its handles are bars.
    bars: usize,
}

fn of_picture(name: &str) -> image::ImageResult<(Project, RgbaImage)> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples").join(name).with_extension("png");
    let picture = image::open(file)?.into_rgba8();
    Ok((Project::new(ImageRef::new("drawn.png", picture.width(), picture.height())), picture))
}

fn sample(name: &'static str) -> image::ImageResult<Figure> {
    let (mut project, picture) = of_picture(name)?;
    project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
    Ok(Figure { name, project, picture, bars: 0 })
}

/// Beams of a tower, with four holes.
fn lattice() -> Figure {
    let at = |x: f64, y: f64| DVec2::new(x, y);
    let rings = vec![
        vec![at(250.0, 60.0), at(550.0, 60.0), at(650.0, 740.0), at(150.0, 740.0)],
        vec![at(315.0, 115.0), at(485.0, 115.0), at(505.0, 240.0), at(295.0, 240.0)],
        vec![at(285.0, 295.0), at(375.0, 295.0), at(375.0, 440.0), at(262.0, 440.0)],
        vec![at(425.0, 295.0), at(515.0, 295.0), at(538.0, 440.0), at(425.0, 440.0)],
        vec![at(255.0, 495.0), at(545.0, 495.0), at(575.0, 690.0), at(225.0, 690.0)],
    ];
    let mut project = Project::new(ImageRef::new("drawn.png", SIDE as u32, SIDE as u32));
    project.domain = Some(DomainSpec::polygon(rings));
    Figure { name: "lattice", project, picture: tiles(), bars: 0 }
}

/// A photograph with a lasso around the face.
fn face() -> image::ImageResult<Figure> {
    let (mut project, picture) = of_picture("portrait")?;
    let ring = (0..24).map(|k| {
        let turn = DVec2::from_angle(TAU * f64::from(k) / 24.0);
        DVec2::new(320.0, 310.0) + DVec2::new(250.0 * turn.x, 300.0 * turn.y)
    });
    project.domain = Some(DomainSpec::polygon(vec![ring.collect()]));
    Ok(Figure { name: "face", project, picture, bars: 0 })
}

/// The same picture with bars and a held boundary.
fn bars() -> image::ImageResult<Figure> {
    let (mut project, picture) = of_picture("portrait")?;
    project.domain = Some(DomainSpec::Image);
    project.fix_boundary = true;
    Ok(Figure { name: "bars", project, picture, bars: 2 })
}

/// Handles at random places, `far` from rest in a random direction. The first ones are bars.
fn handles(
    project: &Project,
    picture: &RgbaImage,
    count: usize,
    far: f64,
    bars: usize,
    random: &mut Random,
) -> Vec<Handle> {
    let (width, height) = (f64::from(picture.width()), f64::from(picture.height()));
    let size = width.max(height);
    let is_in = |p: DVec2| {
        (0..8).all(|k| {
            let p = p + INSIDE * size * DVec2::from_angle(TAU * f64::from(k) / 8.0);
            let on_picture = p.x >= 0.0 && p.y >= 0.0 && p.x < width && p.y < height;
            on_picture
                && match &project.domain {
                    Some(DomainSpec::Polygon { rings, .. }) => {
                        rings.iter().filter(|ring| contains(ring, p)).count() == 1
                    }
                    _ => picture.get_pixel(p.x as u32, p.y as u32).0[3] > 200,
                }
        })
    };
    let mut rest: Vec<[DVec2; 2]> = Vec::new();
    let mut apart = APART * size;
    while rest.len() < count {
        // Figures with little room get handles that are closer.
        apart *= 0.999;
        let a = DVec2::new(width * random.unit(), height * random.unit());
        let is_bar = rest.len() < bars;
        let b = if is_bar { a + BAR * size * DVec2::from_angle(TAU * random.unit()) } else { a };
        let points = [a, a.midpoint(b), b];
        let is_clear = |&p: &DVec2| is_in(p) && rest.iter().flatten().all(|other| other.distance(p) > apart);
        if points.iter().all(is_clear) {
            rest.push([a, b]);
        }
    }
    let handle = |(id, [a, b]): (usize, [DVec2; 2])| {
        let by = far * size * DVec2::from_angle(TAU * random.unit());
        if id < bars {
            let turn = DVec2::from_angle(far * TAU * (random.unit() - 0.5));
            let middle = a.midpoint(b);
            let posed = [a, b].map(|p| middle + by + turn.rotate(p - middle));
            Handle::bar(format!("h{id}"), [a, b]).posed_at(posed)
        } else {
            Handle::point(format!("h{id}"), a).posed_at([a + by]).turned(Rotation::Auto)
        }
    };
    rest.into_iter().enumerate().map(handle).collect()
}

/// Whether a point is inside a ring.
fn contains(ring: &[DVec2], p: DVec2) -> bool {
    let is_right =
        |(a, b): &(&DVec2, &DVec2)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    ring.iter().zip(ring.iter().cycle().skip(1)).filter(is_right).count() % 2 == 1
}
