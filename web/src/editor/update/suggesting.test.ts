import { beforeEach, describe, expect, it } from 'vitest';
import type { Handle, Project } from '../../document/project';
import type { Suggestion } from '../../document/suggestion';
import type { CommandName } from '../commands';
import { englishNotice, englishTask, spokenText } from '../english';
import { FakeRuntime, PAGE, testPicture } from '../fake_runtime';
import { projectOf, selectionOf } from '../state';

const SUGGESTION: Suggestion = {
  handles: [
    { id: 'top-left-end', rest: [100, 50] },
    { id: 'middle', rest: [200, 150] },
  ],
  outlined: true,
};
const HAND: Handle = { id: 'hand', kind: 'point', rest: [300, 200], posed: [300, 200] };

let runtime: FakeRuntime;

const run = (command: CommandName) => runtime.dispatch({ type: 'command-run', command });

/** The project of the last request for handles. */
function asked(): Project {
  const effect = runtime.effects.findLast(({ type }) => type === 'suggest-handles');
  if (effect?.type !== 'suggest-handles') throw new Error('no handles were asked for');
  return effect.project;
}

const answer = (suggestion = SUGGESTION, project = asked()) =>
  runtime.dispatch({ type: 'handles-suggested', project, suggestion });
const ids = () => projectOf(runtime.state).handles.map(({ id }) => id);
const text = () => englishNotice(runtime.state)?.text;

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
});

describe('suggested handles', () => {
  it('are added as one step, and reported', () => {
    run('suggest');
    answer();
    expect(ids()).toEqual(['top-left-end', 'middle']);
    expect(projectOf(runtime.state).handles[0]).toMatchObject({
      rest: [100, 50],
      posed: [100, 50],
      rotation: 'auto',
    });
    expect(text()).toBe('Placed 2 handles. Drag one to bend the picture.');
    expect(spokenText(runtime.state)).toBe('Suggest 2 handles');
    expect([runtime.state.tools.tool, runtime.state.suggesting]).toEqual(['select', null]);
    run('undo');
    expect(ids()).toEqual([]);
    expect(spokenText(runtime.state)).toBe('Undone: Suggest 2 handles');
    run('redo');
    expect(ids()).toHaveLength(2);
  });

  it('keep the handles that are there, their selection and the pose', () => {
    runtime.dispatch({ type: 'handle-added', handle: { ...HAND, posed: [310, 205] } });
    runtime.dispatch({ type: 'selection-set', ids: ['hand'] });
    runtime.solve();
    run('suggest');
    answer();
    expect(ids()).toEqual(['hand', 'top-left-end', 'middle']);
    expect(selectionOf(runtime.state)).toEqual(['hand']);
    // The picture is moved by (10, 5), and so are they.
    expect(projectOf(runtime.state).handles[2]).toMatchObject({ rest: [200, 150], posed: [210, 155] });
    expect(text()).toBe('Added 2 handles. The existing handle stays.');
  });

  it('say why no handle is added', () => {
    const none = { handles: [], outlined: false };
    run('suggest');
    answer(none);
    expect(text()).toBe('This picture has no room for a handle.');
    runtime.dispatch({ type: 'handle-added', handle: HAND });
    run('suggest');
    answer(none);
    expect(text()).toBe('No handles were added: every suitable place already has one nearby.');
    expect(ids()).toEqual(['hand']);
  });

  it('say that a picture without an outline has rows', () => {
    run('suggest');
    answer({ ...SUGGESTION, outlined: false });
    expect(text()).toContain('Placed 2 handles in even rows, because the picture has no outline to follow.');
  });

  it('get other ids where handles were renamed meanwhile', () => {
    runtime.dispatch({ type: 'handle-added', handle: HAND });
    run('suggest');
    runtime.dispatch({ type: 'rename-asked', id: 'hand' });
    runtime.dispatch({ type: 'name-given', name: 'Middle', keyed: true });
    answer();
    expect(ids()).toEqual(['Middle', 'top-left-end', 'handle-1']);
  });

  it('end by Escape, by a change of the handles, and by another picture', () => {
    const ends = [
      () => run('bail'),
      () => runtime.dispatch({ type: 'task-cancelled', task: 'suggest' }),
      () => runtime.dispatch({ type: 'handle-added', handle: HAND }),
      () => run('undo'),
      () => runtime.open(testPicture('dog.png')),
    ];
    for (const end of ends) {
      run('suggest');
      runtime.dispatch({ type: 'timer-elapsed', timer: 'suggest-patience' });
      expect(englishTask(runtime.state)?.name).toBe('suggest');
      end();
      expect([runtime.state.suggesting, englishTask(runtime.state)?.name]).not.toContain('suggest');
      expect(runtime.state.suggesting).toBeNull();
      const before = ids();
      answer();
      expect(ids()).toEqual(before);
    }
    expect(runtime.effects.filter(({ type }) => type === 'stop-suggesting')).toHaveLength(ends.length);
  });

  it('go on while handles are posed', () => {
    runtime.dispatch({ type: 'handle-added', handle: HAND });
    runtime.solve();
    run('suggest');
    runtime.dispatch({ type: 'handle-changed', handle: { ...HAND, posed: [302, 200] } });
    answer();
    expect(ids()).toHaveLength(3);
  });

  it('only belong to the newest command', () => {
    run('suggest');
    const first = asked();
    runtime.dispatch({ type: 'handle-added', handle: HAND });
    run('suggest');
    answer(SUGGESTION, first);
    expect(ids()).toEqual(['hand']);
    answer();
    expect(ids()).toHaveLength(3);
  });

  it('wait for a picture that is being opened', () => {
    runtime.dispatch({
      type: 'files-received',
      files: [{ name: 'dog.png', file: testPicture('dog.png').file }],
    });
    run('suggest');
    expect(runtime.state.suggesting).toBeNull();
    runtime.read(testPicture('dog.png'));
    expect(asked().image.src).toBe('dog.png');
    answer();
    runtime.solve();
    expect(ids()).toHaveLength(2);
  });

  it('are not for a picture that may only be viewed, nor without one', () => {
    runtime.dispatch({ type: 'page-changed', page: { ...PAGE, readonly: true } });
    run('suggest');
    const none = new FakeRuntime();
    none.dispatch({ type: 'command-run', command: 'suggest' });
    const effects = [...runtime.effects, ...none.effects];
    expect(effects.filter(({ type }) => type === 'suggest-handles')).toEqual([]);
    expect(spokenText(none.state)).toBe('');
  });

  it('report a failure of the solver', () => {
    run('suggest');
    runtime.dispatch({ type: 'suggestion-failed', project: asked(), error: new Error('no memory') });
    expect(englishNotice(runtime.state)).toMatchObject({ kind: 'error', text: 'no memory' });
    expect(runtime.state.suggesting).toBeNull();
  });
});
