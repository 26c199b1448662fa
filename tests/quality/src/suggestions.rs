//! Suggested handles on pictures of figures, of photographs and of tests, to be judged by eye.

use std::{error::Error, path::Path, time::Instant};

use c2warp::{
    Picture,
    domain::Domain,
    project::{DomainSpec, Project},
    suggest::{SuggestedHandle, SuggestedRole, suggest},
};
use c2warp_tests::Scene;
use glam::DVec2;
use image::{Rgba, RgbaImage, imageops};

use crate::sheet::{LABEL, dot, fill, write};

/// Samples of the editor that bend where they are opaque.
const FIGURES: [&str; 8] = ["cactus", "cat", "gingerbread", "giraffe", "octopus", "robot", "salamander", "snake"];
/// Pictures that tests draw.
const DRAWN: [&str; 3] = ["moth", "tower", "islands"];
/// The longer side of a sheet's picture in pixels.
const SIDE: f64 = 760.0;
/// Width of the list of names in pixels.
const NAMES: u32 = 300;

/// The suggested handles of a picture.
#[derive(Debug)]
pub struct Suggested {
    /// The picture, and what bends of it.
    pub name: String,
    /// The handles, from top to bottom.
    pub handles: Vec<SuggestedHandle>,
    /// Time for the handles without that for the outline, in milliseconds.
    pub ms: f64,
    picture: RgbaImage,
    domain: Domain,
}

/// Suggests handles for all pictures.
///
/// # Errors
/// If a sample of the editor cannot be read, or has no domain.
pub fn suggestions() -> Result<Vec<Suggested>, Box<dyn Error>> {
    let mut all = Vec::new();
    for name in FIGURES {
        all.push(Suggested::new(name, sample(name)?, None)?);
    }
    for name in DRAWN {
        let Scene { project, picture } = Scene::named(name);
        all.push(Suggested::new(name, picture, project.domain.as_ref())?);
    }
    let photograph = sample("portrait")?;
    let text = std::fs::read_to_string(file("portrait", "c2warp.json"))?;
    let lasso = Project::from_json(&text)?.domain;
    all.push(Suggested::new("photograph with a lasso", photograph.clone(), lasso.as_ref())?);
    all.push(Suggested::new("photograph", photograph, Some(&DomainSpec::Image))?);
    Ok(all)
}

fn file(name: &str, ending: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples").join(format!("{name}.{ending}"))
}

fn sample(name: &str) -> image::ImageResult<RgbaImage> {
    Ok(image::open(file(name, "png"))?.into_rgba8())
}

impl Suggested {
    fn new(name: &str, picture: RgbaImage, domain: Option<&DomainSpec>) -> Result<Self, c2warp::Error> {
        let (width, height) = picture.dimensions();
        let domain = Domain::new(domain, &Picture::new(width, height, picture.as_raw())?)?;
        let start = Instant::now();
        let handles = suggest(&domain, None);
        let ms = start.elapsed().as_secs_f64() * 1e3;
        Ok(Self { name: name.to_owned(), handles, ms, picture, domain })
    }

    /// The number of handles of a role.
    #[must_use]
    pub fn count(&self, role: SuggestedRole) -> usize {
        self.handles.iter().filter(|handle| handle.role == role).count()
    }

    /// The smallest distance between handles of limbs and trunks, in widths of limbs. The width is that of the largest
    /// circles in the outline around two handles. Infinite for fewer than two handles.
    #[must_use]
    pub fn least_widths(&self) -> f64 {
        let edges = || self.domain.rings().iter().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)));
        let radius = |p: DVec2| {
            let distance = |(a, b): (&DVec2, &DVec2)| {
                p.distance(a.lerp(*b, ((p - a).dot(b - a) / a.distance_squared(*b)).clamp(0.0, 1.0)))
            };
            edges().map(distance).fold(f64::INFINITY, f64::min)
        };
        let on_limbs = self.handles.iter().filter(|handle| handle.role != SuggestedRole::Spread);
        let circles: Vec<(DVec2, f64)> = on_limbs.map(|handle| (handle.rest, radius(handle.rest))).collect();
        let pairs =
            circles.iter().enumerate().flat_map(|(at, one)| circles[..at].iter().map(move |other| (one, other)));
        pairs.map(|(one, other)| one.0.distance(other.0) / (one.1 + other.1)).fold(f64::INFINITY, f64::min)
    }

    /// The picture with its outline and numbered handles, beside their names.
    #[must_use]
    pub fn sheet(&self) -> RgbaImage {
        let (width, height) = self.picture.dimensions();
        let scale = SIDE / f64::from(width.max(height));
        let [width, height] = [width, height].map(|side| (f64::from(side) * scale).round() as u32);
        let rows = self.handles.len() as u32 * LABEL + LABEL;
        let mut sheet = RgbaImage::from_pixel(width + NAMES, height.max(rows), Rgba([236, 236, 232, 255]));
        imageops::overlay(&mut sheet, &imageops::resize(&self.picture, width, height, imageops::Triangle), 0, 0);
        for ring in self.domain.rings() {
            for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                line(&mut sheet, a * scale, b * scale);
            }
        }
        for (k, handle) in self.handles.iter().enumerate() {
            let (at, colour) = (handle.rest * scale, colour(handle.role));
            dot(&mut sheet, at, 12.0, Rgba([0, 0, 0, 255]));
            dot(&mut sheet, at, 10.5, colour);
            let number = (k + 1).to_string();
            write(&mut sheet, &number, (at.x - 5.0 * number.len() as f64).max(0.0) as u32, at.y as u32 + 6);
            let row = k as u32 * LABEL + LABEL;
            dot(&mut sheet, DVec2::new(f64::from(width) + 14.0, f64::from(row) - 6.0), 6.0, colour);
            write(&mut sheet, &format!("{number} {}", handle.id), width + 26, row);
        }
        sheet
    }
}

fn colour(role: SuggestedRole) -> Rgba<u8> {
    match role {
        SuggestedRole::Middle => Rgba([255, 120, 120, 255]),
        SuggestedRole::End => Rgba([255, 210, 60, 255]),
        SuggestedRole::Joint => Rgba([120, 220, 120, 255]),
        _ => Rgba([140, 190, 255, 255]),
    }
}

/// Draws a line of two pixels' width.
fn line(sheet: &mut RgbaImage, a: DVec2, b: DVec2) {
    let across = (b - a).perp().normalize_or_zero();
    for corners in [[a - across, b - across, b + across], [a - across, b + across, a + across]] {
        fill(sheet, corners, Rgba([220, 30, 160, 255]));
    }
}
