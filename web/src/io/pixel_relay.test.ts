import { describe, expect, it } from 'vitest';
import { PixelRelay } from './pixel_relay';

/** Asks for a copy of the pixels. */
function asked(relay: PixelRelay): Promise<unknown> {
  const { port1, port2 } = new MessageChannel();
  relay.sendTo(port2);
  return new Promise((resolve) => {
    port1.onmessage = ({ data }) => {
      port1.close();
      resolve(data);
    };
  });
}

describe('the relay of pixels', () => {
  it('hands the copies of the worker on', async () => {
    const relay = new PixelRelay((to) => to.postMessage(Uint8Array.of(1, 2)));
    expect(await asked(relay)).toEqual(Uint8Array.of(1, 2));
    expect(await asked(new PixelRelay((to) => to.postMessage(null)))).toBeNull();
  });

  it('answers for a worker that dies, before and after a request', async () => {
    const relay = new PixelRelay((to) => to.close());
    const waiting = asked(relay);
    relay.lose();
    expect(await waiting).toBeNull();
    expect(await asked(relay)).toBeNull();
  });
});
