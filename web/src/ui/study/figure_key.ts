/** The key of a figure to be saved: colours with their meaning, in one line. */
import { type SVGTemplateResult, svg } from 'lit-html';
import { widthOf } from './figure';

/** Width of a letter, about. */
const LETTER = 6.6;

/** @param entries The class of each colour, and its meaning. */
export function figureKey(entries: readonly (readonly [kind: string, meaning: string])[]): SVGTemplateResult {
  let at = 0;
  return svg`${entries.map(([kind, meaning]) => {
    const x = at;
    at += 32 + LETTER * widthOf(meaning);
    return svg`<rect class="weight ${kind}" x=${x} y="-10" width="11" height="11" rx="3"/><text class="tick" x=${x + 17}>${meaning}</text>`;
  })}`;
}
