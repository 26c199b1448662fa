/** Solutions of the open picture: the one shown, recent ones, and the one the solver works on. */
import type { Project } from '../document/project';
import type { CellBorders, Deformation } from './deformation';

/** How closely an outline follows the picture. Other values than `traced`: it would have too many corners. */
export type OutlineDetail = 'traced' | 'simplified' | 'bridged' | 'picture';

/** The part of the solver's report that the editor goes by. */
export interface SolveReport {
  readonly samples: number;
  readonly virtualSites: number;
  /** Parts of bars and polygons that lie outside the domain. */
  readonly outside: readonly { readonly handle: string }[];
  readonly outline: OutlineDetail;
  /** Widest gap that bends with the parts around it, in image pixels. */
  readonly bridgedGap: number;
  /** Number of connected parts without a handle. */
  readonly looseParts: number;
  /** Milliseconds of all stages, and of each. */
  readonly ms: number;
  readonly times: Readonly<Record<SolveStage | 'pose', number>>;
}

/** A solution and the project that was solved. */
export interface Solution {
  readonly key: string;
  readonly project: Project;
  readonly report: SolveReport;
  readonly deformation: Deformation;
}

export type SolveStage = 'domain' | 'sampling' | 'regions' | 'weights';

export interface SolutionState {
  readonly shown: Solution | null;
  /** The last solutions, newest first, so that undo and redo across an added handle are immediate. */
  readonly recent: readonly Solution[];
  /** The key of the newest request; that of the shown solution when nothing is being solved. */
  readonly wanted: string | null;
  /** The current stage; null between solves. */
  readonly stage: SolveStage | 'start' | null;
  /** The solver itself failed at the last solve, or could not start. */
  readonly failed: boolean;
  /** Whether the solver has started, so that a project can be checked at once. */
  readonly ready: boolean;
  /** The fill behind the shown solution, by its key: it is made, or there. Null if it has none. */
  readonly fill: { readonly key: string; readonly done: boolean } | null;
  /** The borders between the cells of one solution, once they are known. */
  readonly borders: { readonly of: Solution; readonly pieces: CellBorders | null } | null;
}

/** Number of kept solutions: some 3 MB each at 10,000 samples. */
export const MAX_RECENT = 6;

/** The key being solved; null if the shown solution is that of the newest request. */
export const pendingKey = ({ shown, wanted }: SolutionState): string | null =>
  shown?.key === wanted ? null : wanted;
