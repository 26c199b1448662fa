import { beforeEach, describe, expect, it } from 'vitest';
import { undoLabel } from '../../document/history';
import { inEnglish } from '../english';
import { FakeRuntime } from '../fake_runtime';
import { projectOf } from '../state';

/** A picture that Enter and arrows have pushed, and that they still hold. */
let runtime: FakeRuntime;
let resting: unknown;

const pointer = { stage: [100, 100], shift: false, alt: false, free: false, coarse: false } as const;
const project = () => projectOf(runtime.state);
const history = () => runtime.state.document.history;
const steps = () => history().past.length;

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
  resting = project();
  runtime.dispatch({ type: 'tool-set', tool: 'brush' });
  runtime.dispatch({ type: 'place-pressed' });
  for (let k = 0; k < 4; k++) runtime.dispatch({ type: 'arrow-pressed', by: [1, 0] });
});

describe('a push that keys hold', () => {
  it('is a step once Enter is released', () => {
    expect(project().displacement).toBeDefined();
    expect(history().open).not.toBeNull();
    runtime.dispatch({ type: 'place-pressed' });
    expect(history().open).toBeNull();
    expect(inEnglish(undoLabel(history()))).toBe('Push');
  });

  it('is taken back by Escape', () => {
    runtime.dispatch({ type: 'command-run', command: 'bail' });
    expect(project()).toEqual(resting);
    expect(inEnglish(undoLabel(history()))).not.toBe('Push');
  });

  it('is a step of its own before a press of the pointer', () => {
    const [pushed, before] = [project(), steps()];
    runtime.dispatch({ type: 'press-began', pointer, pans: false });
    expect(project()).toEqual(pushed);
    expect(inEnglish(undoLabel(history()))).toBe('Push');
    runtime.dispatch({ type: 'press-moved', pointer: { ...pointer, stage: [120, 100] } });
    runtime.dispatch({ type: 'press-ended', pointer: { ...pointer, stage: [120, 100] } });
    expect(project()).not.toEqual(pushed);
    expect(steps()).toBe(before + 2);
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(project()).toEqual(pushed);
    runtime.dispatch({ type: 'command-run', command: 'undo' });
    expect(project()).toEqual(resting);
  });

  it('does not begin in a stroke of the pointer', () => {
    runtime.dispatch({ type: 'place-pressed' });
    runtime.dispatch({ type: 'press-began', pointer, pans: false });
    runtime.dispatch({ type: 'press-moved', pointer: { ...pointer, stage: [120, 100] } });
    const stroked = project();
    runtime.dispatch({ type: 'arrow-pressed', by: [1, 0] });
    runtime.dispatch({ type: 'place-pressed' });
    expect([project(), history().open === null]).toEqual([stroked, false]);
  });

  it('is kept when the pointer pans the picture, or asks for the menu', () => {
    const pushed = project();
    runtime.dispatch({ type: 'press-began', pointer, pans: true });
    runtime.dispatch({ type: 'press-ended', pointer });
    expect([project(), inEnglish(undoLabel(history())), history().open]).toEqual([pushed, 'Push', null]);
    runtime.dispatch({ type: 'place-pressed' });
    for (let k = 0; k < 4; k++) runtime.dispatch({ type: 'arrow-pressed', by: [0, 1] });
    const again = project();
    expect(again).not.toEqual(pushed);
    runtime.dispatch({ type: 'menu-asked', pointer, resting: false });
    expect([project(), history().open]).toEqual([again, null]);
  });

  it('is kept when another tool is chosen, by a key or by the page', () => {
    for (const tool of ['hand', 'point', 'lens'] as const) {
      const pushed = project();
      expect(history().open).not.toBeNull();
      if (tool === 'hand') runtime.dispatch({ type: 'tool-set', tool });
      else runtime.dispatch({ type: 'command-run', command: tool });
      expect(runtime.state.tools.tool).toBe(tool);
      expect([project(), inEnglish(undoLabel(history())), history().open]).toEqual([pushed, 'Push', null]);
      runtime.dispatch({ type: 'tool-set', tool: 'brush' });
      runtime.dispatch({ type: 'place-pressed' });
      runtime.dispatch({ type: 'arrow-pressed', by: [3, 2] });
    }
  });
});
