import { describe, expect, it } from 'vitest';
import { undoLabel } from '../../document/history';
import { C2WarpError, TOO_MUCH } from '../../error';
import { englishNotice, inEnglish } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { documentOf, projectOf } from '../state';
import type { WorkSnapshot } from '../work';
import { snapshotOf } from './autosave';

const tooMuch = new C2WarpError(
  TOO_MUCH,
  'Not enough memory for this warp. Use fewer handles, or less detail.',
  {
    cause: 'RuntimeError: unreachable',
  },
);

const opened = (): FakeRuntime => {
  const runtime = new FakeRuntime();
  runtime.open(cutout());
  const handle = { id: 'a', kind: 'point', rest: [50, 50], posed: [60, 50] } as const;
  runtime.dispatch({ type: 'handle-added', handle });
  runtime.solve();
  return runtime;
};

/** A picture whose boundary is free at first. */
const cutout = () => ({ ...testPicture(), alphaThreshold: 0.5 });

/** The work with the boundary held, which the solver breaks at. */
function heldWork(): WorkSnapshot {
  const runtime = opened();
  runtime.dispatch({ type: 'boundary-switched', held: true });
  const work = snapshotOf(runtime.state);
  if (!work) throw new Error('nothing is open');
  return work;
}

function restored(work: WorkSnapshot): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.dispatch({ type: 'autosave-key-set', key: 'here' });
  runtime.dispatch({ type: 'started', work: null });
  runtime.dispatch({ type: 'storage-read', stored: { work, recent: [] } });
  runtime.read(cutout());
  return runtime;
}

describe('a step that the solver breaks at', () => {
  it('is taken back with one sentence and no retry', () => {
    const runtime = opened();
    const before = documentOf(runtime.state);
    runtime.dispatch({ type: 'boundary-switched', held: true });
    runtime.refuse(tooMuch);
    expect(documentOf(runtime.state)).toBe(before);
    expect(inEnglish(undoLabel(runtime.state.document.history))).not.toBe('Lock the outline');
    const notice = englishNotice(runtime.state);
    expect(notice?.text).toBe(
      'Not enough memory for this warp. Use fewer handles, or less detail. The step was undone.',
    );
    expect(notice?.action).toBeUndefined();
  });

  it('is taken back for any refusal, with the words of the editor', () => {
    for (const code of ['too-much-memory', 'too-much-work', 'too-many-sites', 'held-too-fine'] as const) {
      const runtime = opened();
      runtime.dispatch({ type: 'boundary-switched', held: true });
      runtime.refuse(new C2WarpError(code, 'lower pose.density, or set fix_boundary to false'));
      expect(projectOf(runtime.state).fix_boundary).toBe(false);
      expect(englishNotice(runtime.state)?.text).toMatch(/^This|^The .+ The step was undone\.$/);
      expect(englishNotice(runtime.state)?.text).not.toMatch(/pose|fix_boundary/);
    }
  });

  it('is taken back from stored work, which is stored without it', () => {
    const runtime = restored(heldWork());
    runtime.refuse(tooMuch);
    runtime.solve();
    expect(projectOf(runtime.state)).toMatchObject({ fix_boundary: false, handles: [{ id: 'a' }] });
    const stored = runtime.effects.findLast((effect) => effect.type === 'store');
    expect(stored?.work?.record.present.project.fix_boundary).toBe(false);
  });

  it('is parked with its work if there is no earlier step to go back to', () => {
    const work = heldWork();
    const runtime = restored({ ...work, record: { ...work.record, past: [] } });
    runtime.refuse(tooMuch);
    runtime.solve();
    expect(projectOf(runtime.state).handles).toEqual([]);
    expect(runtime.state.opening.recent).toHaveLength(1);
    // The next visit opens the picture without handles, and does not fail again.
    const stored = runtime.effects.findLast((effect) => effect.type === 'store');
    expect(stored?.work?.record.present.project.handles).toEqual([]);
    expect(stored?.recent).toHaveLength(1);
  });
});
