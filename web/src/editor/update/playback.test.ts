import { describe, expect, it } from 'vitest';
import { anchor } from '../../document/handle';
import type { Clip } from '../../document/project';
import type { Vec } from '../../geometry/vec';
import type { EditorEvent } from '../events';
import { FakeRuntime, PAGE } from '../fake_runtime';
import { hasPlayed, playedDuration } from '../played_clip';
import { documentOf, projectOf } from '../state';
import { projectForFile } from './exporting';

const key = (time: number, x: number) => ({ time, posed: [x, 150] as const });
const CLIP: Clip = {
  name: 'go',
  duration: 2,
  loop: 'none',
  tracks: [{ handle: 'a', keys: [key(0, 100), key(2, 300)] }],
};

function opened(page: Partial<typeof PAGE> = {}, clip = CLIP): FakeRuntime {
  const runtime = new FakeRuntime({ ...PAGE, posable: true, ...page });
  runtime.dispatch({ type: 'page-changed', page: PAGE });
  runtime.open();
  const place: Vec = [100, 150];
  runtime.dispatch({ type: 'handle-added', handle: { id: 'a', kind: 'point', rest: place, posed: place } });
  runtime.solve();
  runtime.dispatch({ type: 'project-adopted', project: { ...projectOf(runtime.state), clips: [clip] } });
  runtime.dispatch({ type: 'page-changed', page: { ...PAGE, posable: true, ...page } });
  return runtime;
}

const send = (runtime: FakeRuntime, ...events: readonly EditorEvent[]) => {
  for (const event of events) runtime.dispatch(event);
};
const tick = (seconds: number): EditorEvent => ({ type: 'clock-ticked', seconds });
const x = (runtime: FakeRuntime) => projectOf(runtime.state).handles.map((handle) => anchor(handle)[0])[0];
const emitted = (runtime: FakeRuntime) =>
  runtime.notified.filter((type) => ['play', 'pause', 'timeupdate', 'ended'].includes(type));

const pointer = (runtime: FakeRuntime, [x, y]: Vec) => {
  const { scale, x: left, y: top } = runtime.state.view.camera;
  return {
    stage: [x * scale + left, y * scale + top] as const,
    shift: false,
    alt: false,
    free: false,
    coarse: false,
  };
};

