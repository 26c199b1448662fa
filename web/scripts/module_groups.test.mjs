import { expect, it } from 'vitest';
import { moduleGroups } from './module_groups.mjs';

const text = (/** @type {string} */ words) => [words.length, ...Buffer.from(words)];
const section = (/** @type {number} */ id, /** @type {number[]} */ content) => [
  id,
  content.length,
  ...content,
];

it('groups the functions of a module by their names, after those that it imports', () => {
  const imports = [2, ...text('m'), ...text('f'), 0, 0, ...text('m'), ...text('t'), 1, 0x70, 1, 1, 9];
  const bodies = [2, 3, 0, 1, 0x0b, 2, 0, 0x0b];
  const names = [2, 1, ...text('c2warp::pose::Poser::pose'), 2, ...text('core::slice::sort::stable')];
  const module = Uint8Array.from([
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...section(2, imports),
    ...section(10, bodies),
    ...section(11, [1, 2, 3]),
    ...section(0, [...text('name'), 1, names.length, ...names]),
  ]);
  const sizes = Object.fromEntries(moduleGroups(module).map(({ name, raw }) => [name, raw]));
  expect(sizes).toEqual({
    'poses, folds and clips': 3,
    'sorts of the standard library': 2,
    'data: tables, texts': 3,
  });
});
