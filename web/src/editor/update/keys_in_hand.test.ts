import { beforeEach, describe, expect, it } from 'vitest';
import type { KeyRef } from '../../document/clip_keys';
import { toStage } from '../../geometry/camera';
import type { Vec } from '../../geometry/vec';
import { type CommandName, commandOfKey, commandsFor } from '../commands';
import { englishNotice, spokenText } from '../english';
import type { EditorEvent } from '../events';
import { FakeRuntime } from '../fake_runtime';
import { keysInHand } from '../keys_in_hand';
import { filedProject, projectOf, selectionOf } from '../state';
import { copiedText } from './clipboard';
import { repeats } from './command';

const KEYS: readonly KeyRef[] = [
  { handle: 'a', time: 0 },
  { handle: 'a', time: 1 },
];

let runtime: FakeRuntime;
const send = (...events: readonly EditorEvent[]) => {
  for (const event of events) runtime.dispatch(event);
};
const run = (command: CommandName): EditorEvent => ({ type: 'command-run', command });
const at = (place: Vec) => ({
  stage: toStage(runtime.state.view.camera, place),
  shift: false,
  alt: false,
  free: false,
  coarse: false,
});
const times = (handle: string) =>
  filedProject(runtime.state)
    .clips?.[0]?.tracks.find((track) => track.handle === handle)
    ?.keys.map(({ time }) => time) ?? [];
const held = () => keysInHand(runtime.state);

/** Presses a key of the keyboard, for a command of the selection. */
function press(key: string): void {
  const { page, tools } = runtime.state;
  const commands = commandsFor(page.posable, page.readonly, tools.tool, held().length > 0);
  const command = commandOfKey(
    { key, code: '', ctrlKey: false, metaKey: false, altKey: false, shiftKey: false },
    commands,
  );
  if (command) send(run(command));
}

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
  for (const [id, x] of [
    ['a', 100],
    ['b', 300],
  ] as const)
    send({ type: 'handle-added', handle: { id, kind: 'point', rest: [x, 150], posed: [x, 150] } });
  runtime.solve();
  send(run('timeline'), { type: 'clip-added', preset: null });
  for (const id of ['a', 'b'])
    send({ type: 'handles-selected', ids: [id] }, { type: 'playhead-moved', time: 0 }, run('set-key'));
  send({ type: 'handles-selected', ids: ['a'] }, { type: 'playhead-moved', time: 1 }, run('set-key'), {
    type: 'keys-selected',
    keys: KEYS,
  });
});

describe('selected keys', () => {
  it('are deleted by Delete, and their handle stays', () => {
    expect(held()).toEqual(KEYS);
    expect(selectionOf(runtime.state)).toEqual(['a']);
    press('Delete');
    expect([times('a'), times('b'), held()]).toEqual([[], [0], []]);
    expect(projectOf(runtime.state).handles).toHaveLength(2);
  });

  it.each<readonly [string, readonly EditorEvent[]]>([
    [
      'a button of the timeline',
      [
        { type: 'onion-switched', on: true },
        { type: 'timeline-zoomed', notches: 1 },
      ],
    ],
    ['playing and stopping', [run('play'), { type: 'clock-ticked', seconds: 0.3 }, run('play')]],
    ['a press on the ruler', [{ type: 'control-focused' }, { type: 'playhead-moved', time: 0.5 }]],
    [
      'a number in the panel',
      [{ type: 'field-focused' }, { type: 'field-set', field: 'x', change: { to: 9 } }],
    ],
    ['the focus on the stage', [{ type: 'stage-focused' }]],
    ['a view command', [run('zoom-in'), run('fit'), run('compare'), run('compare')]],
    ['an overlay', [{ type: 'overlay-switched', overlay: 'mesh', on: true }]],
    ['the hand', [run('hand')]],
    ['an ease', [{ type: 'keys-eased', ease: 'hold' }]],
  ])('stay in hand after %s', (_, events) => {
    send(...events);
    expect(held()).toEqual(KEYS);
    press('Backspace');
    expect(times('a').filter((time) => KEYS.some((key) => key.time === time))).toEqual([]);
    expect(projectOf(runtime.state).handles).toHaveLength(2);
  });

  it('stay in hand after a drag that pans', () => {
    const pointer = at([200, 20]);
    send({ type: 'press-began', pointer, pans: true }, { type: 'press-ended', pointer });
    expect(held()).toEqual(KEYS);
    expect(runtime.effects.at(-1)).toEqual({ type: 'focus', target: { handle: null, corner: null } });
  });

  it.each<readonly [string, () => readonly EditorEvent[]]>([
    ['a press on their handle', () => [{ type: 'press-began', pointer: at([100, 150]), pans: false }]],
    ['the focus on their handle', () => [{ type: 'handle-focused', id: 'a' }]],
    ['the list of handles', () => [{ type: 'handles-selected', ids: ['a'] }]],
    ['a menu of their handle', () => [{ type: 'menu-asked', pointer: at([100, 150]), resting: false }]],
  ])('are let go by %s, and then Delete is about the handle', (_, events) => {
    send(...events());
    expect(held()).toEqual([]);
    expect(selectionOf(runtime.state)).toEqual(['a']);
    send({ type: 'press-cancelled' });
    press('Delete');
    expect(projectOf(runtime.state).handles.map(({ id }) => id)).toEqual(['b']);
  });

  it('are let go by Escape before their handle is', () => {
    press('Escape');
    expect([held(), selectionOf(runtime.state)]).toEqual([[], ['a']]);
    press('Escape');
    expect(selectionOf(runtime.state)).toEqual([]);
  });

  it('are let go by a tool that draws', () => {
    send(run('polygon'));
    expect([held(), selectionOf(runtime.state)]).toEqual([[], []]);
  });

  it('stay in hand when the page sets the same selection back', () => {
    send({ type: 'selection-set', ids: ['a'] });
    expect(held()).toEqual(KEYS);
  });

  it('are not taken by S for handles, and stay where S sets keys', () => {
    send({ type: 'handles-selected', ids: ['b'] }, { type: 'playhead-moved', time: 0.4 }, run('set-key'));
    expect(held()).toEqual([]);
    send({ type: 'keys-selected', keys: KEYS }, run('set-key'));
    expect(held()).toEqual([{ handle: 'a', time: 0.4 }]);
  });

  it('move the focus to their handle when they are deleted', () => {
    send({ type: 'key-focused' });
    press('Delete');
    expect(runtime.effects).toContainEqual({ type: 'focus', target: { handle: 'a', corner: null } });
    expect([repeats(runtime.state, 'remove'), repeats(runtime.state, 'remove-keys')]).toEqual([false, false]);
  });
});

