import { describe, expect, it } from 'vitest';
import { type Document, newProject, openDocument } from './document';
import { addHandle, changeHandles, holdBoundary, moveHandles, removeHandles } from './edits';
import { TestHistory } from './fixtures';
import type { Handle, PointHandle } from './project';
import { handleToRevert, revertHandle, withHandleReverted, withSolutionReverted } from './reverting';
import { solveKey } from './solved';

const point = (id: string, x = 0): PointHandle => ({ id, kind: 'point', rest: [x, 0], posed: [x, 0] });
const empty = openDocument(newProject({ src: 'a.png', width: 8, height: 8 }, 0.5));

type Step = (document: Document) => Document;
const add =
  (id: string, x?: number): Step =>
  (document) =>
    addHandle(document, point(id, x));
const put =
  (id: string, x: number): Step =>
  (document) =>
    changeHandles(document, [id], () => point(id, x));
const move =
  (id: string): Step =>
  (document) =>
    moveHandles(document, [id], [0, 3]);
const remove =
  (id: string): Step =>
  (document) =>
    removeHandles(document, [id]);
const hold: Step = (document) => holdBoundary(document, true);

const done = (...steps: readonly Step[]): TestHistory<Document> => {
  const history = new TestHistory(empty);
  for (const step of steps) history.step('Step', step(history.present));
  return history;
};
const blamed = (history: TestHistory<Document>, named: readonly string[], accepted: Document | null = null) =>
  handleToRevert(history.timeline, named, accepted?.project ?? null)?.id ?? null;
const told = ({ project }: Document) =>
  project.handles
    .map(({ id, rest, posed }: Handle) => `${id}${rest[0]}${String(posed) === String(rest) ? '' : '!'}`)
    .join(' ');
const all = (history: TestHistory<Document>) => history.timeline.values.map(told);

describe('handleToRevert', () => {
  it('returns the handle that is not solved yet', () => {
    const history = done(add('a'), add('b'), add('good', 5));
    const [, a, b] = history.timeline.values as [Document, Document, Document];
    expect(blamed(history, ['a', 'b'], a)).toBe('b');
    expect(blamed(history, ['b', 'a'], removeHandles(b, ['a']))).toBe('a');
  });

  it('returns the last changed handle if several are not solved', () => {
    expect(blamed(done(add('a'), add('b'), move('a')), ['a', 'b'], empty)).toBe('b');
    expect(blamed(done(add('a', 5), add('b'), put('a', 0)), ['a', 'b'])).toBe('a');
    const both: Step = (document) => add('b')(add('a')(document));
    expect(blamed(done(both), ['a', 'b'], empty)).toBe('b');
  });

  it('returns no handle that was solved, if only settings changed', () => {
    const history = done(add('a'), hold);
    expect(blamed(history, ['a'], history.timeline.values[1])).toBeNull();
    expect(blamed(history, [], empty)).toBeNull();
  });

  it('returns no handle of a step that replaced the project', () => {
    const other: Step = () => add('a', 3)(add('bad')(empty));
    expect(blamed(done(add('a'), other), ['bad'], add('a')(empty))).toBeNull();
    expect(blamed(done(add('a'), other, move('bad')), ['bad'], add('a')(empty))).toBeNull();
    const settings: Step = (document) => add('bad')(hold(document));
    expect(blamed(done(add('a'), settings), ['bad'], add('a')(empty))).toBeNull();
  });

  it('returns null after opening, and for handles older than the settings', () => {
    expect(blamed(done(add('a'), hold), ['a'])).toBeNull();
    expect(blamed(done(hold, add('a'), move('a')), ['a'])).toBe('a');
    expect(blamed(new TestHistory(add('a')(empty)), ['a'])).toBeNull();
  });
});

describe('withHandleReverted', () => {
  const back = (history: TestHistory<Document>, id: string) => {
    const handle = history.present.project.handles.find((other) => other.id === id) as Handle;
    history.revise(withHandleReverted(history.timeline, handle));
    return history;
  };

  it('removes the handle and the steps that changed only it', () => {
    const history = back(done(add('bad'), add('good'), move('bad'), move('good')), 'bad');
    expect(all(history)).toEqual(['', 'good0', 'good0!']);
    expect(history.present.selection).toEqual(['good']);
  });

  it('restores the handle before the rejected change, with its pose', () => {
    const history = back(done(add('a'), move('a'), put('a', 9), add('b')), 'a');
    expect(all(history)).toEqual(['', 'a0', 'a0!', 'a0! b0']);
  });

  it('reverts redo steps too, and drops the removal of a missing handle', () => {
    const history = done(add('bad'), add('good'), remove('bad'), move('good'));
    for (let k = 0; k < 3; k++) history.undo();
    expect(all(back(history, 'bad'))).toEqual(['', 'good0', 'good0!']);
    expect(told(history.present)).toBe('');
  });

  it('keeps an older, solved handle with the same id and rest position', () => {
    const history = back(done(add('a'), remove('a'), hold, add('a')), 'a');
    expect(all(history)).toEqual(['', 'a0', '', '']);
  });
});

describe('revertHandle', () => {
  it('returns the earlier document itself if nothing else differs', () => {
    const before = add('a')(empty);
    expect(revertHandle(add('bad')(before), point('bad'), before)).toBe(before);
  });

  it('keeps a handle that differs from the rejected one', () => {
    const moved = add('a', 5)(empty);
    expect(told(revertHandle(moved, point('a', 4), empty))).toBe('a5');
  });
});

describe('withSolutionReverted', () => {
  const withdrawn = (history: TestHistory<Document>) => {
    history.revise(withSolutionReverted(history.timeline, solveKey(history.present.project)));
    return history;
  };

  it('returns to the last value with another solution, and drops later ones', () => {
    const history = withdrawn(done(add('a'), hold, move('a')));
    expect(all(history)).toEqual(['', 'a0']);
    expect(history.present.project.fix_boundary).toBe(false);
  });

  it('moves on to the first redo step if there is no earlier value', () => {
    const history = done(add('a'), add('b'));
    history.undo();
    history.undo();
    expect(all(withdrawn(history))).toEqual(['a0', 'a0 b0']);
  });

  it('changes nothing if all values need the rejected solution', () => {
    const history = done();
    expect(history.revise(withSolutionReverted(history.timeline, solveKey(empty.project)))).toBe(false);
  });
});
