//! The frames of a film, drawn on all cores.
//!
//! Poses are found one after another, because one may continue another. A batch of frames is drawn on all cores while
//! the batch before is encoded, so memory does not grow with the film. The result does not depend on the cores.

use std::num::NonZero;
use std::sync::Mutex;
use std::thread;

use c2warp::clip::Playback;
use c2warp::deform::Pose;
use c2warp::project::Clip;
use c2warp::{Picture, ResampleOptions, Solution, Warped};

use crate::error::CliError;
use crate::project::LoadedProject;

/// Frames of a batch per core: enough that no core waits long for the others.
const FRAMES_PER_CORE: usize = 2;

/// A solved project, and the times of its clip to draw.
pub(super) struct Drawing<'a> {
    pub(super) loaded: &'a LoadedProject,
    pub(super) solution: &'a Solution,
    pub(super) picture: Picture<'a>,
    pub(super) clip: &'a Clip,
    pub(super) times: &'a [f64],
    pub(super) options: ResampleOptions,
}

impl Drawing<'_> {
    /// All of the picture at the scale of the film. It has the colours of all frames.
    pub(super) fn picture_at_rest(&self) -> Result<Vec<u8>, CliError> {
        let drawing = c2warp::Drawing::at_rest(&self.picture, self.options);
        drawing.map(|drawing| drawing.warped(&self.picture).rgba).map_err(|reason| self.loaded.refused(reason))
    }

    /// Draws all frames. `prepare` runs on all cores; `take` gets the results in order, with the number of the frame.
    pub(super) fn draw<T: Send, E>(
        &self,
        prepare: impl Fn(Warped) -> T + Sync,
        mut take: impl FnMut(usize, T) -> Result<(), E>,
        refused: impl Fn(CliError) -> E,
    ) -> Result<(), E> {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let project = &self.loaded.project;
        let mut playback = Playback::new(self.solution.poser().clone(), self.clip.clone(), project.handles.clone());
        let mut drawn: Vec<T> = Vec::new();
        let mut taken = 0;
        for times in self.times.chunks(cores * FRAMES_PER_CORE) {
            let poses = times.iter().map(|&time| playback.pose(time, project.pose.blend)).collect::<Result<_, _>>();
            let poses: Vec<Pose> = poses.map_err(|reason| refused(self.loaded.refused(reason)))?;
            let queue = Mutex::new(poses.iter().enumerate());
            let next = || queue.lock().map_or(None, |mut queue| queue.next());
            let work = || {
                let mut results = Vec::new();
                while let Some((at, pose)) = next() {
                    let warped = self.solution.warped(&self.picture, pose, self.options);
                    results.push((at, warped.map(&prepare)));
                }
                results
            };
            let batch = thread::scope(|scope| {
                let workers: Vec<_> = (0..cores.min(poses.len())).map(|_| scope.spawn(work)).collect();
                // Meanwhile this thread encodes the batch before.
                for frame in drawn.drain(..) {
                    take(taken, frame)?;
                    taken += 1;
                }
                let mut batch: Vec<_> =
                    workers.into_iter().flat_map(|worker| worker.join().expect("drawing does not panic")).collect();
                batch.sort_by_key(|&(at, _)| at);
                batch
                    .into_iter()
                    .map(|(_, frame)| frame)
                    .collect::<Result<Vec<T>, _>>()
                    .map_err(|reason| refused(self.loaded.refused(reason)))
            })?;
            drawn = batch;
        }
        for frame in drawn {
            take(taken, frame)?;
            taken += 1;
        }
        Ok(())
    }
}