describe('undo and redo', () => {
  it('select the keys that they bring', () => {
    press('Delete');
    send(run('undo'));
    expect([times('a'), held()]).toEqual([[0, 1], KEYS]);
    send(run('redo'));
    expect([times('a'), held()]).toEqual([[], []]);
    send(run('undo'), { type: 'keys-selected', keys: [{ handle: 'a', time: 1 }] });
    send({ type: 'keys-stepped', frames: 3 }, run('undo'));
    expect(held()).toEqual([{ handle: 'a', time: 1 }]);
  });

  it('of other steps leave them in hand', () => {
    send({ type: 'pose-mode-chosen', mode: 'harmonic' }, run('undo'));
    expect(held()).toEqual(KEYS);
    send({ type: 'handles-selected', ids: ['b'] }, { type: 'field-set', field: 'y', change: { to: 9 } });
    send({ type: 'keys-selected', keys: KEYS }, run('undo'));
    expect([selectionOf(runtime.state), held()]).toEqual([['b'], []]);
  });

  it('of a drag leave the keyboard with the handle', () => {
    send({ type: 'press-began', pointer: at([100, 150]), pans: false });
    send({ type: 'press-moved', pointer: at([120, 170]) }, { type: 'press-ended', pointer: at([120, 170]) });
    send(run('undo'));
    expect(held()).toEqual([]);
    send(run('redo'));
    expect(held()).toEqual([]);
  });
});

describe('arrows', () => {
  it('go from the last selected key to the one beside it, and the playhead with them', () => {
    send({ type: 'key-focused' }, { type: 'keys-walked', by: [-1, 0], extends: false });
    expect(held()).toEqual([{ handle: 'a', time: 0 }]);
    expect(runtime.state.timeline.time).toBe(0);
    expect(runtime.effects).toContainEqual({
      type: 'focus',
      target: { handle: null, corner: null, key: { handle: 'a', time: 0 } },
    });
    send({ type: 'keys-walked', by: [0, 1], extends: false });
    expect([held(), selectionOf(runtime.state)]).toEqual([[{ handle: 'b', time: 0 }], ['b']]);
    send({ type: 'keys-walked', by: [0, -1], extends: true });
    expect(held()).toEqual([
      { handle: 'b', time: 0 },
      { handle: 'a', time: 0 },
    ]);
  });

  it('with Alt move the selected keys', () => {
    send({ type: 'keys-selected', keys: [{ handle: 'a', time: 1 }] }, { type: 'keys-stepped', frames: 3 });
    expect([times('a'), held()]).toEqual([[0, 1.1], [{ handle: 'a', time: 1.1 }]]);
  });
});

describe('the clipboard', () => {
  const paste = (text: string | null) => send({ type: 'text-pasted', text: text ?? '' });

  it('gets the keys in hand, or else the pose', () => {
    const keys = copiedText(runtime.state);
    expect(keys).toContain('c2warp-keys/1');
    send({ type: 'selection-copied' });
    expect(spokenText(runtime.state)).toBe('Copied 2 keys');
    press('Escape');
    expect(copiedText(runtime.state)).toContain('c2warp-pose/1');
    // Whatever is selected now.
    send({ type: 'playhead-moved', time: 0.5 });
    paste(keys);
    expect(times('a')).toEqual([0, 0.5, 1, 1.5]);
    expect(held()).toEqual([
      { handle: 'a', time: 0.5 },
      { handle: 'a', time: 1.5 },
    ]);
  });

  it('gives keys to another editor, but for those that do not fit', () => {
    const keys = copiedText(runtime.state);
    send({ type: 'handle-removed', id: 'a' });
    paste(keys);
    expect(englishNotice(runtime.state)?.text).toContain('2 keys were left out');
    send({ type: 'timeline-opened', open: false });
    paste(keys);
    expect(englishNotice(runtime.state)?.text).toBe('Open a clip first');
  });

  it('names the fault of keys', () => {
    paste('{"format": "c2warp-keys/1", "keys": [{"handle": "a", "time": 0, "posed": ["x", 1]}]}');
    expect(englishNotice(runtime.state)?.text).toBe(
      'Could not paste these keys: handle "a", posed: expected a point [x, y].',
    );
  });
});
