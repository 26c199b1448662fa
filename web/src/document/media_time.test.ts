import { describe, expect, it } from 'vitest';
import { advanced, hasEnded, type MediaTime, standsStill } from './media_time';

const at = (time: number, rate: number, loops = false, length = 1): MediaTime => ({
  time,
  rate,
  length,
  loops,
});

describe('the time of a clip that plays', () => {
  it('stays within the clip', () => {
    expect(advanced(at(0.9, 1), 0.05)).toBe(0.9 + 0.05);
    expect(advanced(at(0.9, 2), 0.1)).toBe(1);
    expect(advanced(at(0.1, -1), 0.2)).toBe(0);
    expect(advanced(at(1, -0.5), 0)).toBe(1);
  });

  it('goes round in a loop, both ways', () => {
    expect(advanced(at(0.75, 1, true), 2.5)).toBe(0.25);
    expect(advanced(at(0.25, -1, true), 0.5)).toBe(0.75);
    expect(advanced(at(0, -1, true), 0.25)).toBe(0.75);
    expect(advanced(at(1, -1, true), 0.25)).toBe(0.75);
  });

  it('stops at once for a pose', () => {
    expect(advanced(at(0, 1, true, 0), 0.1)).toBe(0);
    expect(hasEnded(at(0, 1, true, 0))).toBe(true);
  });

  it('has neither ended nor begun before its clip is known', () => {
    expect(hasEnded(at(3, 1, false, Number.NaN))).toBe(false);
  });

  // As in the rules of HTML for "ended playback" and "direction of playback".
  it.each([
    // rate, at the start, in the middle, at the end
    [1, '', '', 'ended'],
    [2, '', '', 'ended'],
    [-1, 'still', '', ''],
    [-0.5, 'still', '', ''],
    [0, 'still', 'still', 'still ended'],
  ])('at a rate of %d, it stands still or has ended where media elements do', (rate, ...expected) => {
    const words = (of: MediaTime) =>
      [standsStill(of) && 'still', hasEnded(of) && 'ended'].filter(Boolean).join(' ');
    expect([0, 0.5, 1].map((time) => words(at(time, rate)))).toEqual(expected);
    // A loop has no end.
    const inLoop = rate === 0 ? 'still' : '';
    expect([0, 0.5, 1].map((time) => words(at(time, rate, true)))).toEqual([inLoop, inLoop, inLoop]);
  });
});
