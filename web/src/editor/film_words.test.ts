import { expect, it } from 'vitest';
import { framesText, roughSize, roughTime, timeLeftText } from './film_texts';

it('sizes and times are told roughly', () => {
  expect([300, 4_400, 999_000, 3_400_000, 74_000_000].map(roughSize)).toEqual([
    '1 kB',
    '4 kB',
    '1000 kB',
    '3 MB',
    '75 MB',
  ]);
  expect([1, 12, 58, 200].map(roughTime)).toEqual(['a few seconds', '10 s', '1 min', '3 min']);
  expect([2, 41].map(timeLeftText)).toEqual(['a few seconds left', 'about 40 s left']);
  expect([1, 1200].map(framesText)).toEqual(['1 frame', '1,200 frames']);
});
