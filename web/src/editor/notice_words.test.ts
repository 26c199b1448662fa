import { describe, expect, it } from 'vitest';
import { noCounterpartText, noOtherSideText, notOpenedText, outsideText } from './notice_texts';

describe('a notice', () => {
  it('names the handles that lie partly outside', () => {
    expect(outsideText(['point a'])).toBe('Part of point a lies outside the picture and moves nothing.');
    expect(outsideText(['bar a'], true)).toBe('Part of bar a lies outside the lasso and moves nothing.');
    expect(outsideText(['a', 'b'])).toBe('Parts of a and b lie outside the picture and move nothing.');
    expect(outsideText(['a', 'b', 'c'])).toBe(
      'Parts of a, b and c lie outside the picture and move nothing.',
    );
  });

  it('names a few of many handles', () => {
    const six = ['a', 'b', 'c', 'd', 'e', 'f'];
    expect(noOtherSideText(six)).toBe('The picture has nothing on the other side of a, b, c, d, e and f.');
    expect(noCounterpartText([...six, 'g'])).toBe(
      'No handles here match the poses of a, b, c, d, e and 2 more.',
    );
    expect(outsideText([...six, 'g', 'h'])).toBe(
      'Parts of a, b, c, d, e and 3 more lie outside the picture and move nothing.',
    );
  });

  it('names one of the files that were not opened', () => {
    expect(notOpenedText(['b.png'])).toBe('Only one picture opens at a time: b.png was not opened.');
    expect(notOpenedText(['b.png', 'c.png', 'd.png'])).toBe(
      'Only one picture opens at a time: b.png and 2 more were not opened.',
    );
  });
});
