/**
 * Sends a picture's pixels from the worker that keeps them to the ports that request copies. A worker that dies closes
 * its ports silently, and the requester would wait forever: the page detects this and responds.
 */
export class PixelRelay {
  readonly #ask: (to: MessagePort) => void;
  /** The ports that wait for a copy. */
  readonly #waiting = new Set<MessagePort>();
  #lost = false;

  /** @param ask has the worker send a copy, or null without one. */
  constructor(ask: (to: MessagePort) => void) {
    this.#ask = ask;
  }

  /** Sends a copy to a port, or null if there is none. A copy is transferred: nothing of it stays here. */
  sendTo(port: MessagePort): void {
    if (this.#lost) {
      port.postMessage(null);
      return;
    }
    const { port1, port2 } = new MessageChannel();
    this.#waiting.add(port);
    port1.onmessage = ({ data }: MessageEvent<Uint8Array<ArrayBuffer> | null>) => {
      port1.close();
      if (this.#waiting.delete(port)) port.postMessage(data, data ? [data.buffer] : []);
    };
    this.#ask(port2);
  }

  /** The worker is gone, and the pixels with it. */
  lose(): void {
    this.#lost = true;
    for (const port of this.#waiting) port.postMessage(null);
    this.#waiting.clear();
  }
}
