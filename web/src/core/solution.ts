/** A solved project. It holds no resources. */
import type { Moment, Points } from '../compute/messages';
import type { PointWeights } from '../compute/points';
import type { SolutionData } from '../compute/solution';
import type { ProjectFile } from '../document/project';
import { C2WarpError } from '../error';
import type { Environment } from './environment';
import { PosedSolution, posedBy, problemText } from './posed';
import type { Solver } from './solver';
import type { Cancellable, HandlePose, Mesh, Point, Report, Sites, Study } from './types';

/** How the handles of a project move each point of its picture, in any pose. */
export class Solution {
  /** A copy of the project. */
  readonly project: ProjectFile;
  /** The figures of `c2warp inspect --json`. */
  readonly report: Report;
  readonly sites: Sites;
  readonly mesh: Mesh;
  readonly #solver: Solver;
  readonly #environment: Environment;

  /** @internal */
  constructor(solver: Solver, environment: Environment, project: ProjectFile, data: SolutionData) {
    const { positions, triangles, offsets, sites, weights, siteRest, siteHandle, report } = data;
    this.#solver = solver;
    this.#environment = environment;
    this.project = project;
    this.report = report;
    this.sites = { rest: siteRest, handle: siteHandle };
    this.mesh = { positions, triangles, offsets, sites, weights };
  }

  /**
   * The weights of sites at any points of the picture, in rows, as in `c2warp weights`. They are computed in closed
   * form, without interpolation.
   *
   * @param points Points × 2, in image pixels.
   * @throws the reason of the signal if that is aborted.
   */
  async weights(points: Float64Array, { signal }: Cancellable = {}): Promise<PointWeights> {
    const project = problemText(this.project);
    const rows: PointWeights[] = [];
    const bodyOf = (points: Points) => ({ project, points });
    for await (const batch of this.#solver.batches('weights', points, bodyOf, signal)) rows.push(batch);
    return joined(rows);
  }

  /**
   * The lengths of the shortest paths inside the domain from a point to other points, in pixels, as in `c2warp
   * distance`. `Infinity` if no path exists, NaN outside the domain.
   *
   * @param from A point in the domain, in image pixels.
   * @param points Points × 2, in image pixels.
   * @throws C2WarpError with the code `point-outside` if `from` is outside the domain.
   * @throws the reason of the signal if that is aborted.
   */
  async distances(
    from: Point,
    points: Float64Array,
    { signal }: Cancellable = {},
  ): Promise<Float64Array<ArrayBuffer>> {
    const project = problemText(this.project);
    const distances = new Float64Array(points.length / 2);
    let at = 0;
    const bodyOf = (points: Points) => ({ project, from, points });
    for await (const batch of this.#solver.batches('distances', points, bodyOf, signal)) {
      distances.set(batch, at);
      at += batch.length;
    }
    return distances;
  }

  /**
   * The vertices of the shortest path inside the domain, including both ends: points × 2, in image pixels. Empty if no
   * path connects the points.
   *
   * @throws the errors of {@link distances}.
   */
  path(from: Point, to: Point, { signal }: Cancellable = {}): Promise<Float64Array<ArrayBuffer>> {
    return this.#solver.ask('path', { project: problemText(this.project), from, to }, signal);
  }

  /**
   * Explains the solution: the outline, the cells with their radii, φ, and the rounds of Algorithm 1. Points are at
   * rest, in image pixels, and lengths in pixels.
   *
   * @throws the reason of the signal if that is aborted.
   */
  study({ signal }: Cancellable = {}): Promise<Study> {
    return this.#solver.ask('study', { project: problemText(this.project) }, signal);
  }

  /**
   * Poses handles, by their ids. Other handles keep their pose in the project. The solution does not change. The solver
   * rejects invalid poses at the first use of the result.
   *
   * @throws C2WarpError with the code `pose` if a handle does not exist.
   */
  pose(poses: Readonly<Record<string, HandlePose>> = {}): PosedSolution {
    return this.#posed(posedBy(this.project, poses), null);
  }

  /**
   * Poses all handles by a clip of the project at a time.
   *
   * @param time Seconds.
   * @throws C2WarpError with the code `clip` if the clip does not exist, or the time is not a finite number.
   */
  clip(name: string, time: number): PosedSolution {
    const clip = this.project.clips?.find((clip) => clip.name === name);
    if (!clip) throw new C2WarpError('clip', `There is no clip ${JSON.stringify(name)}.`);
    if (!Number.isFinite(time))
      throw new C2WarpError('clip', `Expected the time of the clip in seconds, found ${time}.`);
    return this.#posed(this.project, { clip: JSON.stringify(clip), time });
  }

  #posed(project: ProjectFile, moment: Moment | null): PosedSolution {
    return new PosedSolution(this.#solver, this.#environment, project, moment);
  }
}

/** All rows of several batches. */
function joined(batches: readonly PointWeights[]): PointWeights {
  const [first] = batches;
  if (first && batches.length === 1) return first;
  const entries = batches.reduce((sum, { sites }) => sum + sites.length, 0);
  const points = batches.reduce((sum, { offsets }) => sum + offsets.length - 1, 0);
  const all = {
    offsets: new Uint32Array(points + 1),
    sites: new Uint32Array(entries),
    weights: new Float64Array(entries),
  };
  let [point, entry] = [0, 0];
  for (const { offsets, sites, weights } of batches) {
    all.offsets.set(
      offsets.map((offset) => offset + entry),
      point,
    );
    all.sites.set(sites, entry);
    all.weights.set(weights, entry);
    point += offsets.length - 1;
    entry += sites.length;
  }
  return all;
}
