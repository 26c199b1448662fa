import { describe, expect, it } from 'vitest';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { shownNotice } from './notices';

const place = (runtime: FakeRuntime, id: string) =>
  runtime.dispatch({ type: 'handle-added', handle: { id, kind: 'point', rest: [50, 50], posed: [50, 50] } });

describe('an outline too fine to be followed', () => {
  const bridged = { outline: 'bridged', bridgedGap: 8 } as const;
  const text = 'This outline is too fine to be followed: parts up to 8 pixels apart bend together.';

  it('is told of once, and again when another way is taken', () => {
    const runtime = new FakeRuntime();
    runtime.open(testPicture(), bridged);
    expect(shownNotice(runtime.state)?.text).toBe(text);
    runtime.dispatch({ type: 'notice-dismissed' });
    place(runtime, 'a');
    runtime.solve(bridged);
    expect(shownNotice(runtime.state)).toBeNull();
    place(runtime, 'b');
    runtime.solve({ outline: 'picture', bridgedGap: 0 });
    expect(shownNotice(runtime.state)?.text).toContain('the whole picture bends');
  });

  it('is told of for the next picture as well', () => {
    const runtime = new FakeRuntime();
    runtime.open(testPicture('a.png'), bridged);
    runtime.open(testPicture('b.png'), bridged);
    expect(shownNotice(runtime.state)?.text).toBe(text);
  });

  it('is not mentioned where it is followed', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    expect(shownNotice(runtime.state)).toBeNull();
  });
});
