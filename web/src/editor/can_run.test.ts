import { describe, expect, it } from 'vitest';
import { canRun, reasonAgainst } from './can_run';
import type { CommandName } from './commands';
import { inEnglish } from './english';
import { FakeRuntime, PAGE } from './fake_runtime';

describe('why a command cannot run', () => {
  const runtime = new FakeRuntime();
  const reason = (command: CommandName) => inEnglish(reasonAgainst(runtime.state, command));

  it('is a picture, a handle or a selection that is missing', () => {
    expect([reason('save'), reason('undo')]).toEqual(['Open a picture first', 'Open a picture first']);
    runtime.open();
    expect(reason('copy')).toBe('Add a handle first');
    expect(reason('undo')).toBe('Nothing to undo');
    runtime.dispatch({
      type: 'handle-added',
      handle: { id: 'a', kind: 'point', rest: [9, 9], posed: [9, 9] },
    });
    expect(reason('reset')).toBe('Already in the rest position');
    runtime.dispatch({ type: 'selection-set', ids: [] });
    expect([reason('reset'), reason('remove')]).toEqual(['Select a handle first', 'Select a handle first']);
    expect([reason('add-corner'), reason('add-point')]).toEqual([
      'Select a single bar or polygon',
      'Nothing bends here',
    ]);
  });

  it('is null for a command that can run, and the page for all others', () => {
    expect([reason('fit'), reason('copy'), canRun(runtime.state, 'copy')]).toEqual([null, null, true]);
    runtime.dispatch({ type: 'page-changed', page: { ...PAGE, readonly: true } });
    expect(reason('copy')).toBe('This picture is view-only');
    runtime.dispatch({ type: 'page-changed', page: { ...PAGE, disabled: true } });
    expect(reason('fit')).toBe('The editor is disabled');
  });
});
