import { expect, it } from 'vitest';
import { linesOf } from './figure';

it('a text is broken between words, in any script', () => {
  expect(linesOf('The shape keeps its form, as far as it can.', 16)).toEqual([
    'The shape keeps',
    'its form, as far',
    'as it can.',
  ]);
  const lines = linesOf('形状はできるだけ形を保ちます。ハンドルは自動で回ります。', 20);
  expect(lines.length).toBeGreaterThan(2);
  expect(lines.every((line) => line.length <= 11)).toBe(true);
  expect(linesOf('', 10)).toEqual([]);
});
