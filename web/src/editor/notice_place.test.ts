import { describe, expect, it } from 'vitest';
import type { Handle } from '../document/project';
import { FakeRuntime } from './fake_runtime';
import { noticeIsAside } from './notice_place';

/** Handles at these places of the stage, in its middle, `y` from the top. */
function aside(width: number, height: number, ...places: readonly number[]): boolean {
  const runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'stage-resized', size: { width, height }, typing: false });
  runtime.dispatch({ type: 'camera-moved', camera: { scale: 1, x: 0, y: 0 } });
  places.forEach((y, k) => {
    const place = [width / 2 - 50, y] as const;
    const handle: Handle = {
      id: `${k}`,
      kind: 'point',
      rest: place,
      posed: place,
      rotation: 0,
      scale: 1,
      depth: 0,
    };
    runtime.dispatch({ type: 'handle-added', handle });
  });
  return noticeIsAside(runtime.state);
}

describe('a notice', () => {
  it('keeps its usual edge while no handle is there', () => {
    expect(aside(1000, 700, 300)).toBe(false);
    expect(aside(400, 700, 300, 650)).toBe(false);
  });

  it('goes to the opposite edge, away from handles', () => {
    expect(aside(1000, 700, 300, 650)).toBe(true);
    expect(aside(400, 700, 50)).toBe(true);
  });

  it('keeps its usual edge if handles are at both', () => {
    expect(aside(1000, 700, 50, 650)).toBe(false);
    expect(aside(400, 700, 50, 650)).toBe(false);
  });
});
