//! The opacity of a picture, without data for blocks that are completely empty or opaque.
//!
//! The opacity outside the outline is needed after the picture has been released, to find the visible parts around the
//! outline.
//!
//! Cost: linear in the pixels, with one byte of memory for each pixel near a translucent one.

use glam::DVec2;

use crate::picture::Picture;

/// Pixels below this alpha change a picture by at most one level.
pub(crate) const VISIBLE: u8 = 2;
/// Side of a block in pixels.
const BLOCK: u32 = 8;
const BLOCK_PIXELS: usize = (BLOCK * BLOCK) as usize;

/// The alpha of each pixel.
#[derive(Debug, Clone)]
pub(crate) struct Opacity {
    width: u32,
    height: u32,
    columns: u32,
    /// Blocks from left to right, then from top to bottom.
    blocks: Vec<Block>,
    levels: Vec<[u8; BLOCK_PIXELS]>,
}

#[derive(Debug, Clone, Copy)]
enum Block {
    /// No pixel is visible.
    Empty,
    Opaque,
    /// The block has its own levels.
    Mixed(u32),
}

impl Opacity {
    pub(crate) fn new(picture: &Picture<'_>) -> Self {
        let pixels = picture.rgba().as_chunks::<4>().0;
        Self::of_levels(picture.size(), |at| pixels[at][3])
    }

    /// The opacity of a picture from the level of each pixel.
    pub(crate) fn of_levels((width, height): (u32, u32), level: impl Fn(usize) -> u8) -> Self {
        let (columns, rows) = (width.div_ceil(BLOCK), height.div_ceil(BLOCK));
        let mut levels = Vec::new();
        let mut block = |column: u32, row: u32| {
            let mut own = [0; BLOCK_PIXELS];
            let columns = BLOCK.min(width - column * BLOCK) as usize;
            for y in 0..BLOCK.min(height - row * BLOCK) {
                let from = (row * BLOCK + y) as usize * width as usize + (column * BLOCK) as usize;
                let line = &mut own[(y * BLOCK) as usize..][..columns];
                line.iter_mut().zip(from..).for_each(|(own, at)| *own = level(at));
            }
            if own.iter().all(|&level| level < VISIBLE) {
                return Block::Empty;
            }
            if own.iter().all(|&level| level == u8::MAX) {
                return Block::Opaque;
            }
            levels.push(own);
            Block::Mixed(levels.len() as u32 - 1)
        };
        let blocks = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let blocks = blocks.map(|(column, row)| block(column, row)).collect();
        Self { width, height, columns, blocks, levels }
    }

