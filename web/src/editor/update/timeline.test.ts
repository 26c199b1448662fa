import { describe, expect, it } from 'vitest';
import { anchor, depthOf } from '../../document/handle';
import type { Vec } from '../../geometry/vec';
import { en } from '../../texts/en';
import type { CommandName } from '../commands';
import { englishNotice } from '../english';
import type { EditorEvent } from '../events';
import { FakeRuntime } from '../fake_runtime';
import { documentOf, filedProject, isUnsaved, projectOf } from '../state';
import { viewModel } from '../view_model';
import { projectForFile } from './exporting';

const pointer = (stage: Vec) => ({ stage, shift: false, alt: false, free: false, coarse: false });

function opened(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  for (const [id, x] of [
    ['a', 100],
    ['b', 300],
  ] as const) {
    const place: Vec = [x, 150];
    runtime.dispatch({ type: 'handle-added', handle: { id, kind: 'point', rest: place, posed: place } });
  }
  runtime.solve();
  runtime.dispatch({ type: 'command-run', command: 'timeline' });
  runtime.dispatch({ type: 'clip-added', preset: null });
  return runtime;
}

function send(runtime: FakeRuntime, ...events: readonly EditorEvent[]): void {
  for (const event of events) runtime.dispatch(event);
}
/** The place on the stage of a place of the picture. */
function staged(runtime: FakeRuntime, [x, y]: Vec): Vec {
  const { scale, x: left, y: top } = runtime.state.view.camera;
  return [x * scale + left, y * scale + top];
}
function drag(runtime: FakeRuntime, ...way: readonly Vec[]): void {
  const [from, ...others] = way.map((place) => pointer(staged(runtime, place)));
  if (!from) return;
  send(runtime, { type: 'press-began', pointer: from, pans: false });
  for (const to of others) send(runtime, { type: 'press-moved', pointer: to });
  send(runtime, { type: 'press-ended', pointer: others.at(-1) ?? from });
}
const run = (command: CommandName): EditorEvent => ({ type: 'command-run', command });
const move = (time: number): EditorEvent => ({ type: 'playhead-moved', time });
const clip = (runtime: FakeRuntime) => filedProject(runtime.state).clips?.[0];
const keys = (runtime: FakeRuntime, handle: string) =>
  clip(runtime)
    ?.tracks.find((track) => track.handle === handle)
    ?.keys.map(({ time, posed }) => [time, posed?.[0]]);
const x = (runtime: FakeRuntime, id: string) => {
  const handle = projectOf(runtime.state).handles.find((handle) => handle.id === id);
  return handle && anchor(handle)[0];
};

