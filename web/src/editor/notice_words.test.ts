import { describe, expect, it } from 'vitest';
import { en } from '../texts/en';
import { inEnglish } from './english';
import { notOpenedWords } from './notice_words';

const { outsidePicture, outsideLasso, noOtherSide, noCounterpart } = en.notices;
const notOpened = (files: readonly string[]) => inEnglish(notOpenedWords(files));

describe('a notice', () => {
  it('names the handles that lie partly outside', () => {
    expect(outsidePicture(['point a'])).toBe('Part of point a lies outside the picture and moves nothing.');
    expect(outsideLasso(['bar a'])).toBe('Part of bar a lies outside the lasso and moves nothing.');
    expect(outsidePicture(['a', 'b'])).toBe('Parts of a and b lie outside the picture and move nothing.');
    expect(outsidePicture(['a', 'b', 'c'])).toBe(
      'Parts of a, b and c lie outside the picture and move nothing.',
    );
  });

  it('names a few of many handles', () => {
    const six = ['a', 'b', 'c', 'd', 'e', 'f'];
    expect(noOtherSide(six)).toBe('The picture has nothing on the other side of a, b, c, d, e and f.');
    expect(noCounterpart([...six, 'g'])).toBe('No handles here match the poses of a, b, c, d, e and 2 more.');
    expect(outsidePicture([...six, 'g', 'h'])).toBe(
      'Parts of a, b, c, d, e and 3 more lie outside the picture and move nothing.',
    );
  });

  it('names one of the files that were not opened', () => {
    expect(notOpened(['b.png'])).toBe('Only one picture opens at a time: b.png was not opened.');
    expect(notOpened(['b.png', 'c.png', 'd.png'])).toBe(
      'Only one picture opens at a time: b.png and 2 more were not opened.',
    );
  });
});
