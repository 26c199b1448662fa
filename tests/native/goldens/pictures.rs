//! Golden tests of the warped pictures.
//!
//! After an intended change, `RENEW_GOLDENS=1 cargo test -p c2warp-tests --test goldens` writes the goldens again.
//! Inspect each one before you commit it.

use std::{fs, path::PathBuf};

use c2warp::{ResampleOptions, project::Shape, raster, solve};
use c2warp_tests::Scene;
use glam::DVec2;
use image::RgbaImage;

use crate::comparison::Comparison;

/// The scenes that have a golden.
const SCENES: [&str; 7] = ["gingerbread", "brushed", "tower", "portrait", "moth", "road", "fold"];

fn folder(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Warps a scene as `c2warp warp` does.
fn warped(scene: &Scene) -> RgbaImage {
    let picture = scene.solver_picture();
    let solution = solve(&scene.project, &picture).expect("a valid scene");
    let pose = solution
        .poser()
        .pose(&scene.project.handles, scene.project.pose.blend)
        .expect("as many handles as were solved");
    let (rest, posed) = (solution.vertices(), solution.posed_vertices(&pose));
    let warped =
        raster::warp(&picture, rest, &posed, solution.triangles(), ResampleOptions::default()).expect("a fair size");
    RgbaImage::from_raw(warped.width, warped.height, warped.rgba).expect("as many bytes as pixels")
}

#[test]
fn warped_scenes_match_their_goldens() {
    let mut different = Vec::new();
    for name in SCENES {
        let actual = warped(&Scene::named(name));
        let golden = folder("golden").join(name).with_extension("png");
        if std::env::var_os("RENEW_GOLDENS").is_some() {
            fs::create_dir_all(folder("golden")).expect("the folder can be made");
            actual.save(&golden).expect("the golden can be written");
            continue;
        }
        let expected = image::open(&golden).expect("the golden can be read").into_rgba8();
        let comparison = Comparison::of(&expected, &actual);
        if !comparison.is_close() {
            let output = folder("output/golden");
            fs::create_dir_all(&output).expect("the folder can be made");
            actual.save(output.join(format!("{name}-actual.png"))).expect("the picture can be written");
            comparison.picture.save(output.join(format!("{name}-difference.png"))).expect("the picture can be written");
            let Comparison { fraction, largest, .. } = comparison;
            different.push(format!("{name}: {:.2} % of the pixels differ, by up to {largest}", 100.0 * fraction));
        }
    }
    assert!(
        different.is_empty(),
        "{}; see the actual pictures and the differences in tests/output/golden",
        different.join("; ")
    );
}

#[test]
fn comparison_detects_a_handle_moved_by_half_a_pixel() {
    for name in SCENES {
        let mut scene = Scene::named(name);
        let before = warped(&scene);
        assert!(Comparison::of(&before, &warped(&scene)).is_close());
        match &mut scene.project.handles[1].shape {
            Shape::Point { posed, .. } => *posed += DVec2::new(0.5, 0.0),
            Shape::Bar { posed, .. } | Shape::Polygon { posed, .. } => {
                posed.iter_mut().for_each(|p| *p += DVec2::new(0.5, 0.0));
            }
        }
        let comparison = Comparison::of(&before, &warped(&scene));
        eprintln!("{name}: {:.2} % differ", 100.0 * comparison.fraction);
        assert!(comparison.fraction > 0.01, "{name}: {}", comparison.fraction);
    }
}
