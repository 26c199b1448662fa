import { describe, expect, it } from 'vitest';
import { isFilled, ringsOf } from '../../document/domain';
import { undoLabel } from '../../document/history';
import { C2WarpError } from '../../error';
import type { EditorEffect } from '../effects';
import { englishNotice, englishTask, inEnglish } from '../english';
import { type FakeRuntime, lassoed, RING } from '../fake_runtime';
import { projectOf } from '../state';

type Fill = Extract<EditorEffect, { type: 'fill' }>;

const asked = ({ effects }: FakeRuntime): readonly Fill[] =>
  effects.filter((effect): effect is Fill => effect.type === 'fill');
const keyOf = (runtime: FakeRuntime): string => asked(runtime).at(-1)?.key ?? '';
const isOn = ({ state }: FakeRuntime): boolean => isFilled(projectOf(state));

describe('the fill of a lasso', () => {
  it('is on from the beginning, and one step with the lasso', () => {
    const runtime = lassoed();
    expect(isOn(runtime)).toBe(true);
    expect(asked(runtime)).toHaveLength(1);
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(isOn(runtime)).toBe(false);
    expect(ringsOf(projectOf(runtime.state))).toEqual([]);
    expect(runtime.state.solution.fill).toBeNull();
  });

  it('is off in a picture with transparency, and after it was switched off', () => {
    expect(isOn(lassoed(0.5))).toBe(false);
    const runtime = lassoed();
    runtime.dispatch({ type: 'fill-switched', on: false });
    runtime.dispatch({ type: 'lasso-drawn', ring: RING.map(([x, y]) => [x + 150, y]), hole: false });
    expect(ringsOf(projectOf(runtime.state))).toHaveLength(2);
    expect(isOn(runtime)).toBe(false);
  });

  it('leaves no gap, and the notice mentions none', () => {
    expect(englishNotice(lassoed().state)?.text).toBe('Only this part bends now, over a filled background.');
  });

  it('is made once, whatever handles are placed', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'filled', key: keyOf(runtime) });
    expect(runtime.state.solution.fill?.done).toBe(true);
    runtime.dispatch({
      type: 'handle-added',
      handle: { id: 'a', kind: 'point', rest: [60, 60], posed: [60, 60] },
    });
    runtime.solve();
    expect(asked(runtime)).toHaveLength(1);
    expect(runtime.state.solution.fill?.done).toBe(true);
  });

  it('shows its progress if it takes long', () => {
    const runtime = lassoed();
    expect(englishTask(runtime.state)).toBeNull();
    runtime.dispatch({ type: 'timer-elapsed', timer: 'fill-patience' });
    runtime.dispatch({ type: 'fill-progressed', key: keyOf(runtime), part: 0.5 });
    expect(englishTask(runtime.state)).toMatchObject({ label: 'Filling the background', fraction: 0.5 });
    runtime.dispatch({ type: 'filled', key: keyOf(runtime) });
    expect(englishTask(runtime.state)).toBeNull();
  });

  it('is switched off when it is cancelled, and can be switched on again', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'timer-elapsed', timer: 'fill-patience' });
    runtime.dispatch({ type: 'task-cancelled', task: 'fill' });
    expect(isOn(runtime)).toBe(false);
    expect(englishTask(runtime.state)).toBeNull();
    expect(inEnglish(undoLabel(runtime.state.document.history))).toBe('Leave the background empty');
    runtime.solve();
    runtime.dispatch({ type: 'fill-switched', on: true });
    runtime.solve();
    expect(isOn(runtime)).toBe(true);
    expect(asked(runtime)).toHaveLength(2);
  });

  it('is switched off with a message if there is nothing to fill from', () => {
    const runtime = lassoed();
    runtime.dispatch({
      type: 'fill-failed',
      key: keyOf(runtime),
      error: new C2WarpError('nothing-to-fill-from', 'no pixel'),
    });
    expect(isOn(runtime)).toBe(false);
    expect(englishNotice(runtime.state)?.text).toContain('The selection leaves nothing');
    // Undo takes the lasso back, and not the switch.
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(ringsOf(projectOf(runtime.state))).toEqual([]);
  });

  it('goes with the lasso', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'lasso-removed' });
    runtime.solve();
    expect('fill' in projectOf(runtime.state)).toBe(false);
    expect(runtime.state.solution.fill).toBeNull();
  });
});
