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

  it('does not count a drag that changed nothing', () => {
    const history = new History(0);
    history.begin('Move');
    expect(history.commit()).toBe(false);
    expect(history.undoLabel).toBeNull();
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

  it('withdraws what cannot stand, from the past and the future alike', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.step('Add', -2);
    history.begin('Move');
    history.update(-3);
    expect(history.withdraw((value) => value >= 0)).toBe(true);
    expect(state(history)).toEqual([1, 'Add', null]);
    history.undo();
    expect(history.present).toBe(0);
  });

  it('cannot withdraw where nothing ever stood', () => {
    const history = new History(-1);
    expect(history.withdraw((value) => value >= 0)).toBe(false);
    expect(history.present).toBe(-1);
  });

  it('comes back from its record, without the drag in hand', () => {
    const history = new History(0);
    history.step('Add', 1);
    history.begin('Move');
    history.update(2);
    const copy = History.from(history.record());
    expect(copy.present).toBe(1);
    copy.undo();
    expect(state(copy)).toEqual([0, null, 'Add']);
  });
});