describe('the timeline', () => {
  it('makes keys of drags at the playhead, and shows the pose between them', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [120, 150], [160, 150]);
    expect(keys(runtime, 'a')).toEqual([
      [0, 100],
      [1, 160],
    ]);
    send(runtime, move(0.5));
    expect(x(runtime, 'a')).toBe(130);
    expect(x(runtime, 'b')).toBe(300);
  });

  it('leaves the poses of the file as they are', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    const [a] = projectForFile(runtime.state).handles;
    expect(a && anchor(a)).toEqual([100, 150]);
    const saved = filedProject(runtime.state);
    send(runtime, { type: 'project-saved', project: saved }, move(0.2), move(0.7));
    expect(isUnsaved(runtime.state)).toBe(false);
    send(runtime, { type: 'timeline-opened', open: false });
    expect(x(runtime, 'a')).toBe(100);
    expect(documentOf(runtime.state).moment).toBeUndefined();
  });

  it('makes one step of each action, and undoes it where it was made', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    send(runtime, move(0.3), { type: 'undo-asked' });
    expect(keys(runtime, 'a')).toBeUndefined();
    expect(runtime.state.timeline.time).toBe(1);
    send(runtime, { type: 'redo-asked' }, move(1));
    expect(x(runtime, 'a')).toBe(160);
    send(runtime, { type: 'keys-selected', keys: [{ handle: 'a', time: 1 }] });
    send(
      runtime,
      { type: 'keys-dragged', by: 0.21, ended: false },
      { type: 'keys-dragged', by: 0.51, ended: true },
    );
    expect(keys(runtime, 'a')).toEqual([
      [0, 100],
      [1.5, 160],
    ]);
    expect(viewModel(runtime.state, en).undo).toBe('Move 1 key');
    send(runtime, { type: 'undo-asked' });
    expect(keys(runtime, 'a')?.[1]).toEqual([1, 160]);
  });

  it('plays by the clock, around the seam of a clip that repeats', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    send(runtime, move(1.9), { type: 'command-run', command: 'play' });
    expect(runtime.effects).toContainEqual({ type: 'run-clock', on: true });
    send(runtime, { type: 'clock-ticked', seconds: 0.2 }, { type: 'clock-ticked', seconds: 0.25 });
    expect(runtime.state.timeline.time).toBeCloseTo(0.35, 10);
    send(runtime, { type: 'command-run', command: 'play' });
    // Stopped at a frame.
    expect(runtime.state.timeline.time * 30).toBeCloseTo(Math.round(0.35 * 30), 10);
    expect(runtime.effects.at(-1)).not.toEqual({ type: 'run-clock', on: true });
  });

  it('is stopped by a press, and a drag then sets a key at a frame', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    send(runtime, move(0), { type: 'command-run', command: 'play' }, { type: 'clock-ticked', seconds: 0.21 });
    expect(x(runtime, 'a')).toBeCloseTo(112.6, 5);
    drag(runtime, [112, 150], [112, 180], [112, 200]);
    expect(runtime.state.timeline.playing).toBe(false);
    expect(keys(runtime, 'a')?.map(([time]) => time)).toEqual([0, 0.2, 1]);
  });

  it('stops at the end of a clip that plays once, and begins again there', () => {
    const runtime = opened();
    send(runtime, { type: 'clip-loop-chosen', loop: 'none' }, move(1.9), {
      type: 'command-run',
      command: 'play',
    });
    send(runtime, { type: 'clock-ticked', seconds: 0.25 });
    expect([runtime.state.timeline.time, runtime.state.timeline.playing]).toEqual([2, false]);
    send(runtime, { type: 'command-run', command: 'play' }, { type: 'clock-ticked', seconds: 0.1 });
    expect(runtime.state.timeline.time).toBeCloseTo(0.1, 10);
  });

  it('records a drag in real time, and makes the clip as long as it', () => {
    const runtime = opened();
    const to = (place: Vec): EditorEvent => ({
      type: 'press-moved',
      pointer: pointer(staged(runtime, place)),
    });
    const tick = { type: 'clock-ticked', seconds: 0.1 } as const;
    send(runtime, { type: 'record-held', held: true });
    send(runtime, { type: 'press-began', pointer: pointer(staged(runtime, [100, 150])), pans: false });
    send(runtime, to([110, 150]), to([100, 150]));
    for (let k = 1; k <= 25; k++) send(runtime, tick, to([100 + 20 * (k % 5), 150]));
    send(runtime, { type: 'press-ended', pointer: pointer(staged(runtime, [100, 150])) });
    send(runtime, { type: 'record-held', held: false });
    const recorded = keys(runtime, 'a') ?? [];
    expect(recorded[0]).toEqual([0, 100]);
    expect(recorded.at(-1)).toEqual([2.5, 100]);
    expect(recorded.length).toBeLessThan(12);
    expect(clip(runtime)?.duration).toBe(2.8);
    expect(runtime.state.timeline.time).toBe(0);
    expect(viewModel(runtime.state, en).undo).toBe('Record a');
    send(runtime, { type: 'undo-asked' });
    expect(keys(runtime, 'a')).toBeUndefined();
  });

  it('copies keys to another time, and says what does not fit', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    send(runtime, {
      type: 'keys-selected',
      keys: [
        { handle: 'a', time: 0 },
        { handle: 'a', time: 1 },
      ],
    });
    send(runtime, run('copy-keys'), move(0.5), run('paste-keys'));
    expect(keys(runtime, 'a')?.map(([time]) => time)).toEqual([0, 0.5, 1, 1.5]);
    send(runtime, move(1.2), run('paste-keys'));
    expect(keys(runtime, 'a')?.map(([time]) => time)).toEqual([0, 0.5, 1, 1.2, 1.5]);
    expect(englishNotice(runtime.state)?.text).toContain('1 key was left out');
  });

  it('eases and removes the selected keys', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [160, 150]);
    send(
      runtime,
      { type: 'keys-selected', keys: [{ handle: 'a', time: 0 }] },
      { type: 'keys-eased', ease: 'hold' },
    );
    expect(clip(runtime)?.tracks[0]?.keys[0]?.ease).toBe('hold');
    send(runtime, run('remove-keys'));
    expect(keys(runtime, 'a')).toEqual([[1, 160]]);
  });

  it('sets keys of the selected handles, and mirrors them to the other side', () => {
    const runtime = opened();
    send(
      runtime,
      move(1),
      { type: 'handles-selected', ids: ['a'] },
      { type: 'command-run', command: 'set-key' },
    );
    drag(runtime, [100, 150], [120, 150]);
    send(runtime, { type: 'keys-selected', keys: [{ handle: 'a', time: 1 }] }, run('mirror-keys'));
    expect(keys(runtime, 'b')).toEqual([[1, 280]]);
  });

  it('adds, names, duplicates and removes clips', () => {
    const runtime = opened();
    send(runtime, { type: 'clip-added', preset: 'sway' });
    const names = () => filedProject(runtime.state).clips?.map(({ name }) => name);
    expect(names()).toEqual(['clip', 'sway']);
    expect(runtime.state.timeline.playing).toBe(true);
    send(runtime, { type: 'clip-duplicated' }, { type: 'clip-renaming-switched', on: true });
    send(runtime, { type: 'clip-named', name: ' big  sway ' });
    expect(names()).toEqual(['clip', 'sway', 'big sway']);
    send(runtime, { type: 'clip-renaming-switched', on: true }, { type: 'clip-named', name: 'sway' });
    expect(englishNotice(runtime.state)?.text).toContain('Another clip is already called “sway”');
    send(runtime, { type: 'clip-removed' });
    expect([names(), runtime.state.timeline.clip]).toEqual([['clip', 'sway'], 'clip']);
    send(runtime, { type: 'undo-asked' });
    expect(names()).toEqual(['clip', 'sway', 'big sway']);
  });

  it('cuts the name of a copy where names end', () => {
    const runtime = opened();
    const names = () => filedProject(runtime.state).clips?.map(({ name }) => name);
    send(runtime, { type: 'clip-renaming-switched', on: true });
    send(runtime, { type: 'clip-named', name: 'é'.repeat(200) }, { type: 'clip-duplicated' });
    expect(names()).toEqual(['é'.repeat(200), 'é'.repeat(194)]);
    send(runtime, { type: 'clip-chosen', name: 'é'.repeat(200) }, { type: 'clip-duplicated' });
    expect(names()?.[2]).toBe(`${'é'.repeat(194)} 2`);
  });
});

