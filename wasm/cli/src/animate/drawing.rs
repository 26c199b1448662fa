//! The frames of a film, drawn on all cores.
//!
//! Poses are computed one after another, because each may continue the previous one. A batch of frames is drawn on all
//! cores while the previous batch is encoded, so memory does not grow with the film. The result does not depend on the
//! number of cores.

use std::num::NonZero;
use std::sync::Mutex;
use std::thread;

use c2warp::clip::Playback;
use c2warp::deform::Pose;
use c2warp::project::Clip;
use c2warp::{Canvas, Extent, Picture, ResampleOptions, Solution, Warped};

use crate::error::CliError;
use crate::progress;
use crate::project::LoadedProject;

/// Frames of a batch per core: enough to keep all cores busy.
const FRAMES_PER_CORE: usize = 2;

/// A solved project, and the times of its clip to draw.
pub(super) struct Drawing<'a> {
    loaded: &'a LoadedProject,
    solution: &'a Solution,
    picture: Picture<'a>,
    playback: Playback,
    times: &'a [f64],
    options: ResampleOptions,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(
        loaded: &'a LoadedProject,
        solution: &'a Solution,
        clip: &Clip,
        times: &'a [f64],
        options: ResampleOptions,
    ) -> Result<Self, CliError> {
        let playback = loaded.playback(solution, clip);
        Ok(Self { loaded, solution, picture: loaded.picture()?, playback, times, options })
    }

    /// Grows the rectangle of all frames to hold everything that is drawn in any of them, and returns it.
    pub(super) fn grow(&mut self) -> Result<Extent, CliError> {
        let Self { loaded, solution, picture, options, .. } = *self;
        let grown = ResampleOptions { canvas: Canvas::Grown, ..options };
        let mut all: Option<Extent> = None;
        let extent = |pose: &Pose| solution.extent(&picture, pose, grown);
        let take = |_, extent| {
            let union = all.map_or(Ok(extent), |all| all.union(extent));
            all = Some(union.map_err(|reason| loaded.refused(reason))?);
            Ok(())
        };
        self.each(extent, take, |error| error)?;
        let extent = all.expect("a film has frames");
        self.options.canvas = Canvas::Fixed(extent);
        Ok(extent)
    }

    /// The whole picture at the scale of the film. It has the colours of all frames.
    pub(super) fn picture_at_rest(&self) -> Result<Vec<u8>, CliError> {
        let drawing = c2warp::Drawing::at_rest(&self.picture, self.options);
        drawing.map(|drawing| drawing.warped(&self.picture).rgba).map_err(|reason| self.loaded.refused(reason))
    }

    /// Draws all frames. `prepare` runs on all cores; `take` gets the results in order, with the number of the frame.
    pub(super) fn draw<T: Send, E>(
        &mut self,
        prepare: impl Fn(Warped) -> T + Sync,
        take: impl FnMut(usize, T) -> Result<(), E>,
        refused: impl Fn(CliError) -> E,
    ) -> Result<(), E> {
        let Self { solution, picture, options, .. } = *self;
        self.each(|pose| solution.warped(&picture, pose, options).map(&prepare), take, refused)
    }

    /// Poses all frames. `make` runs on all cores; `take` gets the results in order, with the number of the frame.
    fn each<T: Send, E>(
        &mut self,
        make: impl Fn(&Pose) -> Result<T, c2warp::Error> + Sync,
        mut take: impl FnMut(usize, T) -> Result<(), E>,
        refused: impl Fn(CliError) -> E,
    ) -> Result<(), E> {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let Self { loaded, playback, times, .. } = self;
        let blend = loaded.project.pose.blend;
        let refused = |reason| refused(loaded.refused(reason));
        let mut made: Vec<T> = Vec::new();
        let (mut taken, all) = (0, times.len());
        for times in times.chunks(cores * FRAMES_PER_CORE) {
            let poses: Result<Vec<Pose>, _> = times.iter().map(|&time| playback.pose(time, blend)).collect();
            let poses = poses.map_err(refused)?;
            let queue = Mutex::new(poses.iter().enumerate());
            let next = || queue.lock().map_or(None, |mut queue| queue.next());
            let work = || {
                let mut results = Vec::new();
                while let Some((at, pose)) = next() {
                    results.push((at, make(pose)));
                }
                results
            };
            made = thread::scope(|scope| {
                let start = |_| thread::Builder::new().spawn_scoped(scope, work).ok();
                let workers: Vec<_> = (0..cores.min(poses.len())).map_while(start).collect();
                // Meanwhile this thread encodes the batch before.
                for result in made.drain(..) {
                    take(taken, result)?;
                    taken += 1;
                    progress::count("frame", taken, all);
                }
                // In WebAssembly no thread can be started.
                let here = if workers.is_empty() { work() } else { Vec::new() };
                let drawn = workers.into_iter().flat_map(|worker| worker.join().expect("drawing does not panic"));
                let mut batch: Vec<_> = drawn.chain(here).collect();
                batch.sort_by_key(|&(at, _)| at);
                batch.into_iter().map(|(_, result)| result).collect::<Result<Vec<T>, _>>().map_err(refused)
            })?;
        }
        for result in made {
            take(taken, result)?;
            taken += 1;
            progress::count("frame", taken, all);
        }
        Ok(())
    }
}
