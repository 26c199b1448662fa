import { describe, expect, it } from 'vitest';
import { advanced } from './clock';

describe('the time of a player', () => {
  it('stops at the end, and at the beginning when it runs backwards', () => {
    expect(advanced(0.9, 0.05, 1, false)).toEqual({ time: 0.9 + 0.05, stops: false });
    expect(advanced(0.9, 0.2, 1, false)).toEqual({ time: 1, stops: true });
    expect(advanced(0.1, -0.2, 1, false)).toEqual({ time: 0, stops: true });
  });

  it('goes round in a loop, both ways', () => {
    expect(advanced(0.75, 2.5, 1, true)).toEqual({ time: 0.25, stops: false });
    expect(advanced(0.25, -0.5, 1, true)).toEqual({ time: 0.75, stops: false });
  });

  it('stops at once for a pose', () => {
    expect(advanced(0, 0.1, 0, true)).toEqual({ time: 0, stops: true });
  });
});
