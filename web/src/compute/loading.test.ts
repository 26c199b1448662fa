import { afterEach, expect, it, vi } from 'vitest';
import { compiled } from './loading';

const ADDRESS = new URL('https://c2warp.example/media/solver.wasm');

afterEach(() => vi.unstubAllGlobals());

const answering = (answer: () => Promise<Response>) => vi.stubGlobal('fetch', answer);

it('a file that cannot be loaded is named by its full address', async () => {
  answering(() => Promise.reject(new TypeError('Failed to fetch')));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} is out of reach`);
});

it('an error status of the server is reported with the address', async () => {
  answering(async () => new Response(null, { status: 403 }));
  await expect(compiled(ADDRESS)).rejects.toThrow(`the server answered 403 for ${ADDRESS}`);
});

it('a page instead of the file is reported with the address', async () => {
  answering(async () => new Response('', { headers: { 'content-type': 'text/html' } }));
  await expect(compiled(ADDRESS)).rejects.toThrow(`a web page instead of ${ADDRESS}`);
});

it('a truncated file is reported with the address', async () => {
  answering(async () => new Response(Uint8Array.of(0, 97)));
  await expect(compiled(ADDRESS)).rejects.toThrow(`${ADDRESS} is incomplete, or cannot run here`);
});
