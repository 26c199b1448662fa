import { describe, expect, it } from 'vitest';
import { type Cards, insetsOf } from './insets';
import type { Sheet } from './view_state';

/** What the cards leave free of an element of this size, CSS pixels. */
const free = (width: number, height: number, cards: Pick<Cards, 'coarse' | 'sheet'>) => {
  const bars = cards.coarse ? 98 : 82;
  const { top, right, bottom, left } = insetsOf({
    stage: { width, height: height - bars },
    bare: null,
    ...cards,
  });
  return { width: width - left - right, height: height - bars - top - bottom };
};

describe('the space between the cards', () => {
  it('is most of the stage, however small the element', () => {
    for (const coarse of [false, true])
      for (const sheet of ['none', 'line'] as const)
        for (const [width, height] of [
          [320, 240],
          [390, 280],
          [500, 240],
          [500, 320],
          [500, 360],
          [640, 240],
        ] as const) {
          const room = free(width, height, { coarse, sheet });
          const name = `${width} × ${height}, ${coarse ? 'coarse' : 'fine'}`;
          expect(room.width, name).toBeGreaterThanOrEqual(130);
          expect(room.height / (height - (coarse ? 98 : 82)), name).toBeGreaterThan(0.75);
        }
  });

  it('is the layout of the whole element, above the timeline too', () => {
    const beside = (height: number, timeline: boolean) =>
      insetsOf({ stage: { width: 1000, height }, coarse: false, sheet: 'none', timeline, bare: null }).left;
    // 800 px high, with 226 px of timeline: the tools have one column.
    expect(beside(800 - 82 - 226, true)).toBe(beside(800 - 82, false));
    expect(beside(600 - 82 - 226, true)).toBe(134);
    expect(beside(480 - 82 - 201, true)).toBe(198);
    const phone = (height: number, timeline: boolean) =>
      insetsOf({ stage: { width: 320, height }, coarse: true, sheet: 'none', timeline, bare: null }).bottom;
    expect(phone(640 - 98 - 268, true)).toBe(phone(640 - 98, false));
  });

  it('grows with the height of a phone', () => {
    for (const coarse of [false, true]) {
      const heights = [240, 280, 320, 360, 480, 780].map(
        (height) => free(390, height, { coarse, sheet: 'none' }).height,
      );
      expect(heights).toEqual(heights.toSorted((a, b) => a - b));
    }
  });

  it('is more where no sheet is open', () => {
    const room = (sheet: Sheet) => free(390, 780, { coarse: true, sheet }).height;
    expect(room('none')).toBe(room('line') + 60);
    expect(room('tall')).toBeGreaterThan(350);
  });

  it('leaves only a rim for handles without cards, and none for a plain picture', () => {
    const around = (bare: 'handles' | 'picture', coarse: boolean) =>
      insetsOf({ stage: { width: 390, height: 300 }, coarse, sheet: 'line', bare });
    expect(around('handles', false)).toEqual({ top: 16, right: 16, bottom: 16, left: 16 });
    expect(around('handles', true)).toEqual({ top: 24, right: 24, bottom: 24, left: 24 });
    expect(around('picture', true)).toEqual({ top: 0, right: 0, bottom: 0, left: 0 });
  });
});
