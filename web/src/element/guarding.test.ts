import { beforeEach, describe, expect, it } from 'vitest';
import { type Document, newProject, openDocument, selectedHandles } from '../document/document';
import { addHandle, moveHandles, selectHandles, turnHandles } from '../document/edits';
import { groupSpan, groupTurn, posedGroup, transformGroup } from '../document/group';
import { rotationOf, rounded, roundedVec } from '../document/handle';
import type { Project } from '../document/project';
import { lerp } from '../geometry/vec';
import { Guarding } from './guarding';

type FoldsOf = (project: Project) => number;

/** A guard over points and bars whose folds are a function; ways are searched as the solver searches them. */
function guard(foldsOf: FoldsOf): Guarding {
  const farthest = (to: Project, at: (fraction: number) => Project, allowed: number) => {
    if (foldsOf(to) <= allowed) return { project: to, fraction: 1 };
    let limit = { project: at(0), fraction: 0 };
    for (let step = 1; step <= 8; step++) {
      const fraction = limit.fraction + 0.5 ** step;
      const project = at(fraction);
      if (foldsOf(project) <= allowed) limit = { project, fraction };
    }
    return limit;
  };
  const mix = (a: number, b: number, fraction: number) => a + fraction * (b - a);
  const guarding = new Guarding({
    foldsOf,
    foldLimit: (from, to, allowed) => farthest(to, (fraction) => pointsBetween(from, to, fraction), allowed),
    groupFoldLimit: ({ origin, selection, to, start, end }, allowed) => {
      const document = { ...openDocument(origin), selection };
      const at = (fraction: number) =>
        transformGroup(document, mix(start.turn, end.turn, fraction), mix(start.scale, end.scale, fraction));
      return farthest(to, (fraction) => at(fraction).project, allowed);
    },
  });
  guarding.on = true;
  return guarding;
}

function pointsBetween(from: Project, to: Project, fraction: number): Project {
  const handles = to.handles.map((handle, k) => {
    const start = from.handles[k];
    if (handle.kind !== 'point' || start?.kind !== 'point' || start === handle) return handle;
    const posed = roundedVec(lerp(start.posed, handle.posed, fraction));
    if (typeof handle.rotation !== 'number') return { ...handle, posed };
    const turn = rotationOf(start);
    return { ...handle, posed, rotation: rounded(turn + fraction * (handle.rotation - turn)) };
  });
  return { ...to, handles };
}

/** Everything beyond x = 10 folds, and twice as much beyond 20; a turn beyond 45° too. */
const foldsOf = ({ handles: [handle] }: Document['project']): number => {
  if (handle?.kind !== 'point') return 0;
  const far = handle.posed[0] > 20 ? 2 : handle.posed[0] > 10 ? 1 : 0;
  return far + (rotationOf(handle) > 45 ? 1 : 0);
};

const at = (x: number): Document =>
  addHandle(openDocument(newProject({ src: '', width: 8, height: 8 }, null)), {
    id: 'a',
    kind: 'point',
    rest: [0, 0],
    posed: [x, 0],
  });
const place = (document: Document) => {
  const [handle] = document.project.handles;
  return handle?.kind === 'point' ? handle.posed[0] : Number.NaN;
};

