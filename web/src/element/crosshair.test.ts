import { describe, expect, it } from 'vitest';
import { Crosshair } from './crosshair';
import type { Viewing } from './viewing';

/** A stage of 100 × 80 CSS pixels; the picture is shown at twice its size, 20 CSS pixels from the left. */
const viewing = {
  camera: { scale: 2, x: 20, y: 0 },
  stage: { width: 100, height: 80 },
  middle: [50, 40],
} as unknown as Viewing;

describe('the crosshair', () => {
  it('starts in the middle of the view, or where it is told', () => {
    expect(new Crosshair(viewing).move([1, 0], undefined)).toEqual([17, 20]);
    expect(new Crosshair(viewing).move([1, 0], [5, 5])).toEqual([7, 5]);
  });

  it('goes on from where it is', () => {
    const crosshair = new Crosshair(viewing);
    expect(crosshair.place).toEqual([15, 20]);
    crosshair.move([0, 1], [5, 5]);
    crosshair.move([0, 1], [30, 30]);
    expect(crosshair.place).toEqual([5, 9]);
  });

  it('stays on the stage', () => {
    const crosshair = new Crosshair(viewing);
    expect(crosshair.move([-10, -10], [0, 0])).toEqual([-10, 0]);
    expect(crosshair.move([100, 100], undefined)).toEqual([40, 40]);
  });
});
