import { expect, it } from 'vitest';
import { opaqueOver } from './opaque_over';

it('translucent pixels mix with the background, opaque ones stay', () => {
  const rgba = Uint8Array.of(10, 20, 30, 255, 10, 20, 30, 0, 0, 255, 100, 51);
  opaqueOver('#ff8000', rgba);
  expect(Array.from(rgba)).toEqual([10, 20, 30, 255, 255, 128, 0, 255, 204, 153, 20, 255]);
});
