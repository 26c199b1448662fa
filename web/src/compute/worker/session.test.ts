import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { initSync, Session } from '../generated/c2warp';

const SIZE = 32;

function project(...rest: [number, number][]): string {
  return JSON.stringify({
    format: 'c2warp/1',
    image: { src: '', width: SIZE, height: SIZE },
    samples: 100,
    handles: rest.map((at, i) => ({ id: `h${i}`, kind: 'point', rest: at, posed: at })),
  });
}

/** The number of handles of the last solve. */
function handles(session: Session): number {
  const solution = session.solution();
  const report = JSON.parse(solution.report) as { point_handles: number };
  solution.free();
  return report.point_handles;
}

function solve(session: Session, text: string): void {
  session.begin(text);
  while (session.advance() !== undefined);
}

describe('Session', () => {
  beforeAll(() => {
    initSync({ module: readFileSync(new URL('../generated/c2warp_bg.wasm', import.meta.url)) });
  });

  it('keeps the last solution until another solve has finished', () => {
    const session = new Session();
    session.set_picture(SIZE, SIZE, new Uint8Array(4 * SIZE * SIZE).fill(255));
    expect(() => session.solution()).toThrow('no solution yet');
    solve(session, project([8, 16]));
    expect(handles(session)).toBe(1);
    // Misspelt, for another picture, with a handle beside the picture.
    expect(() => session.begin('{"format": "c2warp/1", "handels": []}')).toThrow('handels');
    expect(handles(session)).toBe(1);
    expect(() => session.begin(project([8, 16]).replace('"width":32', '"width":33'))).toThrow('33');
    expect(session.advance()).toBeUndefined();
    expect(handles(session)).toBe(1);
    expect(() => solve(session, project([8, 16], [8, 99]))).toThrow('h1');
    expect(session.advance()).toBeUndefined();
    expect(handles(session)).toBe(1);
    session.begin(project([8, 16], [24, 16]));
    expect(session.advance()).toBe('domain');
    expect(handles(session)).toBe(1);
    while (session.advance() !== undefined);
    expect(handles(session)).toBe(2);
    session.free();
  });

  it('has no solution where the first solve is refused', () => {
    const session = new Session();
    session.set_picture(SIZE, SIZE, new Uint8Array(4 * SIZE * SIZE).fill(255));
    expect(() => solve(session, project([8, 99]))).toThrow('h0');
    expect(session.advance()).toBeUndefined();
    expect(() => session.solution()).toThrow('no solution yet');
    session.free();
  });
});
