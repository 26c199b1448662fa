import { describe, expect, it } from 'vitest';
import { History } from './history';

const state = (history: History<number>) => [history.present, history.undoLabel, history.redoLabel];

describe('History', () => {
  it('makes one step of a drag', () => {
    const history = new History(0);
    history.begin('Move');
    for (const value of [1, 2, 3]) history.update(value);
    expect(history.commit()).toBe(true);
    history.undo();
    expect(state(history)).toEqual([0, null, 'Move']);
    history.redo();
    expect(state(history)).toEqual([3, 'Move', null]);
  });

  it('bails out to the mark', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    history.bail();
    expect(state(history)).toEqual([1, 'Add', null]);
  });

  it('amends the present without a step, and the mark of the open step with it', () => {
    const history = new History({ at: 0, led: 0 }, (a, b) => a.at === b.at && a.led === b.led);
    const lead = (led: number) => history.amend((value) => ({ ...value, led }));
    history.step('Move', { at: 1, led: 0 });
    history.undo();
    lead(1);
    expect([history.present, history.undoLabel, history.redoLabel]).toEqual([
      { at: 0, led: 1 },
      null,
      'Move',
    ]);
    history.begin('Move');
    history.update({ at: 2, led: 1 });
    lead(2);
    expect(history.present).toEqual({ at: 2, led: 2 });
    history.bail();
    expect(history.present).toEqual({ at: 0, led: 2 });
    history.begin('Move');
    lead(3);
    expect(history.commit()).toBe(false);
  });

  it('does not count a drag that changed nothing', () => {
    const history = new History(0);
    history.begin('Move');
    expect(history.commit()).toBe(false);
    expect(history.undoLabel).toBeNull();
  });

  it('takes what is equal for no change, and keeps the future', () => {
    const history = new History({ at: 0 }, (a, b) => a.at === b.at);
    history.step('Move', { at: 1 });
    history.undo();
    history.begin('Move');
    for (const at of [1, 0]) history.update({ at });
    expect(history.commit()).toBe(false);
    expect(history.step('Move', { at: 0 })).toBe(false);
    expect([history.undoLabel, history.redoLabel]).toEqual([null, 'Move']);
  });

  it('leaves a drag in hand alone that a step would change nothing of', () => {
    const history = new History(0);
    history.begin('Move');
    history.update(1);
    history.step('Set', 1);
    history.bail();
    expect(state(history)).toEqual([0, null, null]);
  });

  it('joins steps of one key until it settles', () => {
    const history = new History(0);
    for (const value of [1, 2, 3]) history.step('Nudge', value, 'nudge head');
    history.settle();
    history.step('Nudge', 4, 'nudge head');
    history.undo();
    expect(history.present).toBe(3);
    history.undo();
    expect(history.present).toBe(0);
  });

  it('takes back an open step first', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    expect(history.undo()).toBe('Move');
    expect(history.present).toBe(1);
  });

  it('forgets the future on a new step', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.undo();
    history.step('Add', 2);
    expect(history.redo()).toBeNull();
    expect(history.present).toBe(2);
  });

  it('tells all values in the order of time', () => {
    const history = new History(0);
    for (const value of [1, 2, 3]) history.step('Add', value);
    history.undo();
    history.undo();
    expect(history.timeline).toEqual({ values: [0, 1, 2, 3], at: 1 });
    history.begin('Move');
    history.update(9);
    expect(history.timeline).toEqual({ values: [0, 1, 9, 2, 3], at: 2 });
  });

  it('forgets a merged step that has come back to where it began', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.step('Move', 2, 'nudge');
    history.step('Move', 1, 'nudge');
    expect(state(history)).toEqual([1, 'Add', null]);
    history.step('Move', 2, 'nudge');
    expect(state(history)).toEqual([2, 'Move', null]);
    history.undo();
    expect(state(history)).toEqual([1, 'Add', 'Move']);
  });

  it('is mended throughout, and forgets the steps that change nothing any more', () => {
    const history = new History(0);
    for (const value of [1, 2, 3, 4]) history.step(`Set ${value}`, value);
    history.undo();
    history.undo();
    expect(history.mend([0, 10, 10, 30, 30])).toBe(true);
    expect(history.timeline).toEqual({ values: [0, 10, 30], at: 1 });
    expect(state(history)).toEqual([10, 'Set 1', 'Set 3']);
    expect(history.mend(history.timeline.values)).toBe(false);
  });

  it('forgets the steps between values that are equal and not the same', () => {
    const history = new History<{ readonly x: number }>({ x: 0 }, (a, b) => a.x === b.x);
    history.step('Add', { x: 1 });
    history.step('Delete', { x: 0 });
    history.undo();
    history.mend(history.timeline.values.map((value) => (value.x === 1 ? { x: 0 } : value)));
    expect([history.present.x, history.undoLabel, history.redoLabel]).toEqual([0, null, null]);
  });

  it('is mended under an open step, which goes on', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    history.mend([0, 0, 20]);
    expect(state(history)).toEqual([20, 'Move', null]);
    history.update(30);
    expect(history.commit()).toBe(true);
    history.undo();
    expect(state(history)).toEqual([0, null, 'Move']);
  });

  it('comes back from its record, without the drag in hand', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    const copy = new History(0);
    copy.restore(history.record());
    expect(copy.present).toBe(1);
    copy.undo();
    expect(state(copy)).toEqual([0, null, 'Add']);
  });
});
