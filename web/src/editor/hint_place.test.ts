import { describe, expect, it } from 'vitest';
import { hintPlace } from './hint_place';

const FREE = { min: [0, 0], max: [600, 400] } as const;
const MIDDLE = [300, 200] as const;
const sideAt = (x: number, y: number, text = 'Drag a hand', free: typeof FREE | Small = FREE) =>
  hintPlace(text, [x, y], free, MIDDLE)?.side ?? null;
type Small = { readonly min: readonly [number, number]; readonly max: readonly [number, number] };

describe('the place of a hint', () => {
  it('is at the right of its handle, or else where there is room', () => {
    expect(sideAt(350, 100)).toBe('right');
    expect(sideAt(560, 300)).toBe('above');
    expect(sideAt(560, 20)).toBe('below');
    expect(sideAt(560, 30, 'Drag', { min: [0, 8], max: [600, 52] })).toBe('left');
  });

  it('leaves the middle of the picture free', () => {
    expect(sideAt(200, 200)).toBe('above');
    expect(sideAt(300, 200)).toBe('right');
    expect(sideAt(590, 240, 'Drag a hand', { min: [480, 190], max: [600, 270] })).toBeNull();
  });

  it('stays within the free area above its handle', () => {
    expect(hintPlace('Drag a hand', [590, 300], FREE, MIDDLE)?.along).toBeCloseTo(0.9, 1);
    expect(hintPlace('ハンドルをドラッグしてください', [590, 300], FREE, MIDDLE)?.along).toBeGreaterThan(0.8);
  });

  it('has room for a long text in several lines', () => {
    const long = 'Drag a hand, an arm or a foot, and see how the rest of the figure follows it';
    expect(sideAt(350, 100, long)).toBe('right');
    expect(sideAt(350, 20, long)).toBe('below');
  });
});
