/** Small files, and ways to bring them to the editor. */
import { encode } from 'fast-png';
import type { Editor } from './editor';

/** Returns a small picture: an opaque disc, or a transparent one. */
export function disc(size: number, radius = size * 0.4): Buffer {
  const data = new Uint8Array(size * size * 4);
  for (let pixel = 0; pixel < size * size; pixel++) {
    const [x, y] = [(pixel % size) + 0.5 - size / 2, Math.floor(pixel / size) + 0.5 - size / 2];
    data.set([200, 80, 40, Math.hypot(x, y) < radius ? 255 : 0], pixel * 4);
  }
  return Buffer.from(encode({ width: size, height: size, data, channels: 4 }));
}

export const png = (name: string, buffer: Buffer) => ({ name, mimeType: 'image/png', buffer });

export const project = (value: unknown, name = 'other.c2warp.json') => ({
  name,
  mimeType: 'application/json',
  buffer: Buffer.from(typeof value === 'string' ? value : JSON.stringify(value)),
});

/** A file as Playwright chooses it. */
export type GivenFile = ReturnType<typeof png>;

/** Dispatches `event` on the editor with files, like a drop or a paste. */
export async function bring(
  editor: Editor,
  event: 'drop' | 'paste',
  ...files: readonly GivenFile[]
): Promise<void> {
  await editor.page.locator('c2-warp').evaluate(
    (element, { event, files }) => {
      const transfer = new DataTransfer();
      for (const { name, type, base64 } of files) {
        const content = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
        transfer.items.add(new File([content], name, { type }));
      }
      const init = { bubbles: true, cancelable: true, composed: true };
      element.dispatchEvent(
        event === 'drop'
          ? new DragEvent('drop', { ...init, dataTransfer: transfer })
          : new ClipboardEvent('paste', { ...init, clipboardData: transfer }),
      );
    },
    {
      event,
      files: files.map(({ name, mimeType: type, buffer }) => ({
        name,
        type,
        base64: buffer.toString('base64'),
      })),
    },
  );
}
