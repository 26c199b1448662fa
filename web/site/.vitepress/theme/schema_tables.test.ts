import { expect, it } from 'vitest';
import { tablesOf } from './schema_tables';

it('a schema becomes tables of keys, alternatives and words', () => {
  const [whole, shape, ease] = tablesOf({
    title: 'Whole',
    description: 'All\nof it.\n\n```\nlet example = 1;\n```',
    required: ['shapes'],
    properties: {
      shapes: { description: 'Some.', items: { $ref: '#/$defs/Shape' } },
      scale: { type: 'number', default: 1 },
    },
    $defs: {
      Shape: { oneOf: [{ description: 'Round.', properties: { kind: { const: 'circle' } } }] },
      Ease: { oneOf: [{ const: 'hold', description: 'A jump.' }] },
    },
  });
  expect(whole).toMatchObject({ name: 'Whole', description: 'All of it.' });
  expect(whole?.parts[0]?.rows).toEqual([
    {
      key: 'shapes',
      type: [{ text: 'list of ' }, { text: 'Shape', table: 'Shape' }],
      meaning: 'Some.',
      standard: undefined,
      required: true,
    },
    { key: 'scale', type: [{ text: 'number' }], meaning: '', standard: '1', required: false },
  ]);
  expect(shape?.parts).toMatchObject([
    { title: 'Round.', rows: [{ key: 'kind', type: [{ text: '"circle"' }] }] },
  ]);
  expect(ease?.words).toEqual([{ word: 'hold', meaning: 'A jump.' }]);
});
