import { describe, expect, it } from 'vitest';
import { undoLabel } from '../../document/history';
import { settingsOf } from '../../document/settings';
import { inEnglish } from '../english';
import { FakeRuntime, PAGE } from '../fake_runtime';
import { projectOf } from '../state';
import { takesBail } from './command';

function opened(page = PAGE): FakeRuntime {
  const runtime = new FakeRuntime(page);
  runtime.open();
  return runtime;
}

const alpha = (runtime: FakeRuntime, value: number) =>
  runtime.dispatch({ type: 'setting-set', setting: { name: 'shape_factor', value } });

describe('the study card', () => {
  it('makes room beside the picture, and Escape closes it', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'stage-resized', size: { width: 1000, height: 700 }, typing: false });
    const { camera } = runtime.state.view;
    runtime.dispatch({ type: 'study-shown', page: 'settings' });
    expect(runtime.state.view.camera.scale).toBeLessThan(camera.scale);
    expect(takesBail(runtime.state)).toBe(true);
    runtime.dispatch({ type: 'command-run', command: 'bail' });
    expect(runtime.state.study.page).toBeNull();
    expect(runtime.state.view.camera).toEqual(camera);
  });

  it('needs a picture', () => {
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'study-shown', page: 'settings' });
    expect(runtime.state.study.page).toBeNull();
  });
});

describe('a setting', () => {
  it('is one undo step for a whole drag of its slider, and is solved', () => {
    const runtime = opened();
    const slide = (value: number) =>
      runtime.dispatch({ type: 'setting-slid', setting: { name: 'shape_factor', value } });
    for (const value of [0.9, 0.6]) {
      slide(value);
      runtime.dispatch({ type: 'timer-elapsed', timer: 'merge-end' });
    }
    alpha(runtime, 0.4);
    expect(settingsOf(projectOf(runtime.state)).shape_factor).toBe(0.4);
    expect(runtime.pending.some(({ type }) => type === 'solve')).toBe(true);
    runtime.dispatch({ type: 'undo-asked' });
    expect(settingsOf(projectOf(runtime.state)).shape_factor).toBe(1);
    expect(inEnglish(undoLabel(runtime.state.document.history))).toBeNull();
  });

  it('is one undo step for consecutive values', () => {
    const runtime = opened();
    for (const value of [0.9, 0.8]) alpha(runtime, value);
    runtime.dispatch({ type: 'undo-asked' });
    expect(settingsOf(projectOf(runtime.state)).shape_factor).toBe(1);
  });

  it('does not change for readers', () => {
    const runtime = opened({ ...PAGE, readonly: true });
    alpha(runtime, 0.4);
    runtime.dispatch({ type: 'preset-chosen', preset: 'paper' });
    expect(settingsOf(projectOf(runtime.state)).shape_factor).toBe(1);
    expect(projectOf(runtime.state).pose?.mode).toBe('rigid');
  });
});
