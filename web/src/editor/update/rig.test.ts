import { describe, expect, it } from 'vitest';
import type { Handle, Project } from '../../document/project';
import { englishNotice } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { projectOf } from '../state';

const dog = { ...testPicture('dog.png'), width: 200, height: 150, alphaThreshold: 0.5 };

/** An editor with one handle on a picture with transparency. */
function rigged(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open({ ...testPicture(), alphaThreshold: 0.5 });
  runtime.dispatch({ type: 'handle-added', handle: HAND });
  runtime.solve();
  return runtime;
}

const HAND: Handle = { id: 'hand', kind: 'point', rest: [100, 100], posed: [100, 100] };

const drop = (runtime: FakeRuntime, ...names: readonly string[]) =>
  runtime.dispatch({
    type: 'files-received',
    files: names.map((name) => ({ name, file: testPicture(name).file })),
  });

/** Answers the last fit, with the handle at another place. */
function answer(runtime: FakeRuntime, moved: readonly string[] = []) {
  const asked = runtime.effects.findLast((effect) => effect.type === 'fit-rig');
  if (!asked) throw new Error('no rig was asked for');
  const image = { src: '', width: 200, height: 150 };
  const handles = [{ ...HAND, rest: [50, 50], posed: [50, 50] }] as Project['handles'];
  const project = { ...asked.rig.project, image, handles };
  runtime.dispatch({ type: 'rig-fitted', rig: asked.rig, picture: asked.picture, project, moved });
  runtime.solve();
  return asked;
}

describe('the rig of the picture before', () => {
  it('is offered for a new picture, and used as one step', () => {
    const runtime = rigged();
    drop(runtime, 'dog.png');
    runtime.read(dog);
    runtime.solve();
    expect(projectOf(runtime.state).handles).toEqual([]);
    const notice = englishNotice(runtime.state);
    expect([notice?.action?.label, notice?.other?.label]).toEqual(['Use this rig', 'Back to cat.png']);
    runtime.dispatch({ type: 'notice-answered' });
    const { rig } = answer(runtime, ['hand']);
    expect(rig.own?.name).toBe('cat.png');
    expect(rig.project.handles).toEqual([HAND]);
    expect(projectOf(runtime.state).image).toEqual({ src: 'dog.png', width: 200, height: 150 });
    expect(projectOf(runtime.state).handles[0]?.rest).toEqual([50, 50]);
    expect(englishNotice(runtime.state)?.text).toContain('hand was outside this picture');
    runtime.dispatch({ type: 'undo-asked' });
    expect(projectOf(runtime.state).handles).toEqual([]);
    // The work on the other picture is not lost.
    expect(runtime.state.opening.recent.map(({ name }) => name)).toEqual(['cat.png']);
  });

  it('is not used once another picture is open, nor offered without handles', () => {
    const runtime = rigged();
    drop(runtime, 'dog.png');
    runtime.read(dog);
    runtime.solve();
    runtime.dispatch({ type: 'notice-answered' });
    drop(runtime, 'fox.png');
    runtime.read(testPicture('fox.png'));
    runtime.solve();
    expect(englishNotice(runtime.state)?.action?.label).not.toBe('Use this rig');
    answer(runtime);
    expect(projectOf(runtime.state).handles).toEqual([]);
  });
});

describe('the rig of a project for a picture of another size', () => {
  const project = (runtime: FakeRuntime): Project => ({
    ...projectOf(runtime.state),
    image: { src: 'owl.png', width: 80, height: 60 },
    handles: [HAND],
  });

  it('is offered beside its picture, alone and with a wrong picture', () => {
    for (const files of [['pose.json'], ['dog.png', 'pose.json']]) {
      const runtime = rigged();
      drop(runtime, ...files);
      runtime.read(files.length > 1 ? dog : null, project(runtime));
      runtime.solve();
      const notice = englishNotice(runtime.state);
      expect([notice?.action?.label, notice?.other?.label]).toEqual(['Open picture', 'Use this rig']);
      expect(notice?.text).toContain('belongs to the picture owl.png (80 × 60 px)');
      runtime.dispatch({ type: 'notice-answered', other: true });
      expect(answer(runtime).rig.own).toBeNull();
      expect(projectOf(runtime.state).handles).toHaveLength(1);
      expect(runtime.state.opening.awaiting).toBeNull();
    }
  });
});
