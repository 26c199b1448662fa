/** The comparison as a figure to be saved: three pictures with their names. */

import { nothing, svg } from 'lit-html';
import { VARIANTS } from '../../document/variants';
import type { Texts } from '../../texts/texts';
import type { VariantPictures } from '../study_view';
import { type Drawn, linesOf } from './figure';

/** Each picture has the form of its canvas: 3 to 4. */
const PICTURE = { width: 270, height: 360 } as const;
const GAP = 20;
const LINE = 17;
/** Characters that fit below a picture. */
const LINE_LENGTH = 42;

export function compareFigure(pictures: VariantPictures, { compare }: Texts): Drawn {
  const { width, height } = PICTURE;
  const columns = VARIANTS.map((variant, at) => {
    const url = pictures[variant];
    return svg`<g transform="translate(${GAP + at * (width + GAP)} ${GAP})">
      ${url === null ? nothing : svg`<image width=${width} height=${height} href=${url}/>`}
      <text class="strong" y=${height + LINE}>${compare.names[variant]}</text>
      ${linesOf(compare.notes[variant], LINE_LENGTH).map(
        (line, below) => svg`<text class="tick" y=${height + (below + 2) * LINE}>${line}</text>`,
      )}
    </g>`;
  });
  const content = svg`${columns}`;
  return { content, width: 3 * width + 4 * GAP, height: height + 2 * GAP + 4 * LINE };
}
