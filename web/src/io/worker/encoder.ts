/** Worker: writes picture files from rows. */
import type { BeginFile } from '../encoding';
import { CanvasFile } from './canvas_file';
import { PngFile } from './png_file';
import { serveFile } from './serve_file';

declare const self: DedicatedWorkerGlobalScope;

self.onmessage = ({ data: { settings, port } }: MessageEvent<BeginFile>) =>
  serveFile(port, () => (settings.type === 'image/png' ? new PngFile(settings) : new CanvasFile(settings)));
