import { expect, it } from 'vitest';
import { inEnglish } from './english';
import { roughSize, roughTime, timeLeft } from './film_words';

it('sizes and times are approximate', () => {
  expect([300, 4_400, 999_000, 3_400_000, 74_000_000].map(roughSize)).toEqual([
    '1 kB',
    '4 kB',
    '1000 kB',
    '3 MB',
    '75 MB',
  ]);
  const rough = [1, 12, 58, 200].map((seconds) => inEnglish(roughTime(seconds)));
  expect(rough).toEqual(['a few seconds', '10 s', '1 min', '3 min']);
  const left = [2, 41].map((seconds) => inEnglish(timeLeft(seconds)));
  expect(left).toEqual(['a few seconds left', 'about 40 s left']);
});
