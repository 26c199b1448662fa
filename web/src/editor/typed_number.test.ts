import { describe, expect, it } from 'vitest';
import { typedNumber } from './typed_number';

describe('a typed number', () => {
  it.each([
    ['12', 12],
    [' 1.5 ', 1.5],
    ['1,5', 1.5],
    ['.5', 0.5],
    ['5.', 5],
    ['+3', 3],
    ['-3,25', -3.25],
    ['- 3', -3],
    ['1e3', 1000],
    ['1,024', 1024],
    ['-12,000.5', -12000.5],
    ['1.024', 1.024],
    ['1.024,5', 1024.5],
    ['1.024.000', 1024000],
    ['0,125', 0.125],
    ['0.125', 0.125],
    ['1,02', 1.02],
  ])('%j is %d', (text, number) => expect(typedNumber(text)).toBe(number));

  it.each([
    ['−3', 'the minus sign'],
    ['－３', 'full-width digits and minus'],
    ['–3', 'an en dash'],
    ['‑3', 'a hyphen that does not break'],
    ['ー３', 'the long vowel of a Japanese keyboard'],
    ['\u200e-3', 'a mark of the direction'],
    ['\u061c-٣', 'an Arabic digit'],
    ['−۳', 'a Persian digit'],
  ])('%j is −3: %s', (text) => expect(typedNumber(text)).toBe(-3));

  it.each([
    ['１２．５', 'full-width digits and point'],
    ['１２，５', 'a full-width comma'],
    ['１２。５', 'an ideographic full stop'],
    ['１２、５', 'an ideographic comma'],
    ['\u300012.5\u3000', 'ideographic spaces'],
    ['١٢٫٥', 'Arabic digits'],
    ['۱۲٫۵', 'Persian digits'],
  ])('%j is 12.5: %s', (text) => expect(typedNumber(text)).toBe(12.5));

  it.each([
    ['1 024,5', 'a space'],
    ['1\u00a0024,5', 'a no-break space'],
    ['1\u202f024,5', 'a narrow no-break space'],
    ['1\u2009024.5', 'a thin space'],
    ['１\u3000０２４．５', 'an ideographic space'],
    ['1’024.5', 'an apostrophe'],
    ["1'024.5", 'a typewriter apostrophe'],
    ['١٬٠٢٤٫٥', 'the Arabic separator'],
  ])('%j is 1024.5, in groups by %s', (text) => expect(typedNumber(text)).toBe(1024.5));

  it.each(['', '  ', 'abc', '1.2.3', '1 2', '1 20 000', '1,2,3', '--1', '-', '.', '0x10', 'Infinity', '½'])(
    '%j cannot be read',
    (text) => expect(typedNumber(text)).toBeNaN(),
  );
});