    /// Width and height in pixels.
    pub(crate) fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.width), f64::from(self.height))
    }

    /// The alpha of a pixel; 0 if no pixel in its block is visible.
    pub(crate) fn level(&self, x: u32, y: u32) -> u8 {
        match self.block(x, y) {
            Block::Empty => 0,
            Block::Opaque => u8::MAX,
            Block::Mixed(at) => self.levels[at as usize][(y % BLOCK * BLOCK + x % BLOCK) as usize],
        }
    }

    fn block(&self, x: u32, y: u32) -> Block {
        self.blocks[(y / BLOCK * self.columns + x / BLOCK) as usize]
    }

    /// The visible pixels of a row in a half-open range.
    pub(crate) fn visible(&self, y: u32, from: u32, to: u32) -> impl Iterator<Item = u32> + '_ {
        let mut next = from;
        std::iter::from_fn(move || {
            while next < to {
                let x = next;
                if matches!(self.block(x, y), Block::Empty) {
                    next = (x / BLOCK + 1) * BLOCK;
                    continue;
                }
                next += 1;
                if self.level(x, y) >= VISIBLE {
                    return Some(x);
                }
            }
            None
        })
    }

    /// Whether any visible pixel overlaps a box.
    pub(crate) fn any_in(&self, low: DVec2, high: DVec2) -> bool {
        self.any_in_rows(low.y, high.y, |_| [low.x, high.x])
    }

    /// Whether any visible pixel overlaps a triangle.
    pub(crate) fn any_in_triangle(&self, [a, b, c]: [DVec2; 3]) -> bool {
        let columns = |y: f64| {
            let mut range = [f64::INFINITY, f64::NEG_INFINITY];
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let (top, bottom) = if p.y < q.y { (p, q) } else { (q, p) };
                if bottom.y < y || top.y > y + 1.0 {
                    continue;
                }
                // The part of the edge within the row.
                for at in [y.max(top.y), (y + 1.0).min(bottom.y)] {
                    let down = if top.y < bottom.y { (at - top.y) / (bottom.y - top.y) } else { 0.0 };
                    let x = top.x + down * (bottom.x - top.x);
                    range = [range[0].min(x), range[1].max(x)];
                }
                if top.y == bottom.y {
                    range = [range[0].min(bottom.x), range[1].max(bottom.x)];
                }
            }
            range
        };
        self.any_in_rows(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), columns)
    }

    /// Whether any visible pixel lies between two heights, in a given range of columns of each row.
    fn any_in_rows(&self, low: f64, high: f64, columns: impl Fn(f64) -> [f64; 2]) -> bool {
        let pixels = |from: f64, to: f64, size: u32| {
            (from.floor().max(0.0) as u32)..to.ceil().clamp(0.0, f64::from(size)) as u32
        };
        pixels(low, high, self.height).into_iter().any(|y| {
            let [from, to] = columns(f64::from(y));
            let range = pixels(from, to, self.width);
            self.visible(y, range.start, range.end).next().is_some()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_those_of_the_picture_except_invisible_ones() {
        let (width, height) = (37_u32, 21_u32);
        let level = |x: u32, y: u32| match (x / 9, y / 9) {
            (0, 0) => 1,
            (1 | 2, _) => 255,
            _ => (x * 7 + y * 13) as u8,
        };
        let rgba: Vec<u8> = (0..width * height).flat_map(|i| [9, 9, 9, level(i % width, i / width)]).collect();
        let opacity = Opacity::new(&Picture::new(width, height, &rgba).unwrap());
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let expected = level(x, y);
            let found = opacity.level(x, y);
            assert!(found == expected || expected < VISIBLE && found == 0, "{found} at {x}, {y}");
        }
        let visible: Vec<u32> = opacity.visible(3, 5, width).collect();
        let expected: Vec<u32> = (5..width).filter(|&x| level(x, 3) >= VISIBLE).collect();
        assert_eq!(visible, expected);
    }

    #[test]
    fn boxes_that_touch_a_visible_pixel_only_at_its_border_have_none() {
        let mut rgba = vec![0; 20 * 20 * 4];
        rgba[(11 * 20 + 9) * 4 + 3] = 40;
        let opacity = Opacity::new(&Picture::new(20, 20, &rgba).unwrap());
        let any = |low: [f64; 2], high: [f64; 2]| opacity.any_in(low.into(), high.into());
        assert!(any([0.0, 0.0], [20.0, 20.0]) && any([-5.0, 11.5], [9.1, 30.0]) && any([9.9, 11.9], [12.0, 12.0]));
        assert!(!any([0.0, 0.0], [9.0, 20.0]) && !any([10.0, 0.0], [20.0, 20.0]) && !any([0.0, 12.0], [20.0, 20.0]));
    }
    #[test]
    fn triangles_have_the_pixels_that_they_overlap() {
        let mut rgba = vec![0; 20 * 20 * 4];
        rgba[(11 * 20 + 9) * 4 + 3] = 40;
        let opacity = Opacity::new(&Picture::new(20, 20, &rgba).unwrap());
        let any = |corners: [[f64; 2]; 3]| opacity.any_in_triangle(corners.map(DVec2::from));
        assert!(any([[0.0, 0.0], [30.0, 11.0], [0.0, 20.0]]));
        assert!(any([[9.5, 11.5], [9.6, 11.5], [9.5, 11.6]]));
        assert!(any([[0.0, 0.0], [9.1, 11.1], [0.0, 20.0]]));
        assert!(any([[0.0, 12.0], [9.5, 11.9], [20.0, 12.0]]));
        // The box around it has the pixel.
        assert!(!any([[0.0, 0.0], [20.0, 20.0], [20.0, 0.0]]));
        assert!(!any([[0.0, 12.0], [20.0, 12.0], [10.0, 20.0]]));
    }
}
