import { expect, it } from 'vitest';
import { en } from './en/index';
import { shownName } from './shown_name';
import { say, worded } from './wording';

it('shows characters that are not drawn', () => {
  for (const [name, shown] of [
    ['left hand', 'left hand'],
    ['naïve 手 🖐\u{1f3fd}', 'naïve 手 🖐\u{1f3fd}'],
    ['\u001b[31mred\u009b0m', String.raw`\u{1b}[31mred\u{9b}0m`],
    ['a\tb\r\n', String.raw`a\tb\r\n`],
    ['\u202ednah\u2066\u200f\u2028\ufeff', String.raw`\u{202e}dnah\u{2066}\u{200f}\u{2028}\u{feff}`],
  ] as const) {
    expect(shownName(name)).toBe(shown);
    expect(shownName(shown)).toBe(shown);
  }
});

it('shows names in sentences the same way', () => {
  expect(worded(en, say('steps.renameClip', 'a\u202eb', 'c\nd'))).toBe(String.raw`Rename a\u{202e}b to c\nd`);
});
