import { expect, it } from 'vitest';
import { hashesOf } from './service_worker.mjs';

it('lists the files of the page by their hashes, without sources of samples', () => {
  const contents = {
    'samples/cat.svg': '<svg/>',
    'samples/cat.png': 'b',
    'index.html': 'a',
    'favicon.svg': '',
  };
  const hashes = hashesOf(contents);
  expect(Object.keys(hashes)).toEqual(['', 'favicon.svg', 'samples/cat.png']);
  // As `echo -n a | sha256sum | xxd -r -p | base64` prints it.
  expect(hashes['']).toBe('sha256-ypeBEsobvcr6wjGzmiPcTaeG7/gUfE5yuYB3ha/uSLs=');
});
