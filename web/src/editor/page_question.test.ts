import { describe, expect, it } from 'vitest';
import { addHandle, removeHandles } from '../document/edits';
import { say } from '../texts/wording';
import type { EditorEvent } from './events';
import { FakeRuntime } from './fake_runtime';
import { featuresOf, unknownFeatures } from './features';
import { questionOf, questionsOf } from './page_question';
import { documentOf, projectOf } from './state';
import { update } from './update';
import { step } from './update/steps';

const POINT = { id: 'belly', kind: 'point', rest: [30, 20], posed: [30, 20] } as never;

/** An editor with a solved picture and one handle. */
function solved(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  const handle = { id: 'head', kind: 'point', rest: [9, 9], posed: [9, 9] } as const;
  runtime.dispatch({ type: 'handle-added', handle });
  runtime.solve();
  return runtime;
}

/** The questions to the page before an event. */
const asked = ({ state }: FakeRuntime, event: EditorEvent) =>
  questionsOf(state, update(state, event).state, event);

describe('questions of a page', () => {
  it('come before people open something', () => {
    const runtime = solved();
    const file = { name: 'cat.png', file: { size: 1, type: 'image/png' } };
    expect(asked(runtime, { type: 'files-received', files: [file] })).toEqual([
      { type: 'beforeopen', files: [file], address: null },
    ]);
    expect(asked(runtime, { type: 'address-given', text: 'https://example.com/cat.png' })).toMatchObject([
      { type: 'beforeopen', address: 'https://example.com/cat.png' },
    ]);
  });

  it('name the handles that a step adds and removes', () => {
    const { state } = solved();
    const [first] = projectOf(state).handles;
    const added = step(state, say('steps.addHandle'), addHandle(documentOf(state), POINT), () => {});
    const removed = step(
      state,
      say('steps.deleteHandle'),
      removeHandles(documentOf(state), [first?.id ?? '']),
      () => {},
    );
    const event = { type: 'drawing-finished' } as const;
    expect(questionsOf(state, added, event)).toMatchObject([
      { type: 'beforeadd', handles: [{ id: 'belly' }] },
    ]);
    expect(questionsOf(state, removed, event)).toEqual([{ type: 'beforeremove', handles: [first] }]);
    expect(questionsOf(state, added, { type: 'handle-added', handle: POINT })).toEqual([]);
  });

  it('are not asked for undo and redo', () => {
    const runtime = solved();
    runtime.dispatch({ type: 'handle-added', handle: POINT });
    const undo = { type: 'command-run', command: 'undo' } as const;
    expect(asked(runtime, undo)).toEqual([]);
    runtime.dispatch(undo);
    expect(asked(runtime, { type: 'command-run', command: 'redo' })).toEqual([]);
  });

  it('come before effects that write files', () => {
    const project = projectOf(solved().state);
    const save = { type: 'save-project', name: 'cat.json', project, of: project, picture: null } as const;
    expect(questionOf(save)).toEqual({ type: 'beforesave', name: 'cat.json', project, picture: null });
    expect(questionOf({ type: 'pick-file' })).toBeNull();
  });
});

describe('features', () => {
  it('are the words of the attribute', () => {
    expect(featuresOf(null)).toBeNull();
    expect(featuresOf('')).toEqual([]);
    expect(featuresOf(' save  tools shop ')).toEqual(['tools', 'save']);
    expect(unknownFeatures(' save  tools shop ')).toEqual(['shop']);
  });

  it('that are left out do not run, and say so', () => {
    const runtime = solved();
    const page = { ...runtime.state.page, features: featuresOf('tools') };
    runtime.dispatch({ type: 'page-changed', page });
    const before = runtime.state;
    runtime.dispatch({ type: 'command-run', command: 'save' });
    expect(runtime.state.exporting).toBe(before.exporting);
    runtime.dispatch({ type: 'command-run', command: 'bar' });
    expect(runtime.state.tools.tool).toBe('bar');
  });
});
