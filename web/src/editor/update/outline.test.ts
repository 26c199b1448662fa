import { describe, expect, it } from 'vitest';
import { settingsOf } from '../../document/settings';
import { C2WarpError } from '../../error';
import { en } from '../../texts/en';
import { englishNotice } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { projectOf } from '../state';
import { viewModel } from '../view_model';

const place = (runtime: FakeRuntime, id: string) =>
  runtime.dispatch({ type: 'handle-added', handle: { id, kind: 'point', rest: [50, 50], posed: [50, 50] } });

describe('the least opacity', () => {
  const opened = (): FakeRuntime => {
    const runtime = new FakeRuntime();
    runtime.open({ ...testPicture(), alphaThreshold: 0.5 });
    place(runtime, 'a');
    runtime.solve();
    return runtime;
  };
  const threshold = ({ state }: FakeRuntime) => settingsOf(projectOf(state)).threshold;

  it('is set with the outline on the stage', () => {
    const runtime = opened();
    expect(viewModel(runtime.state, en).outline).toBeNull();
    runtime.dispatch({ type: 'outline-shown', on: true });
    expect(viewModel(runtime.state, en).outline).not.toBeNull();
    runtime.dispatch({ type: 'outline-shown', on: false });
    expect(viewModel(runtime.state, en).outline).toBeNull();
  });

  it('that leaves a handle outside is taken back, also during a drag', () => {
    const runtime = opened();
    const slide = (value: number) =>
      runtime.dispatch({ type: 'setting-slid', setting: { name: 'threshold', value } });
    slide(0.6);
    runtime.solve();
    slide(0.9);
    runtime.refuse(new C2WarpError('handle-outside', 'outside', { handles: ['a'] }));
    expect(projectOf(runtime.state).handles).toHaveLength(1);
    expect(threshold(runtime)).toBeLessThan(0.9);
    slide(0.4);
    runtime.dispatch({ type: 'setting-set', setting: { name: 'threshold', value: 0.4 } });
    runtime.solve();
    expect(threshold(runtime)).toBe(0.4);
  });
});

describe('an outline too fine to be followed', () => {
  const bridged = { outline: 'bridged', bridgedGap: 8 } as const;
  const text = 'This outline is too fine to follow: parts up to 8 pixels apart bend together.';

  it('is reported once, and again when another way is taken', () => {
    const runtime = new FakeRuntime();
    runtime.open(testPicture(), bridged);
    expect(englishNotice(runtime.state)?.text).toBe(text);
    runtime.dispatch({ type: 'notice-dismissed' });
    place(runtime, 'a');
    runtime.solve(bridged);
    expect(englishNotice(runtime.state)).toBeNull();
    place(runtime, 'b');
    runtime.solve({ outline: 'picture', bridgedGap: 0 });
    expect(englishNotice(runtime.state)?.text).toContain('the whole picture bends');
  });

  it('is also reported for the next picture', () => {
    const runtime = new FakeRuntime();
    runtime.open(testPicture('a.png'), bridged);
    runtime.open(testPicture('b.png'), bridged);
    expect(englishNotice(runtime.state)?.text).toBe(text);
  });

  it('is not mentioned where it is followed', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    expect(englishNotice(runtime.state)).toBeNull();
  });
});
