import { describe, expect, it } from 'vitest';
import { newProject } from '../document/document';
import { timeline } from '../document/history';
import type { Project } from '../document/project';
import { C2WarpError } from '../error';
import { toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { en } from '../texts/en';
import { drawingOf } from '../tools/machine';
import type { CommandName } from './commands';
import { englishNotice } from './english';
import type { EditorEvent } from './events';
import { FakeRuntime, PAGE, testPicture } from './fake_runtime';
import { among, randomOf } from './random';
import { pendingKey } from './solution';
import { documentOf, projectOf, selectionOf } from './state';
import { snapshotOf } from './update/autosave';
import { viewModel } from './view_model';

type Random = () => number;

const picture = testPicture('new.png');

/** Bent within the picture's frame, so that the same camera fits it. */
const bent: Project = {
  ...newProject({ src: picture.name, width: picture.width, height: picture.height }, null),
  handles: [
    { id: 'a', kind: 'point', rest: [80, 80], posed: [110, 90] },
    { id: 'b', kind: 'point', rest: [300, 200], posed: [270, 190] },
  ],
};

/** The camera that fits the picture. */
const { camera } = (() => {
  const runtime = new FakeRuntime();
  runtime.open(picture);
  return runtime.state.view;
})();

const pointer = (stage: Vec) => ({ stage, shift: false, alt: false, free: false, coarse: false });

/** Sends input whose places are image pixels, where the person sees them or will see them. */
function send(runtime: FakeRuntime, event: EditorEvent): void {
  const { state } = runtime;
  const view = state.picture?.name === picture.name ? state.view.camera : camera;
  if (!('pointer' in event) || !event.pointer) runtime.dispatch(event);
  else runtime.dispatch({ ...event, pointer: pointer(toStage(view, event.pointer.stage)) });
}

/** A click, or a drag over some places, image pixels. */
const press = (...places: readonly Vec[]): readonly EditorEvent[] => [
  { type: 'press-began', pointer: pointer(places[0] ?? [0, 0]), pans: false },
  ...places.slice(1).map((at): EditorEvent => ({ type: 'press-moved', pointer: pointer(at) })),
  { type: 'press-ended', pointer: pointer(places.at(-1) ?? [0, 0]) },
];

const run = (command: CommandName): EditorEvent => ({ type: 'command-run', command });

const placeOf = (random: Random): Vec => [Math.round(20 + 360 * random()), Math.round(20 + 260 * random())];

const toolOf = (random: Random): EditorEvent =>
  run(among(['select', 'point', 'point', 'bar', 'polygon', 'lasso'] as const, random));

/** Something that a person does. */
function deed(random: Random): readonly EditorEvent[] {
  const kind = random();
  if (kind < 0.45) return press(placeOf(random));
  if (kind < 0.55) return press(placeOf(random), placeOf(random), placeOf(random));
  if (kind < 0.7) return [toolOf(random)];
  if (kind < 0.78) return [{ type: 'place-pressed' }];
  // With the select tool and nothing selected, arrows move the view.
  if (kind < 0.84) return [run('point'), { type: 'arrow-pressed', by: [10, 1] }];
  if (kind < 0.88) return [{ type: 'turn-pressed', degrees: 15, scale: 1 }];
  return [run(among(['undo', 'redo', 'bail', 'remove', 'select-all', 'forward', 'mirror'], random))];
}

const deeds = (random: Random): readonly EditorEvent[] => [
  toolOf(random),
  ...Array.from({ length: 8 }, () => deed(random)).flat(),
];

interface Opening {
  /** What was on the stage before. */
  readonly before: 'nothing' | 'picture' | 'stored work';
  readonly project: Project | null;
}

/** An editor whose picture was just requested, and the replies that open it. */
function asked({ before, project }: Opening): [FakeRuntime, readonly (() => void)[]] {
  const runtime = new FakeRuntime();
  runtime.dispatch({ type: 'stage-resized', size: { width: 400, height: 300 }, typing: false });
  const read = () => runtime.read(picture, before === 'stored work' ? null : project);
  if (before === 'stored work') {
    const last = new FakeRuntime();
    last.open(picture);
    if (project) last.dispatch({ type: 'project-adopted', project });
    runtime.dispatch({ type: 'autosave-key-set', key: 'work' });
    runtime.dispatch({ type: 'started', work: null });
    const work = snapshotOf(last.state);
    const stored = work && { work, recent: [] };
    return [runtime, [() => runtime.dispatch({ type: 'storage-read', stored }), read, () => runtime.solve()]];
  }
  runtime.dispatch({ type: 'started', work: null });
  if (before === 'picture') runtime.open(testPicture('old.png'));
  runtime.dispatch({ type: 'files-received', files: [{ name: picture.name, file: picture.file }] });
  return [runtime, [read, () => runtime.solve()]];
}

/** A person's work on the picture. */
function made(runtime: FakeRuntime) {
  while (pendingKey(runtime.state.solution) !== null) runtime.solve();
  const { state } = runtime;
  const { history } = state.document;
  return {
    picture: state.picture?.name,
    handles: projectOf(state).handles,
    domain: projectOf(state).domain,
    steps: history.past.map(({ label }) => label),
    documents: timeline(history).values.length,
    selection: selectionOf(state),
    tool: state.tools.tool,
    drawing: drawingOf(state.tools),
  };
}

/** Sends the input; the answers come in their order, in between. */
function mixed(
  runtime: FakeRuntime,
  answers: readonly (() => void)[],
  input: readonly EditorEvent[],
  random: Random,
) {
  const times = answers.map(() => Math.floor(random() * (input.length + 1))).sort((a, b) => a - b);
  for (let at = 0; at <= input.length; at++) {
    for (const [k, answer] of answers.entries()) if (times[k] === at) answer();
    const event = input[at];
    if (event) send(runtime, event);
  }
}

const OPENINGS: readonly Opening[] = (['nothing', 'picture', 'stored work'] as const).flatMap((before) =>
  [null, bent].map((project) => ({ before, project })),
);

describe('input while a picture is being opened', () => {
  it('has the result of the same input after that, in 3,000 random sequences', () => {
    for (let seed = 0; seed < 3000; seed++) {
      const random = randomOf(seed);
      const opening = among(OPENINGS, random);
      const input = deeds(random);
      const [late, before] = asked(opening);
      for (const answer of before) answer();
      for (const event of input) send(late, event);
      const [early, answers] = asked(opening);
      mixed(early, answers, input, random);
      expect(early.state.waiting, `seed ${seed}`).toEqual([]);
      expect(made(early), `seed ${seed}, ${opening.before}`).toEqual(made(late));
    }
  }, 120_000);

  it('shows tools and presses at once, and that the picture is awaited', () => {
    const [runtime] = asked({ before: 'picture', project: null });
    runtime.dispatch(run('lasso'));
    for (const event of press([50, 50])) send(runtime, event);
    const waitingPlaces = [toStage(camera, [50, 50])];
    expect(viewModel(runtime.state, en)).toMatchObject({ tool: 'lasso', awaiting: true, waitingPlaces });
  });

  it('is dropped with an unreadable picture, and does not change the previous one', () => {
    const [runtime] = asked({ before: 'picture', project: null });
    for (const event of [run('point'), ...press([50, 50])]) send(runtime, event);
    runtime.failRead(new C2WarpError('picture', 'no picture'));
    expect(englishNotice(runtime.state)?.text).toBe('no picture');
    expect(runtime.state.waiting).toEqual([]);
    expect(documentOf(runtime.state).project).toMatchObject({ image: { src: 'old.png' }, handles: [] });
  });

  it('is for the newest picture that a person has asked for', () => {
    const [runtime] = asked({ before: 'nothing', project: null });
    for (const event of [run('point'), ...press([50, 50])]) send(runtime, event);
    runtime.dispatch({ type: 'files-received', files: [{ name: 'b.png', file: picture.file }] });
    for (const event of press([90, 90])) send(runtime, event);
    runtime.read(testPicture('b.png'));
    runtime.solve();
    expect(projectOf(runtime.state).handles.map(({ rest }) => rest)).toEqual([[90, 90]]);
  });

  it('is for the shown picture while the page loads another one', () => {
    const runtime = new FakeRuntime(PAGE);
    runtime.open();
    runtime.dispatch({ type: 'load-asked', reply: 1, source: 'b.png', project: null, notice: false });
    for (const event of [run('point'), ...press([50, 50])]) send(runtime, event);
    expect(projectOf(runtime.state).handles).toHaveLength(1);
  });

  it('leaves out commands that ask for a file, which browsers allow only at once', () => {
    const [runtime] = asked({ before: 'picture', project: bent });
    const before = runtime.effects.length;
    for (const command of ['lasso', 'save', 'save-whole', 'export-whole', 'export-as'] as const)
      runtime.dispatch(run(command));
    expect(runtime.state.waiting).toEqual([run('lasso')]);
    const types = runtime.effects.slice(before).map(({ type }) => type);
    expect(types).toEqual(expect.arrayContaining(['save-project', 'export', 'toggle-export']));
    expect(types.filter((type) => type === 'save-project')).toHaveLength(2);
  });

  it('ends a drag that began before the picture was asked for', () => {
    const runtime = new FakeRuntime(PAGE);
    runtime.open();
    const [began, ended] = press([50, 50]);
    if (began) send(runtime, began);
    runtime.dispatch({ type: 'files-received', files: [{ name: 'b.png', file: picture.file }] });
    if (ended) send(runtime, ended);
    expect(projectOf(runtime.state).handles).toHaveLength(1);
    expect(runtime.state.waiting).toEqual([]);
  });
});

describe('a refused picture', () => {
  it('gives the tool back that was chosen for its predecessor', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    runtime.dispatch(run('select'));
    runtime.dispatch({ type: 'files-received', files: [{ name: 'b.png', file: picture.file }] });
    runtime.read(testPicture('b.png'));
    expect(runtime.state.tools.tool).toBe('point');
    runtime.refuse(new C2WarpError('nothing-opaque', 'nothing'));
    expect(runtime.state.tools.tool).toBe('select');
  });
});
