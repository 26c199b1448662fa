/** A JPEG or WebP file, by the browser's own encoders. They need the whole picture on a canvas. */
import { say } from '../../texts/wording';
import type { FileSettings } from '../encoding';
import { opaqueOver } from './opaque_over';
import { Refused } from './refused';
import type { WrittenFile } from './written_file';

const TOO_LARGE = say('errors.writing.reasons.canvasTooLarge');
const UNSUPPORTED = say('errors.writing.reasons.formatUnsupported');

export class CanvasFile implements WrittenFile<Blob> {
  readonly #settings: FileSettings;
  readonly #canvas: OffscreenCanvas;
  readonly #context: OffscreenCanvasRenderingContext2D;
  #top = 0;

  /** @throws Refused if the browser has no canvas of this size. */
  constructor(settings: FileSettings) {
    const { width, height } = settings;
    this.#settings = settings;
    this.#canvas = new OffscreenCanvas(width, height);
    // On the CPU, where rows are put and read.
    const context = this.#canvas.getContext('2d', { willReadFrequently: true });
    if (!context) throw new Refused(TOO_LARGE);
    this.#context = context;
  }

  async write(rgba: Uint8Array<ArrayBuffer>): Promise<void> {
    const { type, width, background } = this.#settings;
    if (type === 'image/jpeg') opaqueOver(background, rgba);
    const bytes = new Uint8ClampedArray(rgba.buffer, rgba.byteOffset, rgba.length);
    const rows = new ImageData(bytes, width);
    this.#context.putImageData(rows, 0, this.#top);
    this.#top += rows.height;
  }

  async finish(): Promise<Blob> {
    const { type, quality } = this.#settings;
    const file = await this.#canvas.convertToBlob({ type, quality }).catch(() => {
      throw new Refused(TOO_LARGE);
    });
    // Browsers write a PNG instead of a format that they lack.
    if (file.type !== type) throw new Refused(UNSUPPORTED);
    return file;
  }

  abandon(): void {
    this.#canvas.width = 1;
    this.#canvas.height = 1;
  }
}
