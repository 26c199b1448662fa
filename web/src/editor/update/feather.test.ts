import { describe, expect, it } from 'vitest';
import { featherOf, isSameDomain, withFeather, withRings } from '../../document/domain';
import { undoLabel } from '../../document/history';
import type { EditorEffect } from '../effects';
import { inEnglish } from '../english';
import { type FakeRuntime, lassoed, RING } from '../fake_runtime';
import { projectOf } from '../state';

const count = ({ effects }: FakeRuntime, type: EditorEffect['type']): number =>
  effects.filter((effect) => effect.type === type).length;
const widthOf = ({ state }: FakeRuntime): number | null => featherOf(projectOf(state));

describe('the feather of a lasso', () => {
  it('is 0 at first, and consecutive changes are one named step', () => {
    const runtime = lassoed();
    expect(widthOf(runtime)).toBe(0);
    runtime.dispatch({ type: 'feather-set', change: { to: 12 } });
    runtime.dispatch({ type: 'feather-set', change: { by: 1, least: 0, most: 64 } });
    expect(widthOf(runtime)).toBe(13);
    expect(inEnglish(undoLabel(runtime.state.document.history))).toBe('Set the feather of the selection');
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(widthOf(runtime)).toBe(0);
  });

  it('is solved anew, and its fill is kept', () => {
    const runtime = lassoed();
    const [solves, fills] = [count(runtime, 'solve'), count(runtime, 'fill')];
    runtime.dispatch({ type: 'feather-set', change: { to: 12 } });
    runtime.solve();
    expect(count(runtime, 'solve')).toBe(solves + 1);
    const keys = runtime.effects.flatMap((effect) => (effect.type === 'fill' ? [effect.key] : []));
    expect(new Set(keys).size).toBe(1);
    expect(fills).toBeGreaterThan(0);
  });

  it('stays when the outline changes, and goes with the lasso', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'feather-set', change: { to: 12 } });
    expect(featherOf(withRings(projectOf(runtime.state), [RING]))).toBe(12);
    runtime.dispatch({ type: 'selection-extended', at: [180, 100] });
    expect(widthOf(runtime)).toBe(12);
    runtime.dispatch({ type: 'lasso-removed' });
    expect(widthOf(runtime)).toBeNull();
  });

  it('is no part of the domain that bends, and needs drawn rings', () => {
    const project = projectOf(lassoed().state);
    expect(isSameDomain(project, withFeather(project, 8))).toBe(true);
    const whole = { ...project, domain: { kind: 'image' } } as const;
    expect(withFeather(whole, 8)).toBe(whole);
  });
});
