import { expect, test } from 'vitest';
import { shortened } from './shortened';

test('a long word keeps its beginning and its end, in whole characters; others stay', () => {
  const name = `holiday-${'x'.repeat(60)}-final.c2warp.json:`;
  expect(shortened(`${name} format: expected`)).toBe('holiday-xxxxxxxxxxxxx…l.c2warp.json: format: expected');
  expect(shortened('Left hand is open.')).toBe('Left hand is open.');
  expect(shortened('🫖'.repeat(40))).toBe(`${'🫖'.repeat(21)}…${'🫖'.repeat(14)}`);
});
