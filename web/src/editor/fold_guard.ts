/**
 * The guard against folds: a drag, a turn, a nudge or a typed number goes only as far as it adds no visible folds.
 *
 * The solver bisects between the last allowed pose and the wanted one for the farthest pose without more folds than
 * before. Cost: some ten poses and passes over all triangles, a few milliseconds in all.
 */
import type { Document } from '../document/document';
import type { GroupTransform, PosedDocument } from '../document/group';
import type { Project } from '../document/project';
import type { Deformation } from './deformation';

export interface FoldGuard {
  readonly on: boolean;
  /** The number of folded triangles allowed during a drag; null between drags. */
  readonly allowed: number | null;
  /** Whether the last change was limited. */
  readonly holding: boolean;
  /** The project that was requested when a change was last limited. Stays after a drag, so that its mark fades. */
  readonly asked: Project | null;
  /** How far a group transform of this drag has gone. */
  readonly reached: GroupTransform | null;
}

export interface Guarded {
  readonly document: Document;
  readonly guard: FoldGuard;
}

/** The questions of the guard; null before the first solution, when nothing folds. */
export type FoldLimiter = Pick<Deformation, 'foldCount' | 'foldLimit' | 'groupFoldLimit'> | null;

export const beginGuarding = (guard: FoldGuard, { project }: Document, folds: FoldLimiter): FoldGuard => ({
  ...guard,
  allowed: guard.on && folds ? folds.foldCount(project) : null,
  asked: null,
  reached: null,
});

/** Ends a drag. */
export const endGuarding = (guard: FoldGuard): FoldGuard =>
  guard.allowed === null && !guard.holding && !guard.reached
    ? guard
    : { ...guard, allowed: null, holding: false, reached: null };

/**
 * The document as far as allowed on the way from `present`, which is allowed, to the wanted one. Returns `present`
 * itself if nothing may move. A group transform stays one on the way.
 */
export function guarded(
  guard: FoldGuard,
  folds: FoldLimiter,
  present: Document,
  wanted: PosedDocument,
): Guarded {
  const { document, transform = null, stopped = false } = wanted;
  if (!guard.on) return { document, guard };
  // The brush does not move handles, and has its own guard.
  const { handles } = document.project;
  const stays = handles.every((handle, k) => handle === present.project.handles[k]);
  if (stays && handles.length === present.project.handles.length)
    return { document, guard: stopped === guard.holding ? guard : { ...guard, holding: stopped } };
  if (!folds) return { document, guard };
  const allowed = guard.allowed ?? folds.foldCount(present.project);
  const start = transform && startOf(guard, transform);
  const { project, fraction } =
    transform && start
      ? folds.groupFoldLimit(
          {
            ...ofOrigin(transform),
            from: present.project,
            to: document.project,
            start,
            end: transform,
          },
          allowed,
        )
      : folds.foldLimit(present.project, document.project, allowed);
  if (project === document.project)
    return { document, guard: { ...guard, holding: false, asked: null, reached: transform } };
  const reached = transform && start ? between(transform, start, fraction) : guard.reached;
  // Equal after rounding: the same object makes no undo step.
  const same = JSON.stringify(project.handles) === JSON.stringify(present.project.handles);
  return {
    document: same ? present : { ...document, project },
    guard: { ...guard, holding: true, asked: document.project, reached },
  };
}

/** The allowed transform that a group transform of the same origin starts from. */
const startOf = ({ reached }: FoldGuard, { origin }: GroupTransform): GroupTransform =>
  reached?.origin === origin ? reached : { origin, turn: 0, scale: 1 };

const ofOrigin = ({ origin }: GroupTransform) => ({ origin: origin.project, selection: origin.selection });

const between = (end: GroupTransform, start: GroupTransform, fraction: number): GroupTransform => ({
  origin: end.origin,
  turn: start.turn + fraction * (end.turn - start.turn),
  scale: start.scale + fraction * (end.scale - start.scale),
});
