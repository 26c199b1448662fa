import { describe, expect, it } from 'vitest';
import { symmetryOf } from './symmetry';
import { distance, type Vec } from './vec';

const box = { min: [10, 20], max: [110, 220] } as const;

describe('the axes of symmetry', () => {
  it('go through the middle of a rectangle', () => {
    expect(symmetryOf(box, () => true)).toEqual({ x: 60, y: 120 });
  });

  it('are only those that the shape has', () => {
    const head = (at: Vec) => distance(at, [60, 70]) < 50 || at[1] > 150;
    expect(symmetryOf(box, head)).toEqual({ x: 60, y: null });
    const corner = ([x, y]: Vec) => x < 60 && y < 120;
    expect(symmetryOf(box, corner)).toEqual({ x: null, y: null });
  });

  it('bear small differences of a drawn figure', () => {
    const notched = ([x, y]: Vec) => !(x < 20 && y < 40);
    expect(symmetryOf(box, notched)).toEqual({ x: 60, y: 120 });
  });

  it('are none for an empty shape', () => {
    expect(symmetryOf(box, () => false)).toEqual({ x: null, y: null });
  });
});
