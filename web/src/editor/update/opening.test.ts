import { describe, expect, it } from 'vitest';
import { addHandle } from '../../document/edits';
import type { Project } from '../../document/project';
import { C2WarpError } from '../../error';
import type { EditorEffect } from '../effects';
import { englishNotice, inEnglish } from '../english';
import { FakeRuntime, PAGE, testFile, testPicture } from '../fake_runtime';
import type { NamedFile } from '../picture';
import { documentOf, projectOf } from '../state';
import type { WorkSnapshot } from '../work';
import { snapshotOf } from './autosave';

const cat = testPicture('cat.png');
const dog = testPicture('dog.png');
const refusal = new C2WarpError('handle-outside', 'outside');
const engine = new C2WarpError('engine', 'the solver failed');

const opened = (): FakeRuntime => {
  const runtime = new FakeRuntime();
  runtime.open(cat);
  return runtime;
};
const file = (name: string, type = '') => ({ name, file: { size: 1, type } });
const drop = (runtime: FakeRuntime, ...names: readonly string[]) => {
  const files = (names.length > 0 ? names : ['dog.png']).map((name) => ({ name, file: testFile(name) }));
  runtime.dispatch({ type: 'files-received', files });
};
const placeHandle = (runtime: FakeRuntime, id = 'a') => {
  const handle = { id, kind: 'point', rest: [50, 50], posed: [60, 50] } as const;
  runtime.dispatch({ type: 'handle-added', handle });
  runtime.solve();
};
const withHandle = (project: Project): Project =>
  addHandle({ project, selection: [] }, { id: 'far', kind: 'point', rest: [900, 9], posed: [900, 9] })
    .project;
const effects = <T extends EditorEffect['type']>(runtime: FakeRuntime, type: T) =>
  runtime.effects.filter((effect) => effect.type === type) as Extract<EditorEffect, { readonly type: T }>[];
const workOn = (name: string, runtime: FakeRuntime): WorkSnapshot => {
  const work = snapshotOf(runtime.state);
  if (!work) throw new Error('nothing is open');
  return { ...work, name };
};

describe('opening a picture', () => {
  it('reads, then tries, then opens', () => {
    const runtime = new FakeRuntime();
    drop(runtime, 'cat.png');
    expect(runtime.state.opening.reading).not.toBeNull();
    runtime.read(cat);
    expect(runtime.state.opening.trial).not.toBeNull();
    expect(runtime.state.picture).toBe(cat);
    runtime.solve();
    expect(runtime.state.opening).toMatchObject({ reading: null, trial: null });
  });

  it('asks the person before something from outside takes the place of a picture', () => {
    const offer = (runtime: FakeRuntime) => {
      const files = [{ name: 'dog.png', file: testFile('dog.png') }];
      runtime.dispatch({ type: 'offered', names: ['dog.png'], opening: { type: 'files-received', files } });
    };
    const empty = new FakeRuntime();
    offer(empty);
    expect(empty.state.opening.reading?.name).toBe('dog.png');
    const runtime = opened();
    offer(runtime);
    expect(runtime.state.opening.reading).toBeNull();
    expect(englishNotice(runtime.state)?.text).toBe('A link or another program wants to open dog.png.');
    runtime.dispatch({ type: 'notice-answered', other: false });
    expect(runtime.state.opening.reading?.name).toBe('dog.png');
  });

  it('says that only the first frame of an animation is open', () => {
    const runtime = new FakeRuntime();
    drop(runtime, 'run.gif');
    runtime.read({ ...testPicture('run.gif'), moves: true });
    runtime.solve();
    expect(englishNotice(runtime.state)?.text).toBe('run.gif is animated. Only its first frame was opened.');
  });

  it('keeps the open picture when reading fails', () => {
    const runtime = opened();
    drop(runtime);
    runtime.failRead(new C2WarpError('picture', 'dog.png: no picture'));
    expect(runtime.state.picture).toBe(cat);
    expect(englishNotice(runtime.state)?.text).toContain('no picture');
  });

  it('returns to the picture before when the solver refuses the new one', () => {
    const runtime = opened();
    placeHandle(runtime);
    const before = documentOf(runtime.state).project;
    drop(runtime);
    runtime.read(dog);
    runtime.refuse(refusal);
    expect(runtime.state.picture).toBe(cat);
    expect(projectOf(runtime.state)).toEqual(before);
    expect(englishNotice(runtime.state)?.kind).toBe('error');
  });

  it('opens the picture without its handles when there is none to return to', () => {
    const runtime = new FakeRuntime();
    drop(runtime, 'cat.png');
    runtime.read(
      cat,
      withHandle({ ...projectOf(runtime.state), image: { src: '', width: 400, height: 300 } }),
    );
    runtime.refuse(refusal);
    expect(runtime.state.picture).toBe(cat);
    expect(projectOf(runtime.state).handles).toEqual([]);
  });

  it('closes the first picture when the solver refuses it without a handle', () => {
    const runtime = new FakeRuntime();
    drop(runtime, 'cat.png');
    runtime.read(cat);
    runtime.refuse(new C2WarpError('nothing-opaque', 'alpha'));
    expect(runtime.state.picture).toBeNull();
    expect(englishNotice(runtime.state)?.text).toContain('cat.png: no part of this picture');
  });

  it('refuses a project for a picture of another size', () => {
    const runtime = opened();
    drop(runtime);
    runtime.read(dog, { ...projectOf(runtime.state), image: { src: '', width: 1, height: 1 } });
    expect(runtime.state.picture).toBe(cat);
    expect(englishNotice(runtime.state)?.text).toContain('1 × 1 px');
  });

  it('keeps the first picture on the stage and offers a retry when the solver fails', () => {
    const runtime = new FakeRuntime();
    drop(runtime, 'cat.png');
    runtime.read(cat);
    runtime.refuse(engine, true);
    expect(runtime.state.picture).toBe(cat);
    expect(englishNotice(runtime.state)?.action?.label).toBe('Try again');
    runtime.dispatch({ type: 'notice-answered' });
    runtime.read(testPicture('cat.png'));
    runtime.solve();
    expect(runtime.state.solution.shown).not.toBeNull();
  });
});

