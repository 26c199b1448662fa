//! Fills of pictures whose truth is known: things are pasted in, taken out again by a lasso, and the fill is compared
//! with the truth.
//!
//! Beside it stand two classic methods: harmonic diffusion, and the fast marching method of Telea (2004). They continue
//! smoothly, so their colours are close to the original on average, but texture ends at the rim. Photographs are
//! compared with the two methods of OpenCV, and drawn on blind sheets too.

mod blind;
mod harmonic;
mod measure;
mod opencv;
mod telea;

use std::{error::Error, path::Path, time::Instant};

use c2warp::{Picture, domain::Domain, fill::fill, project::FillSpec};
use c2warp_tests::Scene;
use glam::DVec2;
use image::{Rgba, RgbaImage, imageops};

use self::measure::Measured;
use crate::sheet::{LABEL, write};

/// Pictures that tests draw, opaque throughout.
const DRAWN: [&str; 2] = ["road", "tower"];
/// Samples of the editor.
const SAMPLES: [&str; 1] = ["portrait"];
/// Radius of a pasted thing as a fraction of the picture's shorter side, and its places as fractions of both sides.
const RADIUS: f64 = 0.11;
const PLACES: [[f64; 2]; 4] = [[0.2, 0.25], [0.75, 0.3], [0.3, 0.75], [0.7, 0.72]];
/// The rim of a thing waves by this fraction of its radius, so many times around.
const WAVES: (f64, f64) = (0.25, 5.0);
const CORNERS: u32 = 60;
/// Half the side of a hole on a blind sheet, in radii of the hole.
const SHOWN: f64 = 2.0;

/// The source of the other two methods.
#[derive(Debug, Clone, Copy)]
pub enum Others<'a> {
    /// Harmonic diffusion, and Telea's method without its gradients.
    Own,
    /// Telea's method and that of Navier and Stokes, by a Python with OpenCV.
    OpenCv {
        /// The program that runs scripts.
        python: &'a Path,
        /// Where pictures for it are written.
        folder: &'a Path,
    },
}

impl Others<'_> {
    const fn methods(self) -> [&'static str; 3] {
        match self {
            Self::Own => ["patches", "harmonic", "Telea"],
            Self::OpenCv { .. } => ["patches", "Telea", "Navier-Stokes"],
        }
    }

    /// The results of both methods.
    fn filled(self, name: &str, truth: &RgbaImage, hole: &[bool]) -> Result<[RgbaImage; 2], Box<dyn Error>> {
        match self {
            Self::Own => Ok([harmonic::filled(truth, hole), telea::filled(truth, hole)]),
            Self::OpenCv { python, folder } => opencv::filled(python, folder, name, truth, hole),
        }
    }
}