describe('depths in the timeline', () => {
  /** The times of the keys of a handle that have a depth, and that depth. */
  const depths = (runtime: FakeRuntime, handle: string) =>
    clip(runtime)
      ?.tracks.find((track) => track.handle === handle)
      ?.keys.flatMap(({ time, depth }) => (depth === undefined ? [] : [[time, depth]])) ?? [];
  const shown = (runtime: FakeRuntime) => projectOf(runtime.state).handles.map(depthOf);
  const automatic = (runtime: FakeRuntime) => [...viewModel(runtime.state, en).automaticDepths];

  it('rise in the keys of the drag alone, from the key before on where nothing crosses', () => {
    const runtime = opened();
    send(runtime, move(1));
    drag(runtime, [100, 150], [300, 150]);
    expect(depths(runtime, 'a')).toEqual([
      [0, 1],
      [1, 1],
    ]);
    expect(depths(runtime, 'b')).toEqual([]);
    expect(automatic(runtime)).toEqual([['a', 1]]);
    // Other drags of the same handle, at its keys and between them.
    for (const time of [0.5, 1, 1.5]) {
      send(runtime, move(time));
      const at = x(runtime, 'a') ?? 0;
      drag(runtime, [at, 150], [at, 190]);
    }
    expect(keys(runtime, 'a')).toHaveLength(4);
    expect(depths(runtime, 'a')).toEqual([
      [0, 1],
      [1, 1],
    ]);
  });

  it('change no order at other keys, where parts cross too', () => {
    const runtime = opened();
    drag(runtime, [100, 150], [300, 150]);
    expect([depths(runtime, 'a'), shown(runtime)]).toEqual([[[0, 1]], [1, 0]]);
    send(runtime, move(1), { type: 'handles-selected', ids: ['b'] });
    send(runtime, { type: 'arrow-pressed', by: [50, 0] }, { type: 'arrow-pressed', by: [-50, 0] });
    expect(depths(runtime, 'b')).toEqual([
      [0, 0],
      [1, 2],
    ]);
    send(runtime, move(0.9));
    expect(shown(runtime)).toEqual([1, 0]);
    send(runtime, move(1.9));
    expect(shown(runtime)).toEqual([1, 2]);
    expect(automatic(runtime)).toEqual([
      ['a', 1],
      ['b', 2],
    ]);
  });

  it('that a person sets are not automatic, and change no other key that has one', () => {
    const runtime = opened();
    drag(runtime, [100, 150], [300, 150]);
    send(runtime, move(1), { type: 'command-run', command: 'forward' });
    const set = [
      [0, 1],
      [1, 2],
    ];
    expect(depths(runtime, 'a')).toEqual(set);
    expect(automatic(runtime)).toEqual([]);
    // Keys that are set leave depths as they are.
    for (const time of [1, 1.5]) send(runtime, move(time), { type: 'command-run', command: 'set-key' });
    expect(depths(runtime, 'a')).toEqual(set);
    expect(keys(runtime, 'a')).toHaveLength(3);
  });

  it('of a recorded drag hold from its beginning', () => {
    const runtime = opened();
    const to = (place: Vec): EditorEvent => ({
      type: 'press-moved',
      pointer: pointer(staged(runtime, place)),
    });
    const tick = { type: 'clock-ticked', seconds: 0.1 } as const;
    send(runtime, { type: 'record-held', held: true });
    send(runtime, { type: 'press-began', pointer: pointer(staged(runtime, [100, 150])), pans: false });
    for (let at = 100; at <= 300; at += 20) send(runtime, tick, to([at, 150]));
    send(runtime, { type: 'press-ended', pointer: pointer(staged(runtime, [300, 150])) });
    expect(keys(runtime, 'a')?.length).toBeGreaterThan(1);
    expect(depths(runtime, 'a')).toEqual([[0, 1]]);
  });
});
