/** The drawings of Mermaid diagrams. Names depend on the source of a diagram, so outdated drawings are never shown. */
import { createHash } from 'node:crypto';
import { join } from 'node:path';
import { ROOT } from './steps.mjs';

export const THEMES = /** @type {const} */ (['light', 'dark']);

/**
 * The file of a drawing.
 * @param {string} source The text of the diagram.
 * @param {(typeof THEMES)[number]} theme
 */
export function drawingOf(source, theme) {
  const hash = createHash('sha256').update(source.trim()).digest('hex').slice(0, 12);
  return join(ROOT, 'web/site/diagrams', `${hash}-${theme}.svg`);
}

/**
 * The arrows of a diagram in words, for those who do not see it.
 * @param {string} source
 */
export const arrowsOf = (source) =>
  source
    .split('\n')
    .filter((line) => line.includes('-->'))
    .map((line) =>
      line
        .replaceAll(/\[".*?"\]|\(?\[.*?\]\)?|\|.*?\|/g, '')
        .replaceAll('-->', '→')
        .replaceAll(/\s+/g, ' ')
        .trim(),
    )
    .join(', ');
