import { describe, expect, it } from 'vitest';
import { numbersOf } from '../../document/displacement';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { en } from '../../texts/en';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { projectOf } from '../state';
import { packed } from '../stored_displacements';
import { viewModel } from '../view_model';
import { workOf } from './autosave';

/** The brush in hand, on a picture of so many pixels. */
function brushing(width: number, height: number): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open({ ...testPicture(), width, height });
  runtime.dispatch({ type: 'command-run', command: 'brush' });
  return runtime;
}

const pointer = ({ state }: FakeRuntime, place: Vec) => ({
  stage: toStage(state.view.camera, place),
  shift: false,
  alt: false,
  free: false,
  coarse: false,
});

function begin(runtime: FakeRuntime, ...[from, ...others]: readonly [Vec, ...Vec[]]): void {
  runtime.dispatch({ type: 'press-began', pointer: pointer(runtime, from), pans: false });
  for (const to of others) runtime.dispatch({ type: 'press-moved', pointer: pointer(runtime, to) });
}

function draw(runtime: FakeRuntime, ...way: readonly [Vec, ...Vec[]]): void {
  begin(runtime, ...way);
  runtime.dispatch({ type: 'press-ended', pointer: pointer(runtime, way.at(-1) ?? way[0]) });
}

describe('a stroke that the guard against folds stops', () => {
  const way = [120, 124, 128, 132, 140, 150, 160, 170, 180, 200].map((x): Vec => [x, 150]) as [Vec, ...Vec[]];

  it('is shown like a stopped handle, until it continues or ends', () => {
    const runtime = brushing(400, 300);
    runtime.dispatch({ type: 'fold-guard-switched', on: true });
    const isStopped = () => viewModel(runtime.state, en).holding;
    const move = (x: number) =>
      runtime.dispatch({ type: 'press-moved', pointer: pointer(runtime, [x, 150]) });
    begin(runtime, [120, 150], [132, 150]);
    expect(isStopped()).toBe(false);
    for (const [x] of way.slice(4)) move(x);
    expect(isStopped()).toBe(true);
    // Beyond the fold there is room.
    move(220);
    expect(isStopped()).toBe(false);
    move(240);
    expect(isStopped()).toBe(true);
    runtime.dispatch({ type: 'press-ended', pointer: pointer(runtime, [240, 150]) });
    expect(isStopped()).toBe(false);
  });

  it('shows nothing without the guard', () => {
    const runtime = brushing(400, 300);
    begin(runtime, ...way);
    expect(viewModel(runtime.state, en).holding).toBe(false);
  });
});

describe('thousands of strokes', () => {
  const STROKES = 5000;

  it('keep the project, the history, what is stored, and the work of each bounded', () => {
    const runtime = brushing(400, 60);
    runtime.dispatch({ type: 'fold-guard-switched', on: true });
    const displacement = () => projectOf(runtime.state).displacement;
    const numbers = () => numbersOf(displacement() ?? { width: 0, height: 0, values: '' });
    /** How many numbers of the displacement each stroke changes. */
    const changes: number[] = [];
    const files: number[] = [];
    const stored: number[] = [];
    for (let k = 0; k < STROKES; k++) {
      const before = numbers();
      const [x, y] = [60 + ((67 * k) % 280), 25 + ((11 * k) % 20)];
      const turn = 2.4 * k;
      draw(runtime, [x, y], [x + 6 * Math.cos(turn), y + 6 * Math.sin(turn)]);
      changes.push(numbers().reduce((sum, number, at) => sum + Number(number !== (before[at] ?? 0)), 0));
      if (k % 1000 === 0 || k === STROKES - 1) {
        files.push(JSON.stringify(projectOf(runtime.state)).length);
        stored.push(JSON.stringify(packed(workOf(runtime.state))).length);
      }
    }
    const { width = 0, height = 0, values = '' } = displacement() ?? {};
    // The file has the same field after each stroke: two numbers of 16 bits for each control point.
    expect(new Set(files).size).toBe(1);
    expect(values.length).toBe(4 * Math.ceil((4 * width * height) / 3));
    // The history drops its oldest steps, and the store has one whole field and differences.
    const { past, future } = runtime.state.document.history;
    expect([past.length, future.length]).toEqual([500, 0]);
    expect(Math.max(...stored)).toBeLessThan(500 * 1500 + 2 * values.length);
    expect(stored.at(-1)).toBeLessThan(1.1 * (stored[1] ?? 0));
    const sum = (counts: readonly number[]) => counts.reduce((a, b) => a + b, 0);
    expect(sum(changes.slice(0, 100))).toBeGreaterThan(0);
    expect(sum(changes.slice(-100))).toBeGreaterThan(0);
    expect(sum(changes.slice(-100))).toBeLessThanOrEqual(sum(changes.slice(0, 100)));
  }, 240_000);
});
