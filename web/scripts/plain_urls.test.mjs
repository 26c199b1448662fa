import { expect, it } from 'vitest';
import { plainUrls } from './plain_urls.mjs';

it('a nested address becomes a single one', () => {
  const nested = 'a=new URL(new URL(`solver.wasm`,import.meta.url).href,``+import.meta.url),b';
  expect(plainUrls(nested)).toBe('a=new URL("./solver.wasm",import.meta.url),b');
});

it('addresses of files are relative strings in double quotes', () => {
  expect(plainUrls('new URL(`worker.js`,import.meta.url).href')).toBe(
    'new URL("./worker.js",import.meta.url).href',
  );
  const other = "new URL('../element/worker.js', import.meta.url)";
  expect(plainUrls(other)).toBe('new URL("../element/worker.js",import.meta.url)');
});

it('computed addresses stay', () => {
  const computed = 'new URL(e,import.meta.url);new URL(`$name.js`,import.meta.url)';
  expect(plainUrls(computed)).toBe(computed);
});
