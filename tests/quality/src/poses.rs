//! The standard poses.

use std::path::Path;

use c2warp::{
    Picture,
    project::{DomainSpec, Handle, ImageRef, Project, Rotation},
};
use c2warp_tests::Scene;
use glam::DVec2;
use image::{Rgba, RgbaImage};

/// The number of samples of the common mesh of a standard pose.
pub const SAMPLES: u32 = 8_000;
/// Side of the generated pictures in pixels.
const SIZE: u32 = 800;

/// A picture with posed handles.
#[derive(Debug, Clone)]
pub struct PosedScene {
    /// A short name, also used for the file of the sheet.
    pub name: String,
    /// The project. Each method uses its own settings.
    pub project: Project,
    /// The number of samples of the mesh on which methods are compared.
    pub mesh_samples: u32,
    /// The picture.
    pub picture: RgbaImage,
}

impl PosedScene {
    /// Returns the picture for the solver.
    ///
    /// # Panics
    /// If the picture is too small or too large. None is.
    #[must_use]
    pub fn solver_picture(&self) -> Picture<'_> {
        let (width, height) = self.picture.dimensions();
        Picture::new(width, height, self.picture.as_raw()).expect("a picture of fair size")
    }

    fn on_rings(name: &str, rings: Vec<Vec<DVec2>>, moves: &[(DVec2, DVec2)]) -> Self {
        let image = ImageRef::new("drawn.png", SIZE, SIZE);
        let mut project = Project::new(image);
        project.domain = Some(DomainSpec::polygon(rings));
        project.handles = handles(moves);
        Self::new(name, project, tiles())
    }

    fn new(name: &str, mut project: Project, picture: RgbaImage) -> Self {
        project.samples = SAMPLES;
        Self { name: name.to_owned(), project, mesh_samples: SAMPLES, picture }
    }
}

/// Returns all standard poses.
///
/// # Errors
/// If the sample picture of the editor cannot be read.
pub fn standard_poses() -> image::ImageResult<Vec<PosedScene>> {
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples/gingerbread.png");
    let gingerbread = image::open(sample)?.into_rgba8();
    Ok(vec![
        strip(),
        waving(gingerbread.clone()),
        bowing(gingerbread),
        cross(),
        pulled(),
        of_scene("6 portrait", "portrait"),
        of_scene("7 tower", "tower"),
        spiral(),
    ])
}

/// Returns point handles whose rotations are left to the solver.
fn handles(moves: &[(DVec2, DVec2)]) -> Vec<Handle> {
    let handle = |(id, &(rest, posed)): (usize, &(DVec2, DVec2))| {
        Handle::point(format!("h{id}"), rest).posed_at([posed]).turned(Rotation::Auto)
    };
    moves.iter().enumerate().map(handle).collect()
}

/// A strip of 640 by 160 px that three pins bend.
fn strip() -> PosedScene {
    let ring = [(80.0, 320.0), (720.0, 320.0), (720.0, 480.0), (80.0, 480.0)].map(DVec2::from).to_vec();
    let moves = [((120.0, 400.0), (180.0, 500.0)), ((400.0, 400.0), (400.0, 300.0)), ((680.0, 400.0), (620.0, 500.0))];
    PosedScene::on_rings("1 strip", vec![ring], &moves.map(|(rest, posed)| (rest.into(), posed.into())))
}

/// The handles of the editor's sample: head, hands, feet.
const GINGERBREAD: [(f64, f64); 5] = [(512.0, 260.0), (124.0, 516.0), (900.0, 516.0), (312.0, 1126.0), (712.0, 1126.0)];

fn gingerbread(name: &str, picture: RgbaImage, posed: [DVec2; 5]) -> PosedScene {
    let image = ImageRef::new("gingerbread.png", picture.width(), picture.height());
    let mut project = Project::new(image);
    project.domain = Some(DomainSpec::Alpha { threshold: 0.5 });
    let rest = GINGERBREAD.map(DVec2::from);
    project.handles = handles(&std::array::from_fn::<_, 5, _>(|i| (rest[i], posed[i])));
    PosedScene::new(name, project, picture)
}

/// The gingerbread figure with a hand above its head.
fn waving(picture: RgbaImage) -> PosedScene {
    let mut posed = GINGERBREAD.map(DVec2::from);
    posed[1] = DVec2::new(190.0, 250.0);
    gingerbread("2 waving", picture, posed)
}

