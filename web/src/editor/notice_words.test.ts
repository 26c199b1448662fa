import { describe, expect, it } from 'vitest';
import { en } from '../texts/en';
import { inEnglish } from './english';
import { notOpenedWords } from './notice_words';

const { outsidePicture, outsideLasso, noOtherSide, noCounterpart } = en.notices;
const notOpened = (files: readonly string[]) => inEnglish(notOpenedWords(files));

describe('a notice', () => {
  it('names the handles that lie partly outside', () => {
    expect(outsidePicture(['point a'])).toBe('Part of point a lies outside the picture and has no effect.');
    expect(outsideLasso(['bar a'])).toBe('Part of bar a lies outside the lasso and has no effect.');
    expect(outsidePicture(['a', 'b'])).toBe('Parts of a and b lie outside the picture and have no effect.');
    expect(outsidePicture(['a', 'b', 'c'])).toBe(
      'Parts of a, b and c lie outside the picture and have no effect.',
    );
  });

  it('names a few of many handles', () => {
    const six = ['a', 'b', 'c', 'd', 'e', 'f'];
    expect(noOtherSide(six)).toBe('The mirrored positions of a, b, c, d, e and f are outside the picture.');
    expect(noCounterpart([...six, 'g'])).toBe('No handles here match the poses of a, b, c, d, e and 2 more.');
    expect(outsidePicture([...six, 'g', 'h'])).toBe(
      'Parts of a, b, c, d, e and 3 more lie outside the picture and have no effect.',
    );
  });

  it('names one of the files that were not opened', () => {
    expect(notOpened(['b.png'])).toBe('Only one picture opens at a time. b.png was not opened.');
    expect(notOpened(['b.png', 'c.png', 'd.png'])).toBe(
      'Only one picture opens at a time. b.png and 2 more were not opened.',
    );
  });
});