describe('a newer request', () => {
  it('supersedes one that is being read', () => {
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'load-asked', reply: 1, source: 'cat.png', project: null, notice: false });
    runtime.dispatch({ type: 'load-asked', reply: 2, source: 'dog.png', project: null, notice: false });
    expect(effects(runtime, 'settle-load')).toMatchObject([{ reply: 1, error: 'superseded' }]);
    runtime.read(dog);
    runtime.solve();
    expect(effects(runtime, 'settle-load').at(-1)).toMatchObject({ reply: 2, error: null });
    expect(runtime.notified).toContain('load');
  });

  it('supersedes a trial and inherits its way back', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'load-asked', reply: 1, source: 'dog.png', project: null, notice: false });
    runtime.read(dog);
    drop(runtime, 'fox.png');
    runtime.read(testPicture('fox.png'));
    expect(effects(runtime, 'settle-load')).toMatchObject([{ reply: 1, error: 'superseded' }]);
    runtime.refuse(refusal);
    expect(runtime.state.picture).toBe(cat);
  });
});

describe('edited work', () => {
  it('is parked when another picture opens, and restored later', () => {
    const runtime = opened();
    placeHandle(runtime);
    drop(runtime);
    runtime.read(dog);
    runtime.solve();
    expect(englishNotice(runtime.state)?.action?.label).toBe('Use this rig');
    expect(englishNotice(runtime.state)?.other?.label).toBe('Back to cat.png');
    runtime.dispatch({ type: 'notice-answered', other: true });
    runtime.read(testPicture('cat.png'));
    runtime.solve();
    expect(projectOf(runtime.state).handles).toHaveLength(1);
    expect(runtime.state.opening.recent).toEqual([]);
  });

  it('is parked with the drag that is in hand', () => {
    const runtime = opened();
    const at = (x: number) => ({
      stage: [x, 150] as const,
      shift: false,
      alt: false,
      free: false,
      coarse: false,
    });
    runtime.dispatch({ type: 'command-run', command: 'point' });
    runtime.dispatch({ type: 'press-began', pointer: at(200), pans: false });
    runtime.dispatch({ type: 'press-moved', pointer: at(260) });
    drop(runtime);
    runtime.read(dog);
    runtime.solve();
    runtime.dispatch({ type: 'press-ended', pointer: at(260) });
    const [work] = runtime.state.opening.recent;
    expect(work?.record.past.map(({ label }) => inEnglish(label))).toEqual(['Add handle']);
    expect(projectOf(runtime.state).handles).toEqual([]);
  });

  it('is not parked when it was never edited', () => {
    const runtime = opened();
    drop(runtime);
    runtime.read(dog);
    runtime.solve();
    expect(runtime.state.opening.recent).toEqual([]);
  });
});

