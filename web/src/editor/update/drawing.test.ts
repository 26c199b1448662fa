import { beforeEach, describe, expect, it } from 'vitest';
import { C2WarpError } from '../../error';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { draftOf, drawingOf, type ToolName } from '../../tools/machine';
import type { Draft } from '../../tools/state';
import type { CommandName } from '../commands';
import { englishNotice } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { projectOf, selectionOf } from '../state';
import { snapshotOf } from './autosave';

const PLACES = [
  [100, 100],
  [200, 100],
  [200, 200],
] as const;
const KINDS = ['bar', 'polygon', 'lasso'] as const satisfies readonly ToolName[];

let runtime: FakeRuntime;
const run = (command: CommandName) => runtime.dispatch({ type: 'command-run', command });
const pointer = (at: Vec) => ({
  stage: toStage(runtime.state.view.camera, at),
  shift: false,
  alt: false,
  free: false,
  coarse: false,
});

function drag(from: Vec, to: Vec): void {
  runtime.dispatch({ type: 'press-began', pointer: pointer(from), pans: false });
  if (to !== from) runtime.dispatch({ type: 'press-moved', pointer: pointer(to) });
  runtime.dispatch({ type: 'press-ended', pointer: pointer(to) });
}

function draw(kind: Draft['kind'], places: readonly Vec[] = PLACES): void {
  run(kind);
  for (const place of places) drag(place, place);
}

const drawing = () => draftOf(runtime.state.tools);
const refuseBar = () => runtime.refuse(new C2WarpError('handle-outside', 'outside', { handles: ['bar-1'] }));

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
});

describe.each(KINDS)('a %s that is being drawn', (kind) => {
  it('ends with its tool, and the notice brings it back', () => {
    draw(kind);
    const corners = drawing()?.corners;
    run('hand');
    expect(drawing()).toBeNull();
    expect(snapshotOf(runtime.state)?.drawings).toEqual([]);
    expect(englishNotice(runtime.state)).toMatchObject({
      text: 'The drawing has ended.',
      action: { label: 'Continue drawing' },
    });
    runtime.dispatch({ type: 'notice-answered' });
    expect(runtime.state.tools.tool).toBe(kind);
    expect(drawing()?.corners).toEqual(corners);
    expect(englishNotice(runtime.state)).toBeNull();
  });

  it.each(['select', 'point', 'bar', 'polygon', 'lasso', 'brush', 'hand', 'lens'] as const)(
    'leaves nothing to %s',
    (tool) => {
      if (tool === kind) return;
      draw(kind);
      run(tool);
      expect(drawing()).toBeNull();
      run(kind);
      expect(drawing()).toBeNull();
      drag([50, 50], [50, 50]);
      expect(drawing()?.corners).toHaveLength(1);
    },
  );

  it('ends where a handle is selected in a list', () => {
    run('point');
    drag([300, 200], [300, 200]);
    draw(kind);
    runtime.dispatch({ type: 'handles-selected', ids: ['handle-1'] });
    expect(drawing()).toBeNull();
    expect(runtime.state.tools.tool).toBe('select');
    run('remove');
    expect(projectOf(runtime.state).handles).toEqual([]);
  });

  it('ends with Escape, undo of its corners, and another picture', () => {
    draw(kind);
    run('bail');
    expect(drawing()).toBeNull();
    expect(englishNotice(runtime.state)).toBeNull();
    draw(kind);
    for (const _ of PLACES) run('undo');
    expect(drawing()).toBeNull();
    draw(kind);
    const picture = testPicture('dog.png');
    runtime.dispatch({ type: 'files-received', files: [{ name: picture.name, file: picture.file }] });
    runtime.read(picture);
    runtime.solve();
    expect(runtime.state.picture?.name).toBe('dog.png');
    expect(drawing()).toBeNull();
  });

  it('is stored, and comes back with its tool', () => {
    draw(kind);
    const work = snapshotOf(runtime.state);
    expect(work?.drawings).toMatchObject([{ kind }]);
    runtime = new FakeRuntime();
    runtime.dispatch({ type: 'autosave-key-set', key: 'here' });
    runtime.dispatch({ type: 'started', work });
    runtime.read(testPicture());
    runtime.solve();
    expect(runtime.state.tools.tool).toBe(kind);
    expect(drawing()?.corners).toEqual(work?.drawings?.[0]?.corners);
  });
});

it('the notice is about the last of several drawings', () => {
  draw('bar');
  draw('polygon');
  run('select');
  runtime.dispatch({ type: 'notice-answered' });
  expect(drawing()?.kind).toBe('polygon');
});

it('a single corner ends with its tool without a notice', () => {
  draw('polygon', [[100, 100]]);
  run('select');
  expect(drawing()).toBeNull();
  expect(englishNotice(runtime.state)).toBeNull();
});

describe('a bar that the solver refuses', () => {
  beforeEach(() => {
    run('bar');
    drag([10, 10], [90, 10]);
    refuseBar();
    runtime.solve();
  });

  it('leaves a clean stage, and the next bar has corners of its own', () => {
    expect(projectOf(runtime.state).handles).toEqual([]);
    expect(drawingOf(runtime.state.tools)).toBeNull();
    expect(englishNotice(runtime.state)?.kind).toBe('error');
    drag([100, 100], [200, 100]);
    expect(projectOf(runtime.state).handles).toMatchObject([
      {
        id: 'bar-1',
        posed: [
          [100, 100],
          [200, 100],
        ],
      },
    ]);
  });

  it('continues by its notice, also after undo and with another tool in hand', () => {
    run('point');
    drag([200, 200], [200, 200]);
    run('undo');
    runtime.dispatch({ type: 'notice-answered' });
    expect(runtime.state.tools.tool).toBe('bar');
    expect(selectionOf(runtime.state)).toEqual([]);
    expect(drawing()?.corners).toHaveLength(2);
  });
});

it('a drawing whose solve the person cancels can continue', () => {
  run('bar');
  drag([10, 10], [90, 10]);
  runtime.dispatch({ type: 'task-cancelled', task: 'solve' });
  expect(projectOf(runtime.state).handles).toEqual([]);
  expect(drawing()).toBeNull();
  runtime.dispatch({ type: 'notice-answered' });
  expect(drawing()?.corners).toHaveLength(2);
});
