import { beforeEach, describe, expect, it } from 'vitest';
import { type Document, newProject, openDocument } from '../document/document';
import { addHandle, moveHandles } from '../document/edits';
import { posedGroup } from '../document/group';
import { beginGuarding, endGuarding, type FoldGuard, type FoldLimiter, guarded } from './fold_guard';

const at = (x: number): Document =>
  addHandle(openDocument(newProject({ src: '', width: 8, height: 8 }, null)), {
    id: 'a',
    kind: 'point',
    rest: [0, 0],
    posed: [x, 0],
  });
const place = ({ project: { handles } }: Document): number =>
  handles[0]?.kind === 'point' ? handles[0].posed[0] : Number.NaN;
const foldsAt = (x: number): number => (x > 20 ? 2 : x > 10 ? 1 : 0);
const foldsOf = (document: Document): number => foldsAt(place(document));

/** Everything beyond x = 10 folds once, beyond 20 twice. A limit lies exactly where the next fold begins. */
const FOLDS: FoldLimiter = {
  foldCount: (project) => foldsOf({ project, selection: [] }),
  foldLimit: (from, to, allowed) => {
    if (foldsOf({ project: to, selection: [] }) <= allowed) return { project: to, fraction: 1 };
    const end = allowed === 0 ? 10 : 20;
    const [start, goal] = [place({ project: from, selection: [] }), place({ project: to, selection: [] })];
    return { project: at(end).project, fraction: (end - start) / (goal - start) };
  },
  groupFoldLimit: ({ origin, start, end }) => ({
    project: origin,
    fraction: start.turn < 40 && end.turn > 60 ? 0.5 : 1,
  }),
};

describe('the guard against folds', () => {
  let guard: FoldGuard;
  const limited = (present: Document, document: Document) => {
    const result = guarded(guard, FOLDS, present, { document });
    guard = result.guard;
    return result.document;
  };
  beforeEach(() => {
    guard = { on: true, allowed: null, holding: false, asked: null, reached: null };
  });

  it('lets everything pass while it is off', () => {
    guard = { ...guard, on: false };
    expect(place(limited(at(0), at(30)))).toBe(30);
  });

  it('lets a handle go up to the fold, and come free', () => {
    const start = at(0);
    guard = beginGuarding(guard, start, FOLDS);
    const held = limited(start, moveHandles(start, ['a'], [16, 0]));
    expect(place(held)).toBe(10);
    expect(guard.holding).toBe(true);
    expect(guard.asked?.handles[0]?.posed).toEqual([16, 0]);
    expect(place(limited(held, moveHandles(start, ['a'], [6, 0])))).toBe(6);
    expect([guard.holding, guard.asked]).toEqual([false, null]);
    expect(endGuarding(guard)).toEqual({
      on: true,
      allowed: null,
      holding: false,
      asked: null,
      reached: null,
    });
  });

  it('keeps the folds that exist, and stops at more', () => {
    guard = beginGuarding(guard, at(12), FOLDS);
    expect(place(limited(at(12), at(18)))).toBe(18);
    expect(place(limited(at(18), at(30)))).toBe(20);
  });

  it('returns the same document where nothing may move', () => {
    const start = at(10);
    expect(limited(start, at(10.5))).toBe(start);
  });

  it('remembers how far a group transform went', () => {
    const origin = at(0);
    const result = guarded(guard, FOLDS, origin, posedGroup(origin, 80, 1));
    expect(result.guard).toMatchObject({ holding: true, reached: { turn: 40, scale: 1 } });
  });
});
