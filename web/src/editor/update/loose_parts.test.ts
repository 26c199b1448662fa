import { describe, expect, it } from 'vitest';
import { undoLabel } from '../../document/history';
import { englishNotice, inEnglish } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { projectOf } from '../state';

const place = (runtime: FakeRuntime, id: string) =>
  runtime.dispatch({ type: 'handle-added', handle: { id, kind: 'point', rest: [50, 50], posed: [50, 50] } });

function opened(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open(testPicture(), { looseParts: 221 });
  return runtime;
}

describe('parts without a handle', () => {
  it('are reported once a handle is placed, and follow in one step on request', () => {
    const runtime = opened();
    expect(englishNotice(runtime.state)).toBeNull();
    place(runtime, 'a');
    runtime.solve({ looseParts: 220 });
    expect(englishNotice(runtime.state)).toMatchObject({
      text: '220 parts have no handle and stay in place.',
      action: { label: 'Let them follow' },
    });
    runtime.dispatch({ type: 'notice-answered' });
    expect(projectOf(runtime.state).loose_parts).toBe('follow');
    runtime.solve({ looseParts: 220 });
    expect(englishNotice(runtime.state)).toBeNull();
    expect(inEnglish(undoLabel(runtime.state.document.history))).toBe('Set whether loose parts follow');
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(projectOf(runtime.state).loose_parts).toBe('stay');
  });

  it('are reported if the solve ends before the press that places a handle', () => {
    const runtime = opened();
    const pointer = { stage: [200, 150], shift: false, alt: false, free: false, coarse: false } as const;
    runtime.dispatch({ type: 'command-run', command: 'point' });
    runtime.dispatch({ type: 'press-began', pointer, pans: false });
    runtime.solve({ looseParts: 2 });
    runtime.dispatch({ type: 'press-ended', pointer });
    expect(projectOf(runtime.state).handles).toHaveLength(1);
    expect(englishNotice(runtime.state)?.text).toBe('2 parts have no handle and stay in place.');
    place(runtime, 'b');
    expect(englishNotice(runtime.state)).toBeNull();
  });

  it('are reported once for each picture', () => {
    const runtime = opened();
    place(runtime, 'a');
    runtime.solve({ looseParts: 2 });
    runtime.dispatch({ type: 'notice-dismissed' });
    place(runtime, 'b');
    runtime.solve({ looseParts: 1 });
    expect(englishNotice(runtime.state)).toBeNull();
    runtime.open(testPicture('dog.png'));
    place(runtime, 'a');
    runtime.solve({ looseParts: 1 });
    expect(englishNotice(runtime.state)?.text).toBe('One part has no handle and stays in place.');
  });
});
