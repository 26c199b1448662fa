//! Tests of arrays, handles and heat maps of `c2warp weights`.

use std::fs;
use std::path::Path;

use crate::command::{command, fail, succeed, succeed_with_closed_pipe};
use crate::scene_folder::SceneFolder;
use crate::tables::table;

const WEIGHTS: &str = "weights scene.c2warp.json";

/// Reads the shape and the numbers of an NPY file.
fn npy(path: &Path) -> (Vec<usize>, Vec<f64>) {
    let bytes = fs::read(path).unwrap();
    assert_eq!(bytes[..8], *b"\x93NUMPY\x01\x00");
    let start = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!(start % 64, 0);
    let header = String::from_utf8(bytes[10..start].to_vec()).unwrap();
    assert!(header.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': (") && header.ends_with('\n'));
    let (_, shape) = header.split_once("'shape': (").unwrap();
    let (shape, _) = shape.split_once(')').unwrap();
    let shape = shape.split(',').filter_map(|side| side.trim().parse().ok()).collect();
    let numbers = bytes[start..].as_chunks().0.iter().map(|&number| f64::from_le_bytes(number)).collect();
    (shape, numbers)
}

#[test]
fn array_has_the_weights_of_the_table() {
    let folder = SceneFolder::new("ring");
    let points = [[20.0, 64.0], [33.3, 90.125], [64.0, 20.5], [64.0, 64.0]];
    let (_, rows) = table(&folder, "weights", &points);
    succeed(folder.path(), &format!("{WEIGHTS} --at points.csv -o out.npy --sites sites.csv"));
    let (shape, numbers) = npy(&folder.file("out.npy"));
    let mut sites = csv::Reader::from_path(folder.file("sites.csv")).unwrap();
    assert_eq!(sites.headers().unwrap(), vec!["site", "kind", "handle", "site_x", "site_y"]);
    let sites: Vec<_> = sites.records().map(Result::unwrap).collect();
    assert_eq!(shape, [4, sites.len()]);
    let mut expected = vec![0.0; numbers.len()];
    for row in &rows {
        let [point, site]: [usize; 2] = [0, 1].map(|cell| row[cell].parse().unwrap());
        expected[point * sites.len() + site] = row[6].parse().unwrap();
        assert!(sites[site].iter().skip(1).eq(row.iter().skip(2).take(4)));
    }
    assert_eq!(numbers, expected);
    // The hole has no weights.
    assert!(numbers[3 * sites.len()..].iter().all(|&weight| weight == 0.0));
    assert_eq!(
        succeed(folder.path(), &format!("{WEIGHTS} --at points.csv --format npy -o -")),
        fs::read(folder.file("out.npy")).unwrap()
    );
}

#[test]
fn weights_of_all_handles_sum_to_one_over_the_grid() {
    let folder = SceneFolder::new("strip");
    let mut sums = vec![0.0; 32 * 16];
    for handle in ["left", "middle", "right"] {
        succeed(folder.path(), &format!("{WEIGHTS} --handle {handle} --every 3 -o {handle}.npy"));
        let (shape, numbers) = npy(&folder.file(&format!("{handle}.npy")));
        assert_eq!(shape, [16, 32]);
        sums.iter_mut().zip(numbers).for_each(|(sum, weight)| *sum += weight);
    }
    assert!(sums.iter().all(|sum: &f64| (sum - 1.0).abs() < 1e-9));
    succeed(folder.path(), &format!("{WEIGHTS} --handle middle --every 3 -o middle.csv"));
    let mut reader = csv::Reader::from_path(folder.file("middle.csv")).unwrap();
    assert_eq!(reader.headers().unwrap(), vec!["point", "x", "y", "handle", "weight"]);
    let (_, numbers) = npy(&folder.file("middle.npy"));
    let mut rows = 0;
    for row in reader.records().map(Result::unwrap) {
        let (point, weight): (usize, f64) = (row[0].parse().unwrap(), row[4].parse().unwrap());
        let [x, y]: [f64; 2] = [1, 2].map(|cell| row[cell].parse().unwrap());
        assert_eq!((weight, &row[3]), (numbers[point], "middle"));
        assert_eq!([x, y], [(point % 32) as f64 * 3.0 + 0.5, (point / 32) as f64 * 3.0 + 0.5]);
        rows += 1;
    }
    assert_eq!(rows, numbers.iter().filter(|&&weight| weight > 0.0).count());
}

#[test]
fn heat_map_colours_the_picture_near_the_handle() {
    let folder = SceneFolder::new("ring");
    let project: serde_json::Value =
        serde_json::from_slice(&fs::read(folder.file("scene.c2warp.json")).unwrap()).unwrap();
    let handle = &project["handles"][0];
    let (id, rest) = (handle["id"].as_str().unwrap(), &handle["rest"]);
    succeed(folder.path(), &format!("{WEIGHTS} --handle {id} -o heat.png"));
    let (before, after) = (folder.picture("ring.png"), folder.picture("heat.png"));
    assert_eq!(before.dimensions(), after.dimensions());
    assert!(before.pixels().zip(after.pixels()).all(|(a, b)| a[3] == b[3]));
    let [x, y] = [0, 1].map(|axis| rest[axis].as_f64().unwrap() as u32);
    let (own, heated) = (before.get_pixel(x, y).0, after.get_pixel(x, y).0);
    // Near 1, the editor mixes 78 % of a yellow.
    for (channel, yellow) in [244.0, 240.0, 78.0].into_iter().enumerate() {
        let expected = f64::from(own[channel]) * 0.22 + yellow * 0.78;
        assert!((f64::from(heated[channel]) - expected).abs() < 12.0, "{heated:?} over {own:?}");
    }
}

#[test]
fn refused_weights_are_named() {
    let folder = SceneFolder::new("strip");
    folder.write("points.csv", "x,y\n1,2\n");
    for (arguments, expected) in [
        (
            "--handle hat --every 4 -o a.npy",
            "there is no handle \"hat\": the project has [\"left\", \"middle\", \"right\"]",
        ),
        ("--every 4 -o a.png", "a.png: a heat map shows one handle"),
        ("--handle left --every 4 -o a.png", "a.png: a heat map shows the whole picture"),
        ("--handle left -o a.npy", "a.npy: a table needs points: pass --at or --every"),
        ("--every 0.5 -o a.npy", "--every: expected a whole number of at least 1, found 0.5"),
        ("--every 4 -o a.npy --sites a.npy", "a.npy: this is also the output a.npy"),
    ] {
        let line = fail(folder.path(), &format!("{WEIGHTS} {arguments}"));
        assert!(line.contains(expected), "{line}");
        assert!(!folder.file("a.npy").exists());
    }
}

#[test]
fn arrays_beyond_the_limit_are_refused_with_their_size() {
    let folder = SceneFolder::new("strip").edited(|project| {
        project["image"] = serde_json::json!({ "src": "strip.png", "width": 6000, "height": 4000 });
        project["samples"] = 500.into();
    });
    image::RgbaImage::from_pixel(6000, 4000, image::Rgba([9, 9, 9, 255])).save(folder.file("strip.png")).unwrap();
    let line = fail(folder.path(), &format!("{WEIGHTS} --every 1 -o a.npy"));
    assert!(line.contains("4000 × 6000 × ") && line.contains(" GB: take fewer points, or one handle"), "{line}");
    assert!(!folder.file("a.npy").exists());
}

#[test]
fn closed_pipe_ends_an_array_quietly() {
    let folder = SceneFolder::new("strip");
    succeed_with_closed_pipe(folder.path(), &format!("{WEIGHTS} --every 1 --format npy -o -"));
    let run = command(folder.path(), &format!("{WEIGHTS} --every 1 -o a.npy --at points.csv")).output().unwrap();
    assert_eq!(run.status.code(), Some(2));
}
