import { describe, expect, it } from 'vitest';
import { C2WarpError, ENGINE } from '../../error';
import { en } from '../../texts/en';
import { say, type Wording } from '../../texts/wording';
import { englishNotice, englishTask, inEnglish } from '../english';
import { FakeRuntime } from '../fake_runtime';
import { projectOf } from '../state';
import { beginTask, currentTask, endTask, informOfStep, notify } from './notices';

const ignore = () => {};
const fresh = () => new FakeRuntime().state;
const elapsed = (runtime: FakeRuntime) => runtime.dispatch({ type: 'timer-elapsed', timer: 'notice' });

describe('a notice without an action', () => {
  it('disappears after its time, which starts again when the pointer leaves it', () => {
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'person-informed', text: 'a word' });
    runtime.dispatch({ type: 'notice-hovered', on: true });
    expect(runtime.effects.at(-1)).toEqual({ type: 'stop-timer', timer: 'notice' });
    runtime.dispatch({ type: 'notice-hovered', on: false });
    expect(runtime.effects.at(-1)).toMatchObject({ type: 'start-timer', timer: 'notice' });
    elapsed(runtime);
    expect(englishNotice(runtime.state)).toBeNull();
  });
});

describe('a notice about a step', () => {
  it('ends with the next step, unlike other notices', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    runtime.state = informOfStep(runtime.state, say('errors.other', 'One is gone.'), ignore);
    runtime.dispatch({ type: 'boundary-switched', held: false });
    expect(englishNotice(runtime.state)).toBeNull();
    runtime.dispatch({ type: 'person-informed', text: 'a word' });
    runtime.dispatch({ type: 'boundary-switched', held: true });
    expect(englishNotice(runtime.state)?.text).toBe('a word');
  });

  it('joins others about the same step, each once', () => {
    const action = {
      label: say('answers.holdBoundary'),
      event: { type: 'boundary-switched', held: true },
    } as const;
    const first = notify(
      fresh(),
      { kind: 'info', text: say('errors.other', 'One.'), ofStep: true, action, passes: true },
      ignore,
    );
    const second = informOfStep(
      informOfStep(first, say('errors.other', 'Two.'), ignore),
      say('errors.other', 'Two.'),
      ignore,
    );
    expect(englishNotice(second)).toMatchObject({
      text: 'One. Two.',
      action: { ...action, label: 'Lock its outline' },
    });
  });
});

describe('the reset of all handles', () => {
  /** A handle beside its position at rest, and a push of the brush. */
  function brushed(): FakeRuntime {
    const runtime = new FakeRuntime();
    runtime.open();
    const handle = { id: 'nose', kind: 'point', rest: [200, 150], posed: [220, 150] } as const;
    runtime.dispatch({ type: 'handle-added', handle });
    const values = Buffer.from(new Int16Array(2 * 16).fill(100).buffer).toString('base64');
    const project = { ...projectOf(runtime.state), displacement: { width: 4, height: 4, values } };
    runtime.dispatch({ type: 'project-adopted', project });
    runtime.solve();
    return runtime;
  }
  const reset = (runtime: FakeRuntime, command: 'reset' | 'reset-all') =>
    runtime.dispatch({ type: 'command-run', command });

  it('says that strokes of the brush stay, and its action clears them', () => {
    const runtime = brushed();
    const { displacement } = projectOf(runtime.state);
    reset(runtime, 'reset-all');
    expect(projectOf(runtime.state)).toMatchObject({ displacement, handles: [{ posed: [200, 150] }] });
    const notice = englishNotice(runtime.state);
    expect(notice).toMatchObject({ text: en.notices.brushedStill, action: { label: 'Clear strokes' } });
    runtime.dispatch({ type: 'notice-answered' });
    expect(projectOf(runtime.state).displacement).toBeUndefined();
    expect(englishNotice(runtime.state)).toBeNull();
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(projectOf(runtime.state).displacement).toEqual(displacement);
  });

  it('says nothing without strokes, nor does the reset of one handle', () => {
    const runtime = brushed();
    runtime.dispatch({ type: 'selection-set', ids: ['nose'] });
    reset(runtime, 'reset');
    expect(projectOf(runtime.state).handles).toMatchObject([{ posed: [200, 150] }]);
    expect(englishNotice(runtime.state)).toBeNull();
    runtime.dispatch({ type: 'displacement-cleared' });
    reset(runtime, 'reset-all');
    expect(englishNotice(runtime.state)).toBeNull();
  });
});

describe('an error', () => {
  const error = new C2WarpError(ENGINE, 'Could not load the solver');

  it('of the solver can be retried, and closes once the solver works', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    runtime.dispatch({ type: 'boundary-switched', held: false });
    runtime.refuse(error, true);
    expect(englishNotice(runtime.state)?.action?.label).toBe('Try again');
    runtime.dispatch({ type: 'notice-answered' });
    runtime.solve();
    expect(englishNotice(runtime.state)).toBeNull();
  });

  it('of another kind remains, and the page is notified', () => {
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'error-reported', error: new Error('no picture') });
    elapsed(runtime);
    expect(runtime.notified).toEqual(['error']);
  });

  it('that only says that a newer request came is not shown', () => {
    const runtime = new FakeRuntime();
    const error = Object.assign(new Error('superseded'), { name: 'AbortError' });
    runtime.dispatch({ type: 'error-reported', error });
    expect(englishNotice(runtime.state)).toBeNull();
  });
});

describe('progress', () => {
  it('shows the newest task, each until it ends', () => {
    const labels: (string | null)[] = [];
    const emit = (effect: { readonly type: string; readonly notification?: object }) => {
      const { notification } = effect as { notification?: { type: string; label?: Wording | null } };
      if (notification?.type === 'progress') labels.push(inEnglish(notification.label ?? null));
    };
    const solve = { name: 'solve', label: say('tasks.domain'), cancellable: true } as const;
    const exporting = { name: 'export', label: say('tasks.exporting'), cancellable: false } as const;
    let state = beginTask(beginTask(fresh(), solve, emit), exporting, emit);
    expect(currentTask(state)).toBe(exporting);
    state = endTask(state, 'solve', emit);
    expect(currentTask(state)).toBe(exporting);
    state = endTask(state, 'export', emit);
    expect(englishTask(state)).toBeNull();
    expect(labels).toEqual(['Building the mesh', 'Exporting', null]);
  });
});
