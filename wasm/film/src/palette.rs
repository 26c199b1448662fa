//! A palette of 255 colours for a picture, and mixtures of its colours.
//!
//! The palette contains the exact colours of flat areas. The rest come from median cut (Heckbert 1982) on a
//! histogram, then some rounds of k-means.
//!
//! A mixture consists of the palette's colours whose mean is nearest to a colour, ordered by brightness. A fixed
//! pattern chooses from it (Knoll's pattern dithering, US 6,606,166, expired). Colours that are in the palette, or
//! close to it, are not mixed: a pattern would be visible in flat areas.

use std::{cmp::Reverse, collections::BTreeMap};

/// Colours of the palette. One index is left for transparency.
const COLOURS: usize = 255;
/// Colours of flat areas that the palette has as they are. The others are left for gradients and edges.
const MOST_FLAT: usize = 128;
/// A row of as many equal pixels is flat. In photographs few are.
const FLAT_RUN: usize = 4;
/// The least flat area of a colour, as a part of all pixels: 16 × 16 of 1024 × 1024.
const FLAT_PART: usize = 4096;
/// A colour is not mixed if the nearest one of the palette differs by no more in any channel. Nobody sees such a step.
const NEAR: f32 = 1.5;
/// Bits of a channel in the histogram and among the colours that are mixed.
const BITS: u32 = 6;
/// Rounds of k-means. Later ones change colours by less than the rounding of the histogram.
const ROUNDS: usize = 4;
/// Colours in a mixture: the cells of the pattern.
const MIX: usize = 16;
/// How much of the error of a mixture its next colour makes good. With all of it, flat colours get grainy.
const STRENGTH: f32 = 0.7;

