//! Pictures with any alpha.

use arbitrary::{Result, Unstructured};
use c2warp::glam::DVec2;
use c2warp::project::{DomainSpec, Handle, Project};
use c2warp::{Picture, ResampleOptions, solve};

use crate::promises::{accepted, check};

const MOST_SIDE: u32 = 48;

/// Solves a picture with any alpha and up to three handles, and draws it.
///
/// # Panics
/// If a promise is broken.
pub fn attack(bytes: &[u8]) {
    if let Ok(scene) = Scene::new(&mut Unstructured::new(bytes)) {
        scene.run();
    }
}

struct Scene {
    project: Project,
    rgba: Vec<u8>,
}

impl Scene {
    fn new(u: &mut Unstructured<'_>) -> Result<Self> {
        let (width, height) = (u.int_in_range(1..=MOST_SIDE)?, u.int_in_range(1..=MOST_SIDE)?);
        let mut project = Project::for_picture(width, height);
        project.samples = u.int_in_range(100..=300)?;
        project.fix_boundary = u.ratio(1, 4)?;
        let threshold = f64::from(u.arbitrary::<u8>()?) / 255.0;
        project.domain = (!u.ratio(1, 4)?).then_some(DomainSpec::Alpha { threshold });
        for id in 0..u.int_in_range(0..=3_u8)? {
            let rest = DVec2::new(u.int_in_range(0..=width)?.into(), u.int_in_range(0..=height)?.into());
            let rest = if u.arbitrary()? { rest + 0.5 } else { rest };
            project.handles.push(Handle::point(id.to_string(), rest).posed_at([rest + 3.0]).turned(30.0));
        }
        // Blocks of a few pixels. A file that ends early repeats its alpha.
        let (grain, is_hard) = (u.int_in_range(1..=8_u32)?, u.arbitrary()?);
        let blocks = u.peek_bytes(u.len()).filter(|bytes| !bytes.is_empty()).unwrap_or(&[255]);
        let columns = width.div_ceil(grain);
        let alpha = |x: u32, y: u32| {
            let block = (y / grain * columns + x / grain) as usize;
            if is_hard {
                let bit = blocks[block / 8 % blocks.len()] >> (block % 8) & 1;
                bit * 255
            } else {
                blocks[block % blocks.len()]
            }
        };
        let rgba = (0..height).flat_map(|y| (0..width).flat_map(move |x| [x as u8, y as u8, 90, 255]));
        let mut rgba: Vec<u8> = rgba.collect();
        for (index, pixel) in rgba.chunks_exact_mut(4).enumerate() {
            pixel[3] = alpha(index as u32 % width, index as u32 / width);
        }
        Ok(Self { project, rgba })
    }

    fn run(&self) {
        let Self { project, rgba } = self;
        let Some(picture) = accepted(Picture::new(project.image.width, project.image.height, rgba)) else { return };
        let Some(solution) = accepted(solve(project, &picture)) else { return };
        check(&solution, project);
        let Some(pose) = accepted(solution.pose(project)) else { return };
        if let Some(warped) = accepted(solution.warped(&picture, &pose, ResampleOptions::default())) {
            assert_eq!(warped.rgba.len(), warped.width as usize * warped.height as usize * 4);
        }
    }
}
