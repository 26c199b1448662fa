import { describe, expect, it } from 'vitest';
import { TestHistory } from './fixtures';

const state = (history: TestHistory<number>) => [history.present, history.undoLabel, history.redoLabel];

describe('the history', () => {
  it('makes one step of a drag', () => {
    const history = new TestHistory(0);
    history.begin('Move');
    for (const value of [1, 2, 3]) history.update(value);
    expect(history.commit()).toBe(true);
    history.undo();
    expect(state(history)).toEqual([0, null, 'Move']);
    history.redo();
    expect(state(history)).toEqual([3, 'Move', null]);
  });

  it('returns to the start of a drag on bail', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    history.bail();
    expect(state(history)).toEqual([1, 'Add', null]);
  });

  it('amends the present and the start of the open step without a step', () => {
    const history = new TestHistory({ at: 0, led: 0 }, (a, b) => a.at === b.at && a.led === b.led);
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
    const history = new TestHistory(0);
    history.begin('Move');
    expect(history.commit()).toBe(false);
    expect(history.undoLabel).toBeNull();
  });

  it('keeps the future on a step to an equal value', () => {
    const history = new TestHistory({ at: 0 }, (a, b) => a.at === b.at);
    history.step('Move', { at: 1 });
    history.undo();
    history.begin('Move');
    for (const at of [1, 0]) history.update({ at });
    expect(history.commit()).toBe(false);
    expect(history.step('Move', { at: 0 })).toBe(false);
    expect([history.undoLabel, history.redoLabel]).toEqual([null, 'Move']);
  });

  it('keeps an open step when a step changes nothing', () => {
    const history = new TestHistory(0);
    history.begin('Move');
    history.update(1);
    history.step('Set', 1);
    history.bail();
    expect(state(history)).toEqual([0, null, null]);
  });

  it('merges steps of one key until merging ends', () => {
    const history = new TestHistory(0);
    for (const value of [1, 2, 3]) history.step('Nudge', value, 'nudge head');
    history.endMerging();
    history.step('Nudge', 4, 'nudge head');
    history.undo();
    expect(history.present).toBe(3);
    history.undo();
    expect(history.present).toBe(0);
  });

  it('takes back an open step first', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    expect(history.undoLabel).toBe('Move');
    history.undo();
    expect(history.present).toBe(1);
  });

  it('forgets the future on a new step', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.undo();
    history.step('Add', 2);
    expect(history.redoLabel).toBeNull();
    history.redo();
    expect(history.present).toBe(2);
  });

  it('lists all values from the oldest to the newest', () => {
    const history = new TestHistory(0);
    for (const value of [1, 2, 3]) history.step('Add', value);
    history.undo();
    history.undo();
    expect(history.timeline).toEqual({ values: [0, 1, 2, 3], at: 1 });
    history.begin('Move');
    history.update(9);
    expect(history.timeline).toEqual({ values: [0, 1, 9, 2, 3], at: 2 });
  });

  it('drops a merged step that is back where it began', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.step('Move', 2, 'nudge');
    history.step('Move', 1, 'nudge');
    expect(state(history)).toEqual([1, 'Add', null]);
    history.step('Move', 2, 'nudge');
    expect(state(history)).toEqual([2, 'Move', null]);
    history.undo();
    expect(state(history)).toEqual([1, 'Add', 'Move']);
  });

  it('revises all values and drops steps that change nothing', () => {
    const history = new TestHistory(0);
    for (const value of [1, 2, 3, 4]) history.step(`Set ${value}`, value);
    history.undo();
    history.undo();
    expect(history.revise([0, 10, 10, 30, 30])).toBe(true);
    expect(history.timeline).toEqual({ values: [0, 10, 30], at: 1 });
    expect(state(history)).toEqual([10, 'Set 1', 'Set 3']);
    expect(history.revise(history.timeline.values)).toBe(false);
  });

  it('drops steps between equal values that are different objects', () => {
    const history = new TestHistory<{ readonly x: number }>({ x: 0 }, (a, b) => a.x === b.x);
    history.step('Add', { x: 1 });
    history.step('Delete', { x: 0 });
    history.undo();
    history.revise(history.timeline.values.map((value) => (value.x === 1 ? { x: 0 } : value)));
    expect([history.present.x, history.undoLabel, history.redoLabel]).toEqual([0, null, null]);
  });

  it('keeps the open step open when values are revised', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    history.revise([0, 0, 20]);
    expect(state(history)).toEqual([20, 'Move', null]);
    history.update(30);
    expect(history.commit()).toBe(true);
    history.undo();
    expect(state(history)).toEqual([0, null, 'Move']);
  });

  it('restores its record without the open step', () => {
    const history = new TestHistory(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    const copy = new TestHistory(0);
    copy.restore(history.record());
    expect(copy.present).toBe(1);
    copy.undo();
    expect(state(copy)).toEqual([0, null, 'Add']);
  });
});