/// The order in which 4 × 4 pixels take the colours of a mixture (Bayer 1973).
const PATTERN: [[usize; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

type Colour = [f32; 3];

/// A palette, and the mixtures that were asked for.
#[derive(Debug)]
pub(crate) struct Dithering {
    /// The first colours of the palette: those of flat areas, ascending.
    flat: Vec<[u8; 3]>,
    /// 256 × 3 bytes.
    bytes: Vec<u8>,
    colours: Vec<Colour>,
    /// By the bits of a colour.
    mixtures: Vec<Option<Box<[u8; MIX]>>>,
}

/// A bin of the histogram.
#[derive(Debug, Clone, Copy)]
struct Bin {
    colour: Colour,
    count: f32,
}

impl Dithering {
    /// The palette for the pixels of a picture, row by row. `None` is transparent.
    pub(crate) fn new(pixels: impl Iterator<Item = Option<[u8; 3]>> + Clone) -> Self {
        let flat = flat_colours(pixels.clone());
        let mut bins = histogram(pixels.flatten().filter(|colour| flat.binary_search(colour).is_err()));
        let mut colours: Vec<Colour> = flat.iter().map(|colour| colour.map(f32::from)).collect();
        colours.extend(median_cut(&mut bins, COLOURS - flat.len()));
        for _ in 0..ROUNDS {
            improve(&mut colours, flat.len(), &bins);
        }
        let mut bytes: Vec<u8> = colours.iter().flatten().map(|&channel| channel.round() as u8).collect();
        bytes.resize(3 * (COLOURS + 1), 0);
        let colours = bytes.as_chunks::<3>().0[..colours.len()].iter().map(|rgb| rgb.map(f32::from)).collect();
        Self { flat, bytes, colours, mixtures: vec![None; 1 << (3 * BITS)] }
    }

    /// The palette: red, green and blue of 256 colours.
    pub(crate) fn palette(&self) -> &[u8] {
        &self.bytes
    }

    /// The index of the colour for a pixel at a place.
    pub(crate) fn index(&mut self, colour: [u8; 3], [x, y]: [usize; 2]) -> u8 {
        let Self { flat, colours, mixtures, .. } = self;
        if colours.is_empty() {
            return 0;
        }
        if let Ok(index) = flat.binary_search(&colour) {
            return index as u8;
        }
        let mixture = mixtures[bin_of(colour)].get_or_insert_with(|| Box::new(mixture(colours, colour)));
        mixture[PATTERN[y % 4][x % 4]]
    }
}

fn bin_of(colour: [u8; 3]) -> usize {
    colour.into_iter().fold(0, |bin, channel| (bin << BITS) | usize::from(channel >> (8 - BITS)))
}

/// The colours of the largest flat areas, ascending.
fn flat_colours(pixels: impl Iterator<Item = Option<[u8; 3]>>) -> Vec<[u8; 3]> {
    let mut areas: BTreeMap<[u8; 3], usize> = BTreeMap::new();
    let (mut shown, mut run, mut last) = (0, 0, None);
    let mut end_run = |colour: Option<[u8; 3]>, run: usize| {
        if let Some(colour) = colour.filter(|_| run >= FLAT_RUN) {
            *areas.entry(colour).or_default() += run;
        }
    };
    for pixel in pixels {
        shown += usize::from(pixel.is_some());
        if pixel != last {
            end_run(last, run);
            (run, last) = (0, pixel);
        }
        run += 1;
    }
    end_run(last, run);
    let mut large: Vec<([u8; 3], usize)> = areas.into_iter().filter(|(_, area)| area * FLAT_PART >= shown).collect();
    large.sort_by_key(|&(colour, area)| (Reverse(area), colour));
    let mut flat: Vec<[u8; 3]> = large.into_iter().take(MOST_FLAT).map(|(colour, _)| colour).collect();
    flat.sort_unstable();
    flat
}

/// The bins that have pixels, with their mean colours.
fn histogram(pixels: impl Iterator<Item = [u8; 3]>) -> Vec<Bin> {
    let mut sums = vec![([0_u64; 3], 0_u64); 1 << (3 * BITS)];
    for colour in pixels {
        let (sum, count) = &mut sums[bin_of(colour)];
        sum.iter_mut().zip(colour).for_each(|(sum, channel)| *sum += u64::from(channel));
        *count += 1;
    }
    let bin = |(sum, count): ([u64; 3], u64)| {
        (count > 0).then(|| Bin { colour: sum.map(|sum| sum as f32 / count as f32), count: count as f32 })
    };
    sums.into_iter().filter_map(bin).collect()
}

/// Splits the bins at means of their widest channel until there are `most` parts, and returns the mean of each.
fn median_cut(bins: &mut [Bin], most: usize) -> Vec<Colour> {
    if bins.is_empty() {
        return Vec::new();
    }
    let mut parts = vec![(0, bins.len())];
    while parts.len() < most {
        let spread = |&(from, to): &(usize, usize)| widest(&bins[from..to]);
        let found = parts.iter().map(spread).enumerate().max_by(|a, b| a.1.0.total_cmp(&b.1.0));
        let Some((part, (error, channel, middle))) = found else { break };
        if error <= 0.0 {
            break;
        }
        let (from, to) = parts[part];
        bins[from..to].sort_by(|a, b| a.colour[channel].total_cmp(&b.colour[channel]));
        let cut = from + bins[from..to].partition_point(|bin| bin.colour[channel] <= middle);
        let cut = cut.clamp(from + 1, to - 1);
        parts[part] = (from, cut);
        parts.push((cut, to));
    }
    parts.into_iter().map(|(from, to)| mean(&bins[from..to])).collect()
}

/// The channel of the greatest squared error, that error, and the channel's mean. No error for a single bin.
fn widest(bins: &[Bin]) -> (f32, usize, f32) {
    let mean = mean(bins);
    if bins.len() < 2 {
        return (0.0, 0, mean[0]);
    }
    let error = |channel: usize| -> f32 {
        bins.iter().map(|bin| bin.count * (bin.colour[channel] - mean[channel]).powi(2)).sum()
    };
    let channels = [0, 1, 2].map(|channel| (error(channel), channel, mean[channel]));
    channels.into_iter().fold((0.0, 0, mean[0]), |most, one| if one.0 > most.0 { one } else { most })
}

fn mean(bins: &[Bin]) -> Colour {
    let count: f32 = bins.iter().map(|bin| bin.count).sum();
    [0, 1, 2].map(|channel| bins.iter().map(|bin| bin.count * bin.colour[channel]).sum::<f32>() / count)
}

/// Moves each colour to the mean of the bins that are nearest to it. The first ones stay.
fn improve(colours: &mut [Colour], staying: usize, bins: &[Bin]) {
    let mut sums = vec![([0.0_f32; 3], 0.0_f32); colours.len()];
    for bin in bins {
        let (sum, count) = &mut sums[nearest(colours, bin.colour)];
        sum.iter_mut().zip(bin.colour).for_each(|(sum, channel)| *sum += bin.count * channel);
        *count += bin.count;
    }
    for (colour, (sum, count)) in colours.iter_mut().zip(sums).skip(staying) {
        if count > 0.0 {
            *colour = sum.map(|sum| sum / count);
        }
    }
}

fn nearest(colours: &[Colour], to: Colour) -> usize {
    let distance = |colour: &Colour| -> f32 { colour.iter().zip(to).map(|(a, b)| (a - b).powi(2)).sum() };
    let distances = colours.iter().map(distance).enumerate();
    distances.fold((0, f32::INFINITY), |least, one| if one.1 < least.1 { one } else { least }).0
}

/// Colours whose mean is near a colour, from the darkest.
fn mixture(colours: &[Colour], wanted: [u8; 3]) -> [u8; MIX] {
    let wanted = wanted.map(f32::from);
    let first = nearest(colours, wanted);
    if colours[first].iter().zip(wanted).all(|(a, b)| (a - b).abs() <= NEAR) {
        return [first as u8; MIX];
    }
    let mut error = [0.0_f32; 3];
    let mut mixture = [0_u8; MIX];
    for index in &mut mixture {
        let aim = [0, 1, 2].map(|k| wanted[k] + STRENGTH * error[k]);
        let found = nearest(colours, aim);
        error = [0, 1, 2].map(|k| error[k] + wanted[k] - colours[found][k]);
        *index = found as u8;
    }
    let brightness = |index: u8| {
        let [r, g, b] = colours[usize::from(index)];
        0.299 * r + 0.587 * g + 0.114 * b
    };
    mixture.sort_by(|&a, &b| brightness(a).total_cmp(&brightness(b)));
    mixture
}

#[cfg(test)]
mod tests {
    use super::Dithering;

    #[test]
    fn few_colours_are_kept_exactly() {
        let colours = [[255, 0, 0], [0, 128, 7], [3, 3, 3], [250, 251, 252]];
        let mut dithering = Dithering::new(colours.into_iter().map(Some).cycle().take(400));
        let palette = dithering.palette().to_vec();
        for colour in colours {
            for place in [[0, 0], [1, 2], [3, 3]] {
                let index = usize::from(dithering.index(colour, place));
                assert_eq!(palette[3 * index..][..3], colour);
            }
        }
    }

    #[test]
    fn large_flat_areas_keep_their_colours_beside_many_others() {
        // Many more colours than the palette has, and flat rows that share the bins of the histogram with them.
        let many = (0..32_768_u32).map(|i| [i >> 10, i >> 5, i].map(|channel| ((channel % 32) * 8) as u8));
        let flat = [[201, 101, 51], [250, 240, 230]];
        let rows = flat.into_iter().flat_map(|colour| std::iter::repeat_n(colour, 400));
        let mut dithering = Dithering::new(many.chain(rows).map(Some));
        let palette = dithering.palette().to_vec();
        for colour in flat {
            for place in (0..16).map(|at| [at % 4, at / 4]) {
                let index = usize::from(dithering.index(colour, place));
                assert_eq!(palette[3 * index..][..3], colour);
            }
        }
    }

    #[test]
    fn mixtures_have_the_mean_of_their_colour() {
        let cube = (0..32_768_u32).map(|i| [i >> 10, i >> 5, i].map(|channel| ((channel % 32) * 8) as u8));
        let mut dithering = Dithering::new(cube.map(Some));
        let palette = dithering.palette().to_vec();
        for wanted in [[100, 100, 100], [200, 60, 90], [60, 180, 150]] {
            let places = (0..16).map(|at| [at % 4, at / 4]);
            let mut mean = [0.0; 3];
            for place in places {
                let index = usize::from(dithering.index(wanted, place));
                (0..3).for_each(|k| mean[k] += f64::from(palette[3 * index + k]) / 16.0);
            }
            let error = (0..3).map(|k| (mean[k] - f64::from(wanted[k])).abs()).fold(0.0, f64::max);
            assert!(error < 6.0, "{wanted:?} becomes {mean:?}");
        }
    }

    #[test]
    fn a_film_without_opaque_pixels_has_a_palette() {
        let mut dithering = Dithering::new(std::iter::empty());
        assert_eq!((dithering.palette().len(), dithering.index([1, 2, 3], [0, 0])), (768, 0));
    }
}
