import { beforeEach, describe, expect, it } from 'vitest';
import type { Handle } from '../../document/project';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { FakeRuntime } from '../fake_runtime';
import { projectOf } from '../state';

const point = (id: string, y: number): Handle => ({ id, kind: 'point', rest: [100, 100], posed: [100, y] });

let runtime: FakeRuntime;

const shape = () => projectOf(runtime.state).shape?.[0]?.[2];
const steps = () => runtime.state.document.history.past.length;
const run = (command: 'undo' | 'redo') => runtime.dispatch({ type: 'command-run', command });

function drag(from: Vec, to: Vec): void {
  const pointer = (place: Vec) => {
    const stage = toStage(runtime.state.view.camera, place);
    return { stage, shift: false, alt: false, free: true, coarse: false };
  };
  runtime.dispatch({ type: 'press-began', pointer: pointer(from), pans: false });
  runtime.dispatch({ type: 'press-moved', pointer: pointer(to) });
  runtime.dispatch({ type: 'press-ended', pointer: pointer(to) });
}

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'handle-added', handle: point('tail', 100) });
  runtime.solve();
  runtime.dispatch({ type: 'tool-set', tool: 'select' });
  drag([100, 100], [100, 1100]);
});

describe('the shape that a drag leaves', () => {
  it('belongs to the step of the drag', () => {
    const count = steps();
    expect(shape()).toBe(1100);
    drag([100, 1100], [100, 1200]);
    expect([shape(), steps()]).toEqual([1200, count + 1]);
    run('undo');
    expect(shape()).toBe(1100);
    run('undo');
    expect(shape()).toBeUndefined();
    run('redo');
    run('redo');
    expect(shape()).toBe(1200);
  });

  it('ends with a drag that the handles alone determine', () => {
    drag([100, 1100], [100, 200]);
    expect('shape' in projectOf(runtime.state)).toBe(false);
  });

  it('stays when a handle is added or removed', () => {
    runtime.dispatch({ type: 'handle-added', handle: { ...point('head', 50), rest: [300, 50] } as Handle });
    expect(shape()).toBe(1100);
    runtime.dispatch({ type: 'handle-removed', id: 'head' });
    expect(shape()).toBe(1100);
  });

  it('is removed when handles move without a drag', () => {
    runtime.dispatch({ type: 'handle-changed', handle: point('tail', 1300) });
    expect(shape()).toBeUndefined();
    run('undo');
    expect(shape()).toBe(1100);
    runtime.dispatch({ type: 'handles-posed', handles: [point('tail', 1300)] });
    expect(shape()).toBeUndefined();
  });

  it('ends when all handles are reset', () => {
    runtime.dispatch({ type: 'reset-asked' });
    expect('shape' in projectOf(runtime.state)).toBe(false);
  });
});