/// One picture without its pasted things, by each method.
#[derive(Debug)]
pub struct Filled {
    /// The picture.
    pub name: String,
    /// Time of the fill by patches, in milliseconds.
    pub ms: f64,
    /// The methods.
    pub methods: [&'static str; 3],
    /// In the order of the methods.
    pub measured: Vec<Measured>,
    pasted: RgbaImage,
    results: Vec<RgbaImage>,
}

/// Fills the pictures of the project.
///
/// # Errors
/// If a picture cannot be read or filled.
pub fn fills() -> Result<Vec<Filled>, Box<dyn Error>> {
    let mut all = Vec::new();
    for name in DRAWN {
        all.push(Filled::new(name, &Scene::named(name).picture, Others::Own)?);
    }
    for name in SAMPLES {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/public/samples");
        all.push(Filled::new(name, &image::open(root.join(name).with_extension("png"))?.into_rgba8(), Others::Own)?);
    }
    Ok(all)
}

/// Fills pictures in files.
///
/// # Errors
/// If a picture cannot be read or filled.
pub fn fills_of(files: &[&str], others: Others<'_>) -> Result<Vec<Filled>, Box<dyn Error>> {
    let filled = |file: &&str| {
        let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy();
        Filled::new(&name, &image::open(file)?.into_rgba8(), others)
    };
    files.iter().map(filled).collect()
}

impl Filled {
    fn new(name: &str, truth: &RgbaImage, others: Others<'_>) -> Result<Self, Box<dyn Error>> {
        eprintln!("  fill: {name}");
        let (width, height) = truth.dimensions();
        let size = DVec2::new(width.into(), height.into());
        let rings: Vec<_> =
            PLACES.iter().map(|place| ring(DVec2::from(*place) * size, RADIUS * size.min_element())).collect();
        let mut pasted = truth.clone();
        let (mut result, mut hole) = (truth.clone(), vec![false; (width * height) as usize]);
        let mut ms = 0.0;
        for ring in &rings {
            let domain = Domain::from_rings(std::slice::from_ref(ring))?;
            paste(&mut pasted, ring);
            let mut without = truth.clone();
            paste(&mut without, ring);
            let start = Instant::now();
            let fill = fill(&Picture::new(width, height, &without)?, &domain, &FillSpec::default())?;
            ms += start.elapsed().as_secs_f64() * 1e3;
            let [left, top] = fill.origin();
            for (at, (pixel, before)) in (0..).zip(fill.rgba().as_chunks::<4>().0.iter().zip(box_of(&without, &fill))) {
                let (x, y) = (left + at % fill.width(), top + at / fill.width());
                if *pixel != before || is_pasted(before) {
                    hole[(y * width + x) as usize] = true;
                    result.put_pixel(x, y, Rgba(*pixel));
                }
            }
        }
        let [first, second] = others.filled(name, truth, &hole)?;
        let results = vec![result, first, second];
        let measured = results.iter().map(|result| Measured::new(truth, result, &hole)).collect();
        Ok(Self {
            name: name.to_owned(),
            ms: ms / PLACES.len() as f64,
            methods: others.methods(),
            measured,
            pasted,
            results,
        })
    }

    /// The picture with the pasted things, and the results side by side.
    #[must_use]
    pub fn sheet(&self) -> RgbaImage {
        let (width, height) = self.pasted.dimensions();
        let mut sheet = RgbaImage::from_pixel(4 * width, height + LABEL, Rgba([255; 4]));
        let named = std::iter::once(("pasted", &self.pasted)).chain(self.methods.into_iter().zip(&self.results));
        for (column, (name, picture)) in (0..).zip(named) {
            write(&mut sheet, name, column * width, LABEL - 6);
            imageops::replace(&mut sheet, picture, i64::from(column * width), i64::from(LABEL));
        }
        sheet
    }
}

/// The middle of each hole, and half the side of a square around it.
fn holes(width: u32, height: u32) -> impl Iterator<Item = (DVec2, f64)> {
    let size = DVec2::new(width.into(), height.into());
    PLACES.into_iter().map(move |place| (DVec2::from(place) * size, SHOWN * RADIUS * size.min_element()))
}

/// A wavy ring.
fn ring(centre: DVec2, radius: f64) -> Vec<DVec2> {
    let corner = |k: u32| {
        let turn = std::f64::consts::TAU * f64::from(k) / f64::from(CORNERS);
        centre + DVec2::from_angle(turn) * radius * (1.0 + WAVES.0 * (WAVES.1 * turn).sin())
    };
    (0..CORNERS).map(corner).collect()
}

const PASTED: [u8; 4] = [255, 0, 255, 255];

fn is_pasted(pixel: [u8; 4]) -> bool {
    pixel == PASTED
}

/// Pastes a thing of one colour.
fn paste(picture: &mut RgbaImage, ring: &[DVec2]) {
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        let p = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let edges = ring.iter().zip(ring.iter().cycle().skip(1));
        let crossings =
            edges.filter(|(a, b)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x));
        if crossings.count() % 2 == 1 {
            *pixel = Rgba(PASTED);
        }
    }
}

/// The pixels of a picture in the box of a fill.
fn box_of<'a>(picture: &'a RgbaImage, fill: &c2warp::fill::Fill) -> impl Iterator<Item = [u8; 4]> + 'a {
    let ([left, top], width, height) = (fill.origin(), fill.width(), fill.height());
    let places = (top..top + height).flat_map(move |y| (left..left + width).map(move |x| (x, y)));
    places.map(|(x, y)| picture.get_pixel(x, y).0)
}
