/** Worker: writes picture files from rows. */
import type { BeginFile, FileReply, FileRequest, FileSettings } from '../encoding';
import { CanvasFile } from './canvas_file';
import { PngFile } from './png_file';
import { Refused } from './refused';
import type { RowsFile } from './rows_file';

declare const self: DedicatedWorkerGlobalScope;

const begun = (settings: FileSettings): RowsFile =>
  settings.type === 'image/png' ? new PngFile(settings) : new CanvasFile(settings);

self.onmessage = ({ data: { settings, port } }: MessageEvent<BeginFile>) => {
  let file: RowsFile | null = null;
  /** Answers all requests after a refusal. */
  let refused: string | null = null;

  async function handle(request: FileRequest): Promise<void> {
    if (request === 'abandon') {
      file?.abandon();
      port.close();
      return;
    }
    let answered = false;
    const reply = (message: FileReply) => {
      answered = true;
      port.postMessage(message);
    };
    try {
      if (refused !== null) throw new Refused(refused);
      file ??= begun(settings);
      if (request === 'end') {
        reply({ file: await file.finish() });
        return;
      }
      // The page sends the next rows while these are written.
      reply('taken');
      await file.write(request.rgba);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      refused = error.message;
      if (!answered) reply({ refused });
    }
  }

  let writing: Promise<void> = Promise.resolve();
  port.onmessage = ({ data }: MessageEvent<FileRequest>) => {
    writing = writing
      .then(() => handle(data))
      .catch((error: unknown) => {
        // A fault: the page hears of it as an error of this worker, and replaces it.
        port.close();
        reportError(error);
      });
  };
};
