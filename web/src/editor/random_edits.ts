/** Random sequences of events with a fixed seed, for tests. */
import { C2WarpError } from '../error';
import { COMMANDS, type CommandName } from './commands';
import type { EditorEvent } from './events';
import { FakeRuntime, PAGE, testPicture } from './fake_runtime';
import { among, randomOf } from './random';
import { documentOf, projectOf } from './state';

type Step = (runtime: FakeRuntime, random: () => number) => void;

const pointerOf = (random: () => number) => ({
  stage: [Math.round(random() * 420 - 10), Math.round(random() * 320 - 10)] as const,
  shift: random() < 0.2,
  alt: random() < 0.1,
  free: random() < 0.1,
  coarse: random() < 0.2,
});

const event =
  (make: (random: () => number) => EditorEvent): Step =>
  (runtime, random) =>
    runtime.dispatch(make(random));

const COMMAND_NAMES = Object.keys(COMMANDS) as CommandName[];

/** Everything that people, the page, the solver and the storage can do. */
const STEPS: readonly Step[] = [
  ...Array<Step>(6).fill(
    event((random) => ({ type: 'press-began', pointer: pointerOf(random), pans: random() < 0.1 })),
  ),
  ...Array<Step>(8).fill(event((random) => ({ type: 'press-moved', pointer: pointerOf(random) }))),
  ...Array<Step>(8).fill(event((random) => ({ type: 'press-ended', pointer: pointerOf(random) }))),
  ...Array<Step>(8).fill(event((random) => ({ type: 'command-run', command: among(COMMAND_NAMES, random) }))),
  event(() => ({ type: 'press-cancelled' })),
  event((random) => ({ type: 'double-pressed', pointer: pointerOf(random) })),
  event((random) => ({ type: 'pointer-hovered', pointer: random() < 0.2 ? null : pointerOf(random) })),
  event((random) => ({ type: 'menu-asked', pointer: pointerOf(random), resting: random() < 0.5 })),
  event((random) => ({ type: 'menu-command-run', command: among([...COMMAND_NAMES, null], random) })),
  event((random) => ({ type: 'arrow-pressed', by: [Math.round(random() * 20 - 10), 1] })),
  event((random) => ({ type: 'turn-pressed', degrees: random() * 30, scale: random() < 0.5 ? 1 : 1.1 })),
  event(() => ({ type: 'place-pressed' })),
  event(() => ({ type: 'menu-key-pressed' })),
  event((random) => ({ type: 'space-held', held: random() < 0.5 })),
  event((random) => ({
    type: 'field-set',
    field: among(['x', 'y', 'rotation', 'scale', 'depth'] as const, random),
    change: random() < 0.5 ? { to: 1 + random() * 90 } : { by: 1, least: 0.01, most: 2000 },
  })),
  event((random) => ({ type: 'corner-field-set', axis: 0, change: { to: random() * 300 } })),
  event((random) => ({ type: 'automatic-rotation-switched', on: random() < 0.5 })),
  event((random) => ({ type: 'pose-mode-chosen', mode: among(['rigid', 'harmonic'] as const, random) })),
  event((random) => ({ type: 'detail-chosen', detail: among(['coarse', 'fine'] as const, random) })),
  event((random) => ({ type: 'boundary-switched', held: random() < 0.5 })),
  event((random) => ({ type: 'edges-switched', on: random() < 0.5 })),
  event((random) => ({ type: 'fill-switched', on: random() < 0.5 })),
  event((random) => ({ type: 'fold-guard-switched', on: random() < 0.5 })),
  event((random) => ({ type: 'snapping-switched', on: random() < 0.7 })),
  event((random) => ({ type: 'alt-held', held: random() < 0.5 })),
  event((random) => ({ type: 'name-typed', name: random() < 0.5 ? 'head' : 'Nose' })),
  event((random) => ({ type: 'name-given', name: random() < 0.5 ? 'Nose' : '', keyed: random() < 0.5 })),
  event((random) => ({ type: 'overlays-opened', open: random() < 0.5, keyed: random() < 0.5 })),
  event((random) => ({ type: 'overlay-switched', overlay: 'cells', on: random() < 0.5 })),
  event((random) => ({ type: 'timeline-opened', open: random() < 0.8 })),
  event((random) => ({
    type: 'clip-added',
    preset: among(['sway', 'breathe', 'wave', null] as const, random),
  })),
  event((random) => ({ type: 'clip-chosen', name: among(['clip', 'sway', 'wave 2'], random) })),
  event((random) => ({ type: 'clip-duration-set', change: { to: random() * 4 } })),
  event((random) => ({
    type: 'clip-loop-chosen',
    loop: among(['repeat', 'alternate', 'none'] as const, random),
  })),
  event((random) => ({ type: 'playhead-moved', time: random() * 3 - 0.5 })),
  event((random) => ({ type: 'clock-ticked', seconds: random() / 10 })),
  event((random) => ({ type: 'record-held', held: random() < 0.5 })),
  event((random) => ({ type: 'keys-dragged', by: random() - 0.5, ended: random() < 0.7 })),
  (runtime, random) => {
    const tracks = projectOf(runtime.state).clips?.[0]?.tracks ?? [];
    const keys = tracks.flatMap(({ handle, keys }) => keys.map(({ time }) => ({ handle, time })));
    runtime.dispatch({ type: 'keys-selected', keys: keys.filter(() => random() < 0.5) });
  },
  event((random) => ({
    type: 'keys-walked',
    by: among(
      [
        [1, 0],
        [-1, 0],
        [0, 1],
      ] as const,
      random,
    ),
    extends: random() < 0.5,
  })),
  event((random) => ({ type: among(['selection-copied', 'clip-duplicated', 'clip-removed'], random) })),
  event(() => ({ type: 'drawing-finished' })),
  event(() => ({ type: 'lasso-removed' })),
  event(() => ({ type: 'notice-answered' })),
  event(() => ({ type: 'task-cancelled', task: 'solve' })),
  event((random) => ({
    type: 'timer-elapsed',
    timer: among(['notice', 'solve-patience', 'fill-patience', 'merge-end', 'pose-check'] as const, random),
  })),
  event((random) => ({
    type: 'page-changed',
    page: { ...PAGE, readonly: random() < 0.1, posable: random() < 0.1 },
  })),
  event(() => ({ type: 'page-changed', page: PAGE })),
  event((random) => ({ type: 'stage-resized', size: { width: random() * 500, height: 300 }, typing: false })),
  event((random) => ({ type: 'corner-focused', corner: { id: 'bar-1', index: random() < 0.5 ? 0 : 1 } })),
  event(() => ({ type: 'stage-focused' })),
  event((random) => ({
    type: 'files-received',
    files: [{ name: among(['a.png', 'b.json'], random), file: testPicture().file }],
  })),
  event(() => ({ type: 'retry-asked' })),
  (runtime, random) => {
    const handles = documentOf(runtime.state).project.handles.map((handle) => ({
      ...handle,
      depth: random(),
    }));
    runtime.dispatch({ type: 'handles-posed', handles });
    runtime.posedByPage ||= handles.length > 0;
  },
  (runtime, random) => runtime.read(testPicture(among(['a.png', 'b.png'], random))),
  (runtime) => runtime.failRead(new C2WarpError('picture', 'no picture')),
  ...Array<Step>(6).fill((runtime) => runtime.solve()),
  (runtime, random) => {
    const named = documentOf(runtime.state)
      .project.handles.slice(-1)
      .map(({ id }) => id);
    runtime.refuse(new C2WarpError('handle-outside', 'outside', { handles: random() < 0.7 ? named : [] }));
  },
  (runtime) => runtime.refuse(new C2WarpError('engine', 'failed'), true),
];

/** Ends the open step, so that undo takes back a whole step. */
export function settle(runtime: FakeRuntime): void {
  runtime.dispatch({ type: 'page-changed', page: PAGE });
  runtime.dispatch({ type: 'press-cancelled' });
  runtime.dispatch({ type: 'command-run', command: 'bail' });
  for (let answers = 0; answers < 4; answers++) runtime.solve();
}

/** An editor after a random sequence of 20 events. */
export function editedAtRandom(seed: number): FakeRuntime {
  const random = randomOf(seed);
  const runtime = new FakeRuntime();
  runtime.open();
  for (let count = 0; count < 20; count++) among(STEPS, random)(runtime, random);
  return runtime;
}
