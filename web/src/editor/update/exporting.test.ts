import { describe, expect, it } from 'vitest';
import type { EditorEffect } from '../effects';
import { englishNotice, englishTask, spokenText } from '../english';
import { FakeRuntime } from '../fake_runtime';
import { takesBail } from './command';

function opened(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  return runtime;
}

const exported = (runtime: FakeRuntime) =>
  runtime.effects.filter(
    (effect): effect is Extract<EditorEffect, { type: 'export' }> => effect.type === 'export',
  );

const run = (runtime: FakeRuntime) => runtime.dispatch({ type: 'command-run', command: 'export' });

describe('an export', () => {
  it('uses the choices of the person, and names the file after them', () => {
    const runtime = opened();
    run(runtime);
    runtime.dispatch({ type: 'export-ended', saved: 'cat-warped.png', error: null });
    const choice = { format: 'jpeg', quality: 70, area: 'covered' } as const;
    runtime.dispatch({ type: 'export-choice-made', choice });
    run(runtime);
    expect(exported(runtime).map(({ name }) => name)).toEqual(['cat-warped.png', 'cat-warped.jpg']);
    expect(exported(runtime).at(-1)?.choices).toMatchObject({ ...choice, percent: 100 });
  });

  it('shows whole percents, and announces every quarter to screen readers', () => {
    const runtime = opened();
    run(runtime);
    const [shown, spoken]: [unknown[], string[]] = [[], []];
    for (const fraction of [0.004, 0.104, 0.109, 0.26, 0.51, 0.5, 1]) {
      runtime.dispatch({ type: 'export-progressed', fraction });
      shown.push(englishTask(runtime.state)?.fraction);
      spoken.push(spokenText(runtime.state));
    }
    expect(shown).toEqual([0, 0.1, 0.1, 0.26, 0.51, 0.51, 1]);
    expect([...new Set(spoken)].slice(1)).toEqual(['Exporting, 26 percent', 'Exporting, 51 percent']);
  });

  it('says the name that it was saved under', () => {
    const runtime = opened();
    run(runtime);
    runtime.dispatch({ type: 'export-ended', saved: 'wave.png', error: null });
    expect(englishNotice(runtime.state)?.text).toBe('Saved as wave.png.');
    expect(englishTask(runtime.state)).toBeNull();
  });

  it('is cancelled by Escape and by its button, without other changes', () => {
    for (const cancel of [
      { type: 'command-run', command: 'bail' },
      { type: 'task-cancelled', task: 'export' },
    ] as const) {
      const runtime = opened();
      const before = runtime.state;
      run(runtime);
      expect(takesBail(runtime.state)).toBe(true);
      runtime.dispatch(cancel);
      expect(runtime.effects.at(-1)).toEqual({ type: 'cancel-export' });
      runtime.dispatch({ type: 'export-ended', saved: null, error: null });
      expect(spokenText(runtime.state)).toBe('Export cancelled');
      const { notices: _, ...after } = runtime.state;
      expect(after).toEqual({ ...before, notices: undefined, ...after, document: before.document });
      expect(englishNotice(runtime.state)).toBeNull();
      expect(takesBail(runtime.state)).toBe(false);
    }
  });

  it('runs alone', () => {
    const runtime = opened();
    run(runtime);
    run(runtime);
    expect(exported(runtime)).toHaveLength(1);
  });

  it('of a part offers to export all of it, whatever the choices', () => {
    const runtime = opened();
    runtime.dispatch({
      type: 'handle-added',
      handle: { id: 'a', kind: 'point', rest: [50, 50], posed: [90, 50], rotation: 0, scale: 1, depth: 0 },
    });
    runtime.solve();
    run(runtime);
    runtime.dispatch({ type: 'export-ended', saved: 'cat-warped.png', error: null });
    expect(englishNotice(runtime.state)?.text).toContain('Parts beyond the frame were cut off.');
    runtime.dispatch({ type: 'notice-answered' });
    expect(exported(runtime).at(-1)).toMatchObject({
      name: 'cat-warped-all.png',
      choices: { area: 'grown' },
    });
    expect(runtime.state.exporting.choices.area).toBe('picture');
  });
});