describe('the guard against folds', () => {
  let guarding: Guarding;
  beforeEach(() => {
    guarding = guard(foldsOf);
  });

  it('is off at first', () => {
    guarding.on = false;
    expect(place(guarding.limited(at(0), { document: at(30) }))).toBe(30);
  });

  it('lets a handle go up to the fold, creep along it, and come free', () => {
    const start = at(0);
    guarding.begin(start);
    const held = guarding.limited(start, { document: moveHandles(start, ['a'], [16, 0]) });
    expect(place(held)).toBeGreaterThan(9.9);
    expect(place(held)).toBeLessThanOrEqual(10);
    expect(guarding.holding).toBe(true);
    const still = guarding.limited(held, { document: moveHandles(start, ['a'], [40, 0]) });
    expect(place(still)).toBeLessThanOrEqual(10);
    const back = guarding.limited(still, { document: moveHandles(start, ['a'], [6, 0]) });
    expect(place(back)).toBe(6);
    expect(guarding.holding).toBe(false);
  });

  it('keeps the folds that there were, and stops at more', () => {
    const start = at(12);
    guarding.begin(start);
    expect(place(guarding.limited(start, { document: at(18) }))).toBe(18);
    const held = place(guarding.limited(at(18), { document: at(30) }));
    expect(held).toBeGreaterThan(19.9);
    expect(held).toBeLessThanOrEqual(20);
  });

  it('stops several that turn as one where they are, none nearer to the others', () => {
    const handles = [-8, 8].map((y) => ({ id: `${y}`, kind: 'point', rest: [0, y], posed: [0, y] }) as const);
    const start = selectHandles(
      handles.reduce(addHandle, openDocument(newProject({ src: '', width: 8, height: 8 }, null))),
      ['-8', '8'],
    );
    // The first goes to the right: its place folds beyond 60°.
    guarding = guard(({ handles: [first] }) =>
      Number(first?.kind === 'point' && first.posed[0] > 8 * Math.sin(Math.PI / 3)),
    );
    guarding.begin(start);
    const held = guarding.limited(start, posedGroup(start, 85, 1));
    const still = guarding.limited(held, posedGroup(start, 80, 1));
    expect(groupTurn(selectedHandles(held))).toBeCloseTo(60, 0);
    expect(groupTurn(selectedHandles(still))).toBeCloseTo(60, 0);
    expect(groupSpan(selectedHandles(still))).toBeCloseTo(8, 1);
    expect(still.project.handles.map((handle) => rotationOf(handle))).toEqual([
      expect.closeTo(60, 0),
      expect.closeTo(60, 0),
    ]);
  });

  it('stops several that turn as one until all of the turn is allowed, and not where it would be by the way around', () => {
    const bar = {
      id: 'bar',
      kind: 'bar',
      rest: [
        [-8, 0],
        [8, 0],
      ],
      posed: [
        [-8, 0],
        [8, 0],
      ],
    } as const;
    const point = { id: 'point', kind: 'point', rest: [0, 9], posed: [0, 9], rotation: 'auto' } as const;
    const start = selectHandles(
      [bar, point].reduce(addHandle, openDocument(newProject({ src: '', width: 8, height: 8 }, null))),
      ['bar', 'point'],
    );
    // From 80° to 300° it folds.
    const turn = (project: Document['project']) => (project.handles[0] ? rotationOf(project.handles[0]) : 0);
    guarding = guard((project) => Number(turn(project) > 80 && turn(project) < 300));
    guarding.begin(start);
    let now = start;
    const turns = [70, 100, 190, 260, 290, 310, 320].map((degrees) => {
      now = guarding.limited(now, posedGroup(start, degrees, 1));
      return Math.round(turn(now.project));
    });
    expect(turns).toEqual([70, 80, 80, 80, 80, 310, 320]);
    // Taken back, and begun anew from the same document.
    guarding.end();
    guarding.begin(start);
    const [again] = guarding.limited(start, posedGroup(start, 100, 1)).project.handles;
    expect(again && Math.round(rotationOf(again))).toBe(80);
    expect(guarding.limited(start, posedGroup(start, 190, 1)).project.handles[0]).toEqual(again);
    expect(groupSpan(selectedHandles(now))).toBeCloseTo(groupSpan(selectedHandles(start)), 1);
  });

  it('stops a turn on its way', () => {
    const start = at(0);
    const held = guarding.limited(start, { document: turnHandles(start, ['a'], () => 90) });
    const [handle] = held.project.handles;
    expect(handle && rotationOf(handle)).toBeCloseTo(45, 0);
  });

  it('leaves the document as it is where nothing can move', () => {
    const start = at(10);
    expect(guarding.limited(start, { document: at(10.5) })).toBe(start);
  });
});
