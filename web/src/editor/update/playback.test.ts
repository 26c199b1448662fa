import { describe, expect, it } from 'vitest';
import { anchor } from '../../document/handle';
import type { Clip } from '../../document/project';
import type { Vec } from '../../geometry/vec';
import type { EditorEvent } from '../events';
import { FakeRuntime, PAGE } from '../fake_runtime';
import { hasEnded } from '../played_clip';
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
    expect([x(runtime), runtime.state.playback.playing, hasEnded(runtime.state)]).toEqual([300, false, true]);
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
    expect([runtime.state.playback.time, hasEnded(runtime.state)]).toEqual([4, true]);
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
