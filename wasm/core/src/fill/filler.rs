//! Fills a hole step by step, so that callers can show progress and stop between steps.

use std::collections::VecDeque;

use super::carried::Sources;
use super::level::{Level, NONE, RADIUS};
use super::matches::Matches;
use super::membrane::Membrane;
use super::peeling;
use super::random::Random;
use super::region::Region;
use super::votes::{choose, vote};
use super::{Fill, patch};
use crate::domain::Mask;
use crate::{error::Error, picture::Picture, project::FillSpec};

/// The hole of the coarsest level is at most this deep, in texels, if enough patches remain.
const DEPTH: usize = 3;
/// A deeper hole is halved even if few patches remain.
const DEEP: usize = 10;
/// Passes over the patches before each vote.
const PASSES: u32 = 2;
/// Number of votes at the coarsest level, and at the finest. Other levels are interpolated.
const COARSEST_VOTES: usize = 12;
const FINEST_VOTES: usize = 2;
/// Sweeps of the membrane, in total and per step.
const SWEEPS: usize = 240;
const SWEEPS_AT_ONCE: usize = 40;

/// A step of a fill.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Step {
    /// Fills a layer of the coarsest level, counted from 1 at the rim.
    Peel(usize),
    /// Switches to the next finer level.
    Refine,
    Improve(u32),
    Vote,
    /// Takes the best match of each texel.
    Choose,
    Relax,
    Carry,
}

/// A fill in progress.
#[derive(Debug)]
pub(crate) struct Filler {
    mask: Mask,
    region: Region,
    /// The levels from the present one to the finest.
    levels: VecDeque<Level>,
    matches: Option<Matches>,
    /// For each texel of the finest level, its source, or [`NONE`].
    from: Vec<u32>,
    membrane: Option<Membrane>,
    random: Random,
    steps: VecDeque<(Step, u64)>,
    /// Work of all steps, in comparisons of patches.
    work: u64,
}

impl Filler {
    /// # Errors
    /// [`Error::NothingToFillFrom`] if the mask covers the whole picture.
    pub(crate) fn new(picture: &Picture<'_>, mask: Mask, spec: &FillSpec) -> Result<Self, Error> {
        let region = Region::new(&mask, picture.size());
        let finest = region.level(picture, &mask);
        if finest.unknown.len() == finest.hole.len() {
            return Err(Error::NothingToFillFrom);
        }
        let mut levels = VecDeque::from([finest]);
        while levels[0].has_sources() && levels[0].depth > DEPTH {
            let coarser = levels[0].halved();
            let is_deep = levels[0].depth > DEEP && coarser.has_sources();
            if !coarser.has_choice() && !is_deep {
                break;
            }
            levels.push_front(coarser);
        }
        let mut steps = VecDeque::new();
        if levels[0].has_sources() {
            let last = levels.len() - 1;
            for (index, level) in levels.iter().enumerate() {
                let targets = level.targets.len() as u64;
                if index == 0 {
                    steps.extend((1..).zip(peeling::work(level)).map(|(layer, near)| (Step::Peel(layer), 10 * near)));
                } else {
                    steps.push_back((Step::Refine, 2 * targets));
                }
                let votes = COARSEST_VOTES - (COARSEST_VOTES - FINEST_VOTES) * index / last.max(1);
                let passes = if index == 0 { 5 } else { PASSES };
                for _ in 0..votes {
                    steps.extend((0..passes).map(|pass| (Step::Improve(pass), 10 * targets)));
                    steps.push_back((Step::Vote, 4 * targets));
                }
            }
            let targets = levels[last].targets.len() as u64;
            steps.push_back((Step::Improve(0), 10 * targets));
            steps.push_back((Step::Choose, 2 * targets));
        }
        let finest = &levels[levels.len() - 1];
        let (unknown, from) = (finest.unknown.len() as u64, vec![NONE; finest.hole.len()]);
        steps.extend((0..SWEEPS / SWEEPS_AT_ONCE).map(|_| (Step::Relax, unknown)));
        steps.push_back((Step::Carry, unknown));
        let work = steps.iter().map(|(_, work)| work).sum();
        let random = Random::new(u64::from(spec.seed));
        Ok(Self { mask, region, levels, matches: None, from, membrane: None, random, steps, work })
    }

    /// The completed fraction of the work, from 0 to 1.
    pub(crate) fn progress(&self) -> f64 {
        let left: u64 = self.steps.iter().map(|(_, work)| work).sum();
        1.0 - left as f64 / self.work.max(1) as f64
    }

    /// Runs the next step. Returns the fill after the last one.
    pub(crate) fn advance(&mut self, picture: &Picture<'_>) -> Option<Fill> {
        let (step, _) = self.steps.pop_front()?;
        match step {
            Step::Peel(layer) => {
                let Self { levels, matches, random, .. } = self;
                let matches = matches.get_or_insert_with(|| Matches::random(&levels[0], random));
                peeling::peel(&mut levels[0], matches, layer, random);
            }
            Step::Refine => self.refine(),
            Step::Improve(pass) => {
                let matches = self.matches.as_mut().expect("peeling has found matches");
                matches.improve(&self.levels[0], pass % 2 == 0, &mut self.random);
            }
            Step::Vote => {
                let matches = self.matches.as_ref().expect("peeling has found matches");
                let unknown = self.levels[0].unknown.clone();
                vote(&mut self.levels[0], matches, &unknown);
            }
            Step::Choose => {
                let matches = self.matches.take().expect("peeling has found matches");
                choose(&mut self.levels[0], &matches, &mut self.from);
            }
            Step::Relax => {
                let level = self.levels.back().expect("there is a finest level");
                let membrane = self.membrane.get_or_insert_with(|| Membrane::new(level, &self.from));
                membrane.relax(level, SWEEPS_AT_ONCE);
            }
            Step::Carry => return Some(self.carry(picture)),
        }
        None
    }

    fn refine(&mut self) {
        let coarse = self.levels.pop_front().expect("there is a coarser level");
        let matches = self.matches.take().expect("peeling has found matches");
        let level = &mut self.levels[0];
        let matches = matches.doubled(&coarse, level, &mut self.random);
        choose_own(level, &matches);
        self.matches = Some(matches);
    }

    fn carry(&mut self, picture: &Picture<'_>) -> Fill {
        let level = self.levels.back().expect("there is a finest level");
        let membrane = self.membrane.take().expect("it has been relaxed");
        let sources = Sources { region: self.region, level, from: &self.from, corrections: membrane.corrections() };
        patch(picture, &self.mask, |x, y| sources.pixel(picture, &self.mask, x, y))
    }
}

/// Sets each texel of the hole from the patch around it, or from the nearest patch at the border.
fn choose_own(level: &mut Level, matches: &Matches) {
    let mut copied = Vec::with_capacity(level.unknown.len());
    for &at in &level.unknown {
        let (x, y) = (at as usize % level.width, at as usize / level.width);
        let near = |place: usize, side: usize| place.clamp(RADIUS, side - 1 - RADIUS);
        let centre = near(y, level.height) * level.width + near(x, level.width);
        let slot = level.slots[centre];
        copied.push(match slot {
            NONE => level.texels[at as usize],
            _ => level.texels[matches.sources[slot as usize] as usize + at as usize - centre],
        });
    }
    level.unknown.iter().zip(copied).for_each(|(&at, texel)| level.texels[at as usize] = texel);
}
