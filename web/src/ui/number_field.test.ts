import { describe, expect, it } from 'vitest';
import { numberOf } from './number_field';

describe('a typed number', () => {
  it.each([
    ['12', 12],
    [' 1.5 ', 1.5],
    ['1,5', 1.5],
    ['−3', -3],
    ['-3,25', -3.25],
    ['1e3', 1000],
    ['1,024', 1024],
    ['-12,000.5', -12000.5],
    ['0,125', 0.125],
    ['1,02', 1.02],
  ])('%j is %d', (text, number) => expect(numberOf(text)).toBe(number));

  it.each(['', '  ', 'abc', '1.2.3', '1 2'])('%j is none', (text) => expect(numberOf(text)).toBeNaN());
});
