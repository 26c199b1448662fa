import { describe, expect, test } from 'vitest';
import type { Pose } from '../compute/posed_picture';
import { Glide } from './glide';

const pose = (...motions: number[]): Pose =>
  ({ motions: new Float32Array(motions), crossed: () => null }) as unknown as Pose;

describe('a glide', () => {
  test('leads from one pose to the other, and ends', () => {
    const glide = new Glide();
    const [from, to] = [pose(0, 8), pose(4, 0)];
    glide.begin(from, to, 1000);
    expect([...glide.at(to, 1000).motions]).toEqual([0, 8]);
    const [x = 0] = glide.at(to, 1100).motions;
    expect(x > 2 && x < 4).toBe(true);
    expect(glide.gliding).toBe(true);
    expect(glide.at(to, 1300)).toBe(to);
    expect(glide.gliding).toBe(false);
  });

  test('ends with the next pose', () => {
    const glide = new Glide();
    const next = pose(1, 1);
    glide.begin(pose(0, 8), pose(4, 0), 1000);
    expect(glide.at(next, 1010)).toBe(next);
    expect(glide.gliding).toBe(false);
  });

  test('a second one begins where the first is', () => {
    const glide = new Glide();
    const [middle, end] = [pose(4, 0), pose(0, 0)];
    glide.begin(pose(0, 8), middle, 1000);
    const before = glide.at(middle, 1100).motions;
    glide.begin(middle, end, 1100);
    expect(glide.at(end, 1100).motions).toEqual(before);
  });
});
