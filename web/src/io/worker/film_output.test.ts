import { expect, it } from 'vitest';
import { BlobOutput } from './film_output';

const bytes = (text: string) => new TextEncoder().encode(text);

it('a film in blobs takes bytes for places that were written before', async () => {
  const output = new BlobOutput('image/webp');
  await output.write(0, bytes('size of '));
  await output.write(8, bytes('the film'));
  await output.write(0, bytes('SIZE'));
  const film = await output.finish();
  expect(film.type).toBe('image/webp');
  expect(await film.text()).toBe('SIZE of the film');
});