/// The gingerbread figure with head and hands rotated about its hips by 35°.
fn bowing(picture: RgbaImage) -> PosedScene {
    let hips = DVec2::new(512.0, 850.0);
    let turn = |p: (f64, f64)| hips + DVec2::from_angle(35.0_f64.to_radians()).rotate(DVec2::from(p) - hips);
    let [head, left, right, ..] = GINGERBREAD;
    let [.., left_foot, right_foot] = GINGERBREAD;
    let posed = [turn(head), turn(left), turn(right), left_foot.into(), right_foot.into()];
    gingerbread("3 bowing", picture, posed)
}

/// A cross with fixed ends, whose middle is rotated by 90° with four handles.
fn cross() -> PosedScene {
    let middle = DVec2::splat(f64::from(SIZE) / 2.0);
    let arm = [(-80.0, -80.0), (-80.0, -320.0), (80.0, -320.0)].map(DVec2::from);
    let quarter = |k: usize| DVec2::from_angle(std::f64::consts::FRAC_PI_2 * k as f64);
    let ring = (0..4).flat_map(|k| arm.map(|p| middle + quarter(k).rotate(p).round())).collect();
    let position = |k: usize, far: f64| middle + quarter(k).rotate(DVec2::new(0.0, -far)).round();
    let ends = (0..4).map(|k| (position(k, 290.0), position(k, 290.0)));
    let turned = (0..4).map(|k| (position(k, 60.0), position(k + 1, 60.0)));
    PosedScene::on_rings("4 cross", vec![ring], &ends.chain(turned).collect::<Vec<_>>())
}

/// A square with two handles that are pulled from 40 to 100 px apart.
fn pulled() -> PosedScene {
    let ring = [(100.0, 100.0), (700.0, 100.0), (700.0, 700.0), (100.0, 700.0)].map(DVec2::from).to_vec();
    let moves = [((380.0, 400.0), (350.0, 400.0)), ((420.0, 400.0), (450.0, 400.0))];
    PosedScene::on_rings("5 pulled", vec![ring], &moves.map(|(rest, posed)| (rest.into(), posed.into())))
}

/// A scene of `tests/scenes`, enlarged four times.
fn of_scene(name: &str, scene: &str) -> PosedScene {
    let Scene { project, picture } = Scene::enlarged(scene, 4);
    PosedScene::new(name, project, picture)
}

/// A spiral of one and a quarter turns, whose seven handles are moved to a straight line.
fn spiral() -> PosedScene {
    const HALF_WIDTH: f64 = 36.0;
    let centre = DVec2::splat(f64::from(SIZE) / 2.0);
    let iterations = 1.25 * std::f64::consts::TAU;
    let radius = |angle: f64| 120.0 + 19.0 * angle;
    let at = |angle: f64, offset: f64| centre + (radius(angle) + offset) * DVec2::from_angle(angle);
    let angles = |count: usize| (0..=count).map(move |i| iterations * i as f64 / count as f64);
    let outer = angles(90).map(|angle| at(angle, HALF_WIDTH));
    let inner = angles(90).map(|angle| at(angle, -HALF_WIDTH)).collect::<Vec<_>>().into_iter().rev();
    // The handles are slightly inside both ends. The line continues from the outer end and is as long as the spiral.
    let rest: Vec<DVec2> = (0..7).map(|i| at(iterations * (0.02 + 0.96 * f64::from(i) / 6.0), 0.0)).collect();
    let length = |from: f64, to: f64| {
        let steps = 1000;
        let point = |i: i32| at(from + (to - from) * f64::from(i) / f64::from(steps), 0.0);
        (0..steps).map(|i| point(i).distance(point(i + 1))).sum::<f64>()
    };
    let outer_end = iterations * 0.98;
    let tangent = (at(outer_end, 0.0) - at(outer_end - 1e-3, 0.0)).normalize();
    let moves: Vec<_> = rest
        .iter()
        .enumerate()
        .map(|(i, &p)| (p, rest[6] - tangent * length(iterations * (0.02 + 0.96 * i as f64 / 6.0), outer_end)))
        .collect();
    PosedScene::on_rings("8 spiral", vec![outer.chain(inner).collect()], &moves)
}

/// Tiles in a gradient from corner to corner.
pub(crate) fn tiles() -> RgbaImage {
    RgbaImage::from_fn(SIZE, SIZE, |x, y| {
        let (across, down) = (f64::from(x) / f64::from(SIZE), f64::from(y) / f64::from(SIZE));
        let shade = if (x / 20 + y / 20) % 2 == 0 { 0.8 } else { 1.0 };
        let byte = |value: f64| (shade * value) as u8;
        Rgba([byte(90.0 + 150.0 * across), byte(150.0 + 60.0 * down - 50.0 * across), byte(220.0 - 150.0 * down), 255])
    })
}
