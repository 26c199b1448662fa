import { describe, expect, it } from 'vitest';
import { clearPlace } from './clear_place';
import type { Vec } from './vec';

const label = { width: 20, height: 10 };
const stage = { width: 100, height: 100 };
const places: readonly [Vec, ...Vec[]] = [
  [50, 70],
  [50, 30],
];

describe('the place of a label', () => {
  it('is the first one that is clear of dots', () => {
    expect(clearPlace(places, label, [], 5, stage)).toEqual([50, 70]);
    expect(clearPlace(places, label, [[41, 70]], 5, stage)).toEqual([50, 30]);
    expect(clearPlace(places, label, [[66, 70]], 5, stage)).toEqual([50, 70]);
  });

  it('is on the stage before it is clear', () => {
    const dots: readonly Vec[] = [
      [50, 70],
      [50, 30],
    ];
    expect(clearPlace(places, label, dots, 5, stage)).toEqual([50, 70]);
    expect(clearPlace(places, label, dots, 5, { width: 100, height: 60 })).toEqual([50, 30]);
    expect(clearPlace(places, label, [], 5, { width: 10, height: 10 })).toEqual([50, 70]);
  });
});
