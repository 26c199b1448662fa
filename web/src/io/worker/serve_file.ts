/** Carries out the requests of a port: one file. */
import type { WriteReply, WriteRequest } from '../writing';
import { Broken, Refused } from './refused';
import type { WrittenFile } from './written_file';

export function serveFile<File>(
  port: MessagePort,
  begin: () => WrittenFile<File> | Promise<WrittenFile<File>>,
): void {
  let file: WrittenFile<File> | null = null;
  /** Answers all requests after a refusal. */
  let refused: Refused | null = null;

  async function handle(request: WriteRequest): Promise<void> {
    if (request === 'abandon') {
      await file?.abandon();
      port.postMessage('gone' satisfies WriteReply<File>);
      return;
    }
    let answered = false;
    const reply = (message: WriteReply<File>) => {
      answered = true;
      port.postMessage(message);
    };
    try {
      if (refused) throw refused;
      file ??= await begin();
      if (request === 'end') {
        reply({ file: await file.finish() });
        return;
      }
      // The page sends the next pixels while these are written.
      reply('taken');
      await file.write(request.rgba);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      refused = error;
      if (!answered) reply({ refused: error.reason, fault: error.fault });
      if (error instanceof Broken) throw error;
    }
  }

  let writing: Promise<void> = Promise.resolve();
  port.onmessage = ({ data }: MessageEvent<WriteRequest>) => {
    writing = writing
      .then(() => handle(data))
      .catch((error: unknown) => {
        // A fault: the page receives it as an error of this worker, and replaces the worker.
        port.close();
        reportError(error);
      });
  };
}
