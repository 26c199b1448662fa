import { afterEach, expect, it, vi } from 'vitest';
import { compiled } from './loading';

const ADDRESS = new URL('https://c2warp.example/media/solver.wasm');

afterEach(() => vi.unstubAllGlobals());

const answering = (answer: () => Promise<Response>) => vi.stubGlobal('fetch', answer);

it('a file that cannot be loaded is named by its full address', async () => {
  answering(() => Promise.reject(new TypeError('Failed to fetch')));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} does not come: is the network there`);
});

it('an error status of the server is reported with the address', async () => {
  answering(async () => new Response(null, { status: 403 }));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} answers 403`);
});

it('a page instead of the file is reported with the address', async () => {
  answering(async () => new Response('', { headers: { 'content-type': 'text/html' } }));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} is not there: a page is, in its place`);
});

it('a truncated file is reported with the address', async () => {
  answering(async () => new Response(Uint8Array.of(0, 97)));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} came incomplete, or cannot run here`);
});
