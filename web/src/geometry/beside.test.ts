import { expect, it } from 'vitest';
import { beside } from './beside';

it('is placed after the anchor, else before it, and always within the range', () => {
  expect(beside(10, 2, 30, [0, 100])).toBe(12);
  expect(beside(90, 2, 30, [0, 100])).toBe(58);
  expect(beside(50, 2, 70, [0, 100])).toBe(0);
  expect(beside(-20, 2, 30, [0, 100])).toBe(0);
  expect(beside(140, 2, 30, [0, 100])).toBe(70);
  expect(beside(50, 2, 130, [0, 100])).toBe(0);
});
