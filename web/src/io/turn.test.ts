import { expect, it } from 'vitest';
import type { Orientation } from './formats/exif';
import { turned } from './turn';

/** A picture with one letter a pixel. */
const picture = (...rows: string[]) => ({
  width: rows[0]?.length ?? 0,
  height: rows.length,
  rgba: Uint8Array.from([...rows.join('')].flatMap((letter) => [letter.charCodeAt(0), 0, 0, 255])),
});

it.each<[Orientation, string[]]>([
  [1, ['abc', 'def']],
  [2, ['cba', 'fed']],
  [3, ['fed', 'cba']],
  [4, ['def', 'abc']],
  [5, ['ad', 'be', 'cf']],
  [6, ['da', 'eb', 'fc']],
  [7, ['fc', 'eb', 'da']],
  [8, ['cf', 'be', 'ad']],
])('turns orientation %i upright', (orientation, rows) => {
  expect(turned(picture('abc', 'def'), orientation)).toEqual(picture(...rows));
});