describe('a project file alone', () => {
  it('becomes a step of the open picture if the size fits', () => {
    const runtime = opened();
    drop(runtime, 'pose.json');
    runtime.read(null, { ...projectOf(runtime.state), samples: 2000 });
    expect(projectOf(runtime.state).samples).toBe(2000);
  });

  const waiting = (src = 'poses/cat.png') => {
    const runtime = new FakeRuntime();
    drop(runtime, 'pose.json');
    const image = { src, width: 400, height: 300 };
    runtime.read(null, { ...projectOf(runtime.state), image, samples: 2000 });
    return runtime;
  };
  const opens = (runtime: FakeRuntime, name: string, project: Project | null = null) => {
    drop(runtime, ...(project ? [name, 'other.json'] : [name]));
    runtime.read(testPicture(name), project);
    runtime.solve();
  };
  const asks = ({ state }: FakeRuntime) => englishNotice(state)?.action?.label === 'Open picture';
  const other = { ...projectOf(opened().state), samples: 3000 };

  it('waits for its picture, and goes with it', () => {
    const runtime = waiting();
    expect(englishNotice(runtime.state)?.text).toContain('pose.json belongs to the picture poses/cat.png');
    opens(runtime, 'cat.png');
    expect(projectOf(runtime.state).samples).toBe(2000);
    expect(asks(runtime)).toBe(false);
  });

  it('goes with any picture of its size if it names none', () => {
    const runtime = waiting('');
    opens(runtime, 'dog.png');
    expect(projectOf(runtime.state).samples).toBe(2000);
  });

  it('does not go with another picture of the same size, and waits on', () => {
    const runtime = waiting();
    opens(runtime, 'dog.png');
    expect(projectOf(runtime.state).samples).not.toBe(2000);
    expect(asks(runtime)).toBe(true);
    opens(runtime, 'cat.png');
    expect(projectOf(runtime.state).samples).toBe(2000);
  });

  it('does not go with a picture of the page', () => {
    const runtime = waiting();
    runtime.dispatch({ type: 'load-asked', reply: 1, source: 'cat.png', project: null, notice: false });
    runtime.read(cat);
    runtime.solve();
    expect(projectOf(runtime.state).samples).not.toBe(2000);
    expect(asks(runtime)).toBe(true);
  });

  it('stops waiting once a project is opened with its picture', () => {
    const runtime = waiting();
    opens(runtime, 'cat.png', other);
    expect(projectOf(runtime.state).samples).toBe(3000);
    expect(asks(runtime)).toBe(false);
    opens(runtime, 'cat.png');
    expect(projectOf(runtime.state).samples).toBe(10000);
  });

  it('waits on when the project that came with its picture is refused', () => {
    const runtime = waiting();
    drop(runtime, 'cat.png', 'other.json');
    runtime.read(cat, withHandle(other));
    runtime.refuse(refusal);
    opens(runtime, 'cat.png');
    expect(projectOf(runtime.state).samples).toBe(2000);
  });

  it('waits no more once another is adopted', () => {
    const runtime = opened();
    drop(runtime, 'pose.json');
    const image = { src: 'fox.png', width: 9, height: 9 };
    runtime.read(null, { ...projectOf(runtime.state), image });
    expect(asks(runtime)).toBe(true);
    drop(runtime, 'other.json');
    runtime.read(null, other);
    runtime.solve();
    expect(projectOf(runtime.state).samples).toBe(3000);
    opens(runtime, 'dog.png');
    expect(asks(runtime)).toBe(false);
  });

  it('asks for its picture although an older error is shown', () => {
    const runtime = opened();
    drop(runtime, 'other.json');
    runtime.failRead(new C2WarpError('project', 'other.json: format: missing'));
    expect(englishNotice(runtime.state)?.kind).toBe('error');
    drop(runtime, 'pose.json');
    runtime.read(null, { ...other, image: { src: 'fox.png', width: 9, height: 9 } });
    expect(asks(runtime)).toBe(true);
    runtime.dispatch({ type: 'notice-dismissed' });
    expect(englishNotice(runtime.state)).toBeNull();
  });
});

describe('a file with all', () => {
  const other = { ...projectOf(opened().state), samples: 3000 };

  it('opens the picture that a project holds, in place of one being read', () => {
    const runtime = opened();
    placeHandle(runtime);
    drop(runtime, 'fox.png');
    drop(runtime, 'whole.json');
    runtime.read(dog, other);
    runtime.solve();
    expect(runtime.state.picture).toBe(dog);
    expect(projectOf(runtime.state).samples).toBe(3000);
    expect(runtime.state.opening).toMatchObject({ reading: null, readingProjects: [] });
    expect(runtime.state.opening.recent.map(({ name }) => name)).toEqual(['cat.png']);
  });

  it('asks for the picture that the project in a picture is for', () => {
    const runtime = opened();
    drop(runtime, 'dog.png');
    runtime.read(dog, null, { ...other, image: { src: 'fox.png', width: 400, height: 300 } });
    runtime.solve();
    expect(projectOf(runtime.state).samples).toBe(10000);
    expect(englishNotice(runtime.state)?.text).toContain('dog.png belongs to the picture fox.png');
    drop(runtime, 'fox.png');
    runtime.read(testPicture('fox.png'));
    runtime.solve();
    expect(projectOf(runtime.state).samples).toBe(3000);
  });

  it('opens as a picture where its project is damaged, and says so', () => {
    const runtime = opened();
    drop(runtime, 'dog.png');
    runtime.read(dog, null, new C2WarpError('project', 'The project in this picture is damaged.'));
    runtime.solve();
    expect(runtime.state.picture).toBe(dog);
    const text = 'dog.png opened without its project. The project in this picture is damaged.';
    expect(englishNotice(runtime.state)?.text).toBe(text);
  });
});

