import { expect, it } from 'vitest';
import { choicesFor, DEFAULT_CHOICES } from './export_choices';

it('exports an SVG of a drawing alone, and never its covered part', () => {
  const svg = { ...DEFAULT_CHOICES, format: 'svg', area: 'covered' } as const;
  expect(choicesFor(svg, false)).toEqual({ ...svg, format: 'png' });
  expect(choicesFor(svg, true)).toEqual({ ...svg, area: 'grown' });
  expect(choicesFor(DEFAULT_CHOICES, true)).toBe(DEFAULT_CHOICES);
});
