import { expect, it } from 'vitest';
import { arrowsOf, drawingOf } from './diagrams.mjs';

it('a drawing is named by its source', () => {
  expect(drawingOf('a --> b\n', 'dark')).toBe(drawingOf('a --> b', 'dark'));
  expect(drawingOf('a --> b', 'dark')).not.toBe(drawingOf('a --> c', 'dark'));
});

it('arrows are described in words', () => {
  const source = 'flowchart\n  one["<b>x</b>"] -->|tells| two([y])\n  three["z"]\n  two --> three --> four\n';
  expect(arrowsOf(source)).toBe('one → two, two → three → four');
});