describe('several files', () => {
  const receive = (...files: readonly NamedFile[]) => {
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'files-received', files });
    return runtime;
  };
  const candidates = (runtime: FakeRuntime) =>
    effects(runtime, 'read').flatMap(({ pictures }) => pictures.map((each) => (each as NamedFile).name));
  const folder = { ...file('holiday'), folder: true };
  const note = file('note.txt', 'text/plain');
  const hidden = file('.hidden');
  const picture = { name: 'cat.png', file: testFile('cat.png') };

  it('try those that may be pictures, in their order', () => {
    const runtime = receive(note, hidden, folder, file('dog.png', 'image/png'), picture);
    expect(candidates(runtime)).toEqual(['.hidden', 'dog.png', 'cat.png']);
  });

  it('are named except for the one that opens', () => {
    const runtime = receive(note, folder, hidden, picture);
    runtime.read(cat);
    runtime.solve();
    expect(runtime.state.picture).toBe(cat);
    expect(englishNotice(runtime.state)?.text).toContain('note.txt and 2 more were not opened');
  });

  it('open a project beside them, but no folder with the name of one', () => {
    const runtime = receive({ ...file('old.json'), folder: true }, file('pose.json'), picture);
    expect(effects(runtime, 'read')).toMatchObject([{ project: { named: { name: 'pose.json' } } }]);
    expect(candidates(runtime)).toEqual(['cat.png']);
  });

  it('of which none may be a picture are refused by the first', () => {
    expect(candidates(receive(note, file('film.mp4', 'video/mp4')))).toEqual(['note.txt']);
    expect(candidates(receive(folder))).toEqual(['holiday']);
  });
});

describe('the first content', () => {
  const stored = () => {
    const other = opened();
    placeHandle(other);
    return { work: workOn('stored.png', other), recent: [] };
  };
  const started = (src: string | null = 'sample.png') => {
    const runtime = new FakeRuntime({ ...PAGE, src });
    runtime.dispatch({ type: 'autosave-key-set', key: 'editor' });
    runtime.dispatch({ type: 'started', work: null });
    return runtime;
  };

  it('is the attributes where nothing is stored', () => {
    const runtime = started();
    runtime.dispatch({ type: 'storage-read', stored: null });
    runtime.read(testPicture('sample.png'));
    runtime.solve();
    expect(runtime.notified.filter((type) => type === 'load' || type === 'ready')).toEqual(['load', 'ready']);
  });

  it('is ready at once without attributes', () => {
    const runtime = started(null);
    runtime.dispatch({ type: 'storage-read', stored: null });
    expect(runtime.notified).toContain('ready');
  });

  it('is stored work', () => {
    const runtime = started();
    runtime.dispatch({ type: 'storage-read', stored: stored() });
    runtime.read(testPicture('stored.png'));
    runtime.solve();
    expect(runtime.state.picture?.name).toBe('stored.png');
    expect(projectOf(runtime.state).handles).toHaveLength(1);
    expect(runtime.notified).toContain('ready');
  });

  it('is the attributes where stored work cannot be opened, and the work is parked', () => {
    const runtime = started();
    runtime.dispatch({ type: 'storage-read', stored: stored() });
    runtime.failRead(new C2WarpError('picture', 'stored.png: damaged'));
    runtime.read(testPicture('sample.png'));
    runtime.solve();
    expect(runtime.state.picture?.name).toBe('sample.png');
    expect(runtime.state.opening.recent.map(({ name }) => name)).toEqual(['stored.png']);
    expect(englishNotice(runtime.state)?.text).toContain('damaged');
  });

  it('does not replace a picture that was opened while the storage was read', () => {
    const runtime = started();
    drop(runtime);
    runtime.dispatch({ type: 'storage-read', stored: stored() });
    runtime.read(dog);
    runtime.solve();
    expect(runtime.state.picture).toBe(dog);
    expect(runtime.state.opening.recent.map(({ name }) => name)).toEqual(['stored.png']);
  });

  it('is restored when a newer picture is rejected while opening', () => {
    const runtime = started();
    runtime.dispatch({ type: 'storage-read', stored: stored() });
    drop(runtime);
    runtime.read(dog);
    expect(runtime.state.opening.restoring?.phase).toBe('suspended');
    runtime.refuse(refusal);
    runtime.read(testPicture('stored.png'));
    runtime.solve();
    expect(runtime.state.picture?.name).toBe('stored.png');
  });
});
