import { describe, expect, it } from 'vitest';
import { noCounterpartText, noOtherSideText, notOpenedText, outsideText } from './notice_texts';

describe('a notice', () => {
  it('names the handles that lie partly outside', () => {
    expect(outsideText(['point a'])).toBe(
      'Only the part of point a on the picture bends it: the rest lies beside it.',
    );
    expect(outsideText(['bar a'], true)).toBe(
      'Only the part of bar a inside the lasso bends it: the rest lies beside it.',
    );
    expect(outsideText(['a', 'b'])).toBe('Only the parts on the picture bend it of a and b.');
    expect(outsideText(['a', 'b', 'c'])).toBe('Only the parts on the picture bend it of a, b and c.');
  });

  it('names a few of many handles', () => {
    const six = ['a', 'b', 'c', 'd', 'e', 'f'];
    expect(noOtherSideText(six)).toBe('There is nothing to hold on the other side of a, b, c, d, e and f.');
    expect(noCounterpartText([...six, 'g'])).toBe(
      'There are no handles here for the poses of a, b, c, d, e and 2 more.',
    );
    expect(outsideText([...six, 'g', 'h'])).toBe(
      'Only the parts on the picture bend it of a, b, c, d, e and 3 more.',
    );
  });

  it('names one of the files that were not opened', () => {
    expect(notOpenedText(['b.png'])).toBe('One picture is open at a time: b.png was not opened.');
    expect(notOpenedText(['b.png', 'c.png', 'd.png'])).toBe(
      'One picture is open at a time: b.png and 2 more were not opened.',
    );
  });
});
