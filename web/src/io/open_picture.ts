/**
 * Opens pictures: a worker reads them and keeps their pixels. All editors of a page share the worker.
 *
 * If the worker lacks something, or cannot start, the page reads the picture itself.
 */
import { C2WarpError } from '../error';
import { sharedWorker } from '../start_worker';
import type { Display } from './display';
import type { Luminance } from './luminance';
import type { PictureRequest, ReadReply, ReadRequest } from './picture_messages';
import { PixelRelay } from './pixel_relay';
import type { PictureFacts } from './read_picture';
import picture from './worker/picture?worker&url';

/** The pixels of a picture, wherever they are: straight alpha, RGBA, rows from the top. */
export interface PixelSource {
  readonly width: number;
  readonly height: number;
  /** Sends a copy of the pixels to a port, or null if the picture was released. */
  sendTo(port: MessagePort): void;
}

export interface OpenPicture {
  readonly facts: PictureFacts;
  /** The copies for the screen, with the size of the picture itself. */
  readonly texture: Display & { readonly width: number; readonly height: number };
  readonly pixels: PixelSource;
  /** Never resolves if the worker that keeps the pixels is gone. */
  luminance(): Promise<Luminance | null>;
  /** Frees the pixels and closes the bitmaps. */
  release(): void;
}

/**
 * Returns the picture in a file. The caller releases it.
 *
 * @throws C2WarpError if the file is not a picture, is incomplete, or has an unsupported size.
 * @throws AbortError if the signal is aborted.
 */
export async function openPicture(file: Blob, signal: AbortSignal): Promise<OpenPicture> {
  signal.throwIfAborted();
  return (await openInWorker(file, signal)) ?? (await openInPage(file, signal));
}

const pictureWorker = sharedWorker(picture);

/** Null if the page's policy forbids the worker. */
function permittedWorker(): Worker | null {
  try {
    return pictureWorker();
  } catch {
    return null;
  }
}

/** Resolves to null if the page must open the picture. */
async function openInWorker(file: Blob, signal: AbortSignal): Promise<OpenPicture | null> {
  const reader = permittedWorker();
  if (!reader) return null;
  const { port1: port, port2 } = new MessageChannel();
  const request = (message: PictureRequest, transfer: Transferable[] = []) =>
    port.postMessage(message, transfer);
  const release = () => {
    request({ kind: 'release' });
    port.close();
  };
  const ended = new AbortController();
  try {
    const reply = await new Promise<ReadReply>((resolve, reject) => {
      port.onmessage = ({ data }) => resolve(data);
      const lacking = () => resolve({ kind: 'lacking' });
      reader.addEventListener('error', lacking, { signal: ended.signal });
      signal.addEventListener('abort', () => reject(signal.reason), { signal: ended.signal });
      const message: ReadRequest = { file, port: port2 };
      reader.postMessage(message, [port2]);
    });
    if (reply.kind === 'read') {
      const { facts, display } = reply;
      const relay = new PixelRelay((to) => request({ kind: 'send', to }, [to]));
      const used = new AbortController();
      reader.addEventListener('error', () => relay.lose(), { signal: used.signal });
      return opened(
        facts,
        display,
        (to) => relay.sendTo(to),
        () => askedLuminance((to) => request({ kind: 'luminance', to }, [to])),
        () => {
          used.abort();
          release();
        },
      );
    }
    release();
    if (reply.kind === 'lacking') return null;
    const { code, message, wording } = reply;
    throw new C2WarpError(code, message, { wording });
  } catch (error) {
    release();
    throw error;
  } finally {
    ended.abort();
  }
}

async function openInPage(file: Blob, signal: AbortSignal): Promise<OpenPicture> {
  // Few browsers need this code.
  const [{ readPicture }, { pagePlatform }, { luminanceOf }] = await Promise.all([
    import('./read_picture'),
    import('./page_platform'),
    import('./luminance'),
  ]);
  const { facts, rgba, bitmap, preview } = await readPicture(file, pagePlatform, signal);
  const { width, height } = facts;
  const luminance = async () => luminanceOf(rgba, width, height);
  return opened(facts, { bitmap, preview }, (to) => to.postMessage(rgba), luminance);
}

function askedLuminance(ask: (to: MessagePort) => void): Promise<Luminance | null> {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.onmessage = ({ data }: MessageEvent<Luminance | null>) => {
      port1.close();
      resolve(data);
    };
    ask(port2);
  });
}

function opened(
  facts: PictureFacts,
  display: Display,
  sendTo: PixelSource['sendTo'],
  luminance: OpenPicture['luminance'],
  free: () => void = () => {},
): OpenPicture {
  const { width, height } = facts;
  return {
    facts,
    texture: { ...display, width, height },
    pixels: { width, height, sendTo },
    luminance,
    release() {
      display.bitmap.close();
      display.preview?.close();
      free();
    },
  };
}
