import { describe, expect, it } from 'vitest';
import { pathOf } from './stored_files';

const SCOPE = 'https://c2warp.example/tools/editor/';
const HASHES = { '': 'sha256-a', 'assets/x.js': 'sha256-b' };

describe('the path of a stored file', () => {
  it.each([
    [SCOPE, ''],
    [`${SCOPE}index.html`, ''],
    [`${SCOPE}?src=cat.png#there`, ''],
    [`${SCOPE}assets/x.js`, 'assets/x.js'],
  ])('of %s is "%s"', (address, path) => {
    expect(pathOf(SCOPE, address, HASHES)).toBe(path);
  });

  it.each([
    `${SCOPE}assets/y.js`,
    `${SCOPE}assets/index.html`,
    `${SCOPE}toString`,
    'https://c2warp.example/assets/x.js',
    'https://other.example/tools/editor/assets/x.js',
  ])('is null for %s, which the worker leaves alone', (address) => {
    expect(pathOf(SCOPE, address, HASHES)).toBeNull();
  });
});
