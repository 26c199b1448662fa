import { describe, expect, it } from 'vitest';
import { modeOf } from '../../document/bending';
import type { Handle, PoseMode } from '../../document/project';
import type { Vec } from '../../geometry/vec';
import type { EditorEvent } from '../events';
import { FakeRuntime } from '../fake_runtime';
import { documentOf, filedProject } from '../state';

const corners = [
  [10, 10],
  [60, 10],
  [60, 40],
] as const;
const HANDLES: readonly Handle[] = [
  { id: 'auto', kind: 'point', rest: [100, 150], posed: [120, 140], rotation: 'auto' },
  { id: 'pinned', kind: 'point', rest: [200, 150], posed: [200, 150], rotation: 0 },
  { id: 'turned', kind: 'point', rest: [300, 150], posed: [300, 150], rotation: 30 },
  { id: 'bar', kind: 'bar', rest: corners, posed: corners, rotation: 'auto' },
  { id: 'polygon', kind: 'polygon', rest: corners, posed: corners, rotation: 450 },
];

const choose = (mode: PoseMode): EditorEvent => ({ type: 'pose-mode-chosen', mode });

function opened(mode: PoseMode, ...handles: readonly Handle[]): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch(choose(mode));
  for (const handle of handles) runtime.dispatch({ type: 'handle-added', handle });
  runtime.solve();
  return runtime;
}

describe('the mode of bending', () => {
  it.each([
    ['rigid', 'harmonic'],
    ['harmonic', 'rigid'],
  ] as const)('from %s to %s and back is the same project, and so is undo', (from, to) => {
    const runtime = opened(from, ...HANDLES);
    const before = filedProject(runtime.state);
    runtime.dispatch(choose(to));
    expect(modeOf(filedProject(runtime.state))).toBe(to);
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(filedProject(runtime.state)).toBe(before);
    runtime.dispatch(choose(to));
    runtime.dispatch(choose(from));
    expect(JSON.stringify(filedProject(runtime.state))).toBe(JSON.stringify(before));
    // Any number of times.
    runtime.dispatch(choose(to));
    runtime.dispatch(choose(from));
    expect(JSON.stringify(filedProject(runtime.state))).toBe(JSON.stringify(before));
  });

  it('makes no key of the rotations that it changes, in the timeline', () => {
    const at: Vec = [100, 150];
    const runtime = opened('harmonic', { id: 'a', kind: 'point', rest: at, posed: at });
    runtime.dispatch({ type: 'command-run', command: 'timeline' });
    runtime.dispatch({ type: 'clip-added', preset: null });
    runtime.dispatch({ type: 'playhead-moved', time: 0.5 });
    runtime.dispatch(choose('rigid'));
    const project = filedProject(runtime.state);
    expect(project.clips?.[0]?.tracks).toEqual([]);
    expect(project.handles.map(({ rotation }) => rotation)).toEqual(['auto']);
    expect(documentOf(runtime.state).moment?.time).toBe(0.5);
    expect(documentOf(runtime.state).project.handles[0]?.rotation).toBe('auto');
  });
});