describe('a clip that the page plays', () => {
  it('poses the handles, ends, and begins again', () => {
    const runtime = opened();
    send(runtime, { type: 'play-asked' }, tick(0.5));
    expect([x(runtime), runtime.state.playback.time]).toEqual([150, 0.5]);
    send(runtime, tick(1), tick(1));
    expect([x(runtime), runtime.state.playback.playing, hasPlayed(runtime.state)]).toEqual([
      300,
      false,
      true,
    ]);
    expect(emitted(runtime)).toEqual(['play', 'timeupdate', 'timeupdate', 'timeupdate', 'pause', 'ended']);
    send(runtime, { type: 'play-asked' }, tick(0.1));
    expect(runtime.state.playback.time).toBeCloseTo(0.1, 12);
  });

  it('goes round where the page says so, in both directions', () => {
    const runtime = opened({ loop: true });
    send(runtime, { type: 'seek-asked', time: 1.9 }, { type: 'play-asked' }, tick(0.2));
    expect(runtime.state.playback.time).toBeCloseTo(0.1, 12);
    send(runtime, { type: 'rate-asked', rate: -2 }, tick(0.1));
    expect(runtime.state.playback.time).toBeCloseTo(1.9, 12);
  });

  it('plays there and back where it alternates', () => {
    const runtime = opened({}, { ...CLIP, loop: 'alternate' });
    send(runtime, { type: 'play-asked' }, tick(3));
    expect(runtime.state.playback.playing).toBe(true);
    send(runtime, tick(1.1));
    expect([runtime.state.playback.time, hasPlayed(runtime.state)]).toEqual([4, true]);
  });

  const LOOPS = ['none', 'repeat', 'alternate'] as const;
  const RATES = [1, -1, 2, -0.5, 0] as const;
  const table = LOOPS.flatMap((kind) => RATES.map((rate) => [kind, rate] as const));

  it.each(table)('of the loop "%s" begins and ends at a rate of %d as a video does', (kind, rate) => {
    const clip = { ...CLIP, loop: kind };
    const length = playedDuration(clip);
    const forwards = ['play', 'timeupdate', 'pause', 'ended'];
    for (const at of [0, length / 2, length]) {
      const runtime = opened({}, clip);
      send(runtime, { type: 'rate-asked', rate }, { type: 'seek-asked', time: at });
      const isAtEnd = at === length && rate >= 0;
      // A time at the end has ended, also without playing.
      expect([hasPlayed(runtime.state), emitted(runtime)]).toEqual([
        isAtEnd,
        isAtEnd ? ['timeupdate', 'ended'] : ['timeupdate'],
      ]);
      runtime.effects.length = 0;
      send(runtime, { type: 'play-asked' });
      expect(runtime.state.playback).toMatchObject({ playing: true, time: isAtEnd ? 0 : at });
      for (let k = 0; k < 100; k++) if (runtime.state.playback.playing) send(runtime, tick(0.25));
      // At the beginning it waits to be played forwards. It neither pauses nor ends.
      const time = rate > 0 ? length : rate < 0 || isAtEnd ? 0 : at;
      const { playback } = runtime.state;
      expect([playback.time, playback.playing, hasPlayed(runtime.state)]).toEqual([
        time,
        rate <= 0,
        rate > 0,
      ]);
      const events = rate > 0 ? forwards : rate < 0 && at > 0 ? ['play', 'timeupdate'] : ['play'];
      expect([...new Set(emitted(runtime))]).toEqual(events);
      send(runtime, { type: 'rate-asked', rate: 1 }, { type: 'play-asked' }, tick(0.25));
      expect(runtime.state.playback.time).toBe(rate > 0 ? 0.25 : time + 0.25);
    }
  });

  it.each(RATES)('of a page that loops goes round at a rate of %d', (rate) => {
    for (const at of [0, 1, 2]) {
      const runtime = opened({ loop: true });
      send(runtime, { type: 'rate-asked', rate }, { type: 'seek-asked', time: at }, { type: 'play-asked' });
      send(runtime, tick(0.5));
      const next = at + rate / 2;
      const time = rate === 0 ? at : (next + 2) % 2;
      expect([runtime.state.playback.time, hasPlayed(runtime.state)]).toEqual([time, false]);
      expect(emitted(runtime)).not.toContain('ended');
    }
  });

  it('needs no clock while it stands still', () => {
    const runtime = opened();
    const clocks = () => runtime.effects.flatMap((effect) => (effect.type === 'run-clock' ? effect.on : []));
    send(runtime, { type: 'rate-asked', rate: -1 }, { type: 'play-asked' });
    expect(clocks()).toEqual([]);
    send(runtime, { type: 'rate-asked', rate: 1 }, tick(0.5));
    expect(clocks()).toEqual([true]);
    send(runtime, { type: 'rate-asked', rate: -1 }, tick(0.75));
    expect([...clocks(), runtime.state.playback.time]).toEqual([true, false, 0]);
    send(runtime, { type: 'page-changed', page: { ...PAGE, posable: true, loop: true } });
    expect(clocks()).toEqual([true, false, true]);
  });

  it('leaves the file and the history as they are', () => {
    const runtime = opened();
    send(runtime, { type: 'play-asked' }, tick(1), { type: 'pause-asked' });
    expect(projectForFile(runtime.state).handles.map((handle) => anchor(handle)[0])).toEqual([100]);
    expect(runtime.state.document.history.past).toHaveLength(2);
    expect(projectOf(runtime.state).clips).toEqual([CLIP]);
  });

  it('lets a person take a handle, which eases back', () => {
    const runtime = opened();
    send(runtime, { type: 'play-asked' }, tick(0.5));
    send(runtime, { type: 'press-began', pointer: pointer(runtime, [150, 150]), pans: false });
    send(runtime, { type: 'press-moved', pointer: pointer(runtime, [150, 200]) });
    send(runtime, { type: 'press-moved', pointer: pointer(runtime, [150, 250]) });
    const y = () => anchor(projectOf(runtime.state).handles[0] as never)[1];
    expect(y()).toBeGreaterThan(200);
    const held = y();
    send(runtime, tick(0.1));
    expect(y()).toBe(held);
    send(runtime, { type: 'press-ended', pointer: pointer(runtime, [150, 250]) }, tick(0.25));
    expect(y()).toBeLessThan(held);
    expect(y()).toBeGreaterThan(150);
    send(runtime, tick(0.3));
    expect(y()).toBe(150);
    expect(runtime.state.playback.playing).toBe(true);
    expect(runtime.state.document.history.past).toHaveLength(2);
  });

  it('becomes the document’s own pose with a step while it is paused', () => {
    const runtime = opened();
    send(runtime, { type: 'seek-asked', time: 1 }, { type: 'handles-selected', ids: ['a'] });
    send(runtime, { type: 'arrow-pressed', by: [10, 0] });
    expect(x(runtime)).toBe(210);
    expect(documentOf(runtime.state).moment).toBeUndefined();
    expect(projectOf(runtime.state).clips).toEqual([CLIP]);
    expect(runtime.state.playback.active).toBe(false);
  });

  it('plays automatically only without reduced motion', () => {
    const runtime = opened({ autoplay: true });
    send(
      runtime,
      { type: 'media-changed', media: { ...runtime.state.media, still: true } },
      { type: 'autoplay-asked' },
    );
    expect(runtime.state.playback.playing).toBe(false);
    send(
      runtime,
      { type: 'media-changed', media: { ...runtime.state.media, still: false } },
      { type: 'autoplay-asked' },
    );
    expect(runtime.state.playback.playing).toBe(true);
  });
});
