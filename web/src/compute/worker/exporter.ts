/** Worker: makes one export with a solver. Each kind of export is a file in `exports`. */
import type { ExportReply, ExportRequest, PictureRequest } from '../exporting_messages';
import init from '../generated/c2warp_export';
import { bentDrawing } from './exports/bent_drawing';
import { drawnPicture } from './exports/drawn_picture';
import { engineRig } from './exports/engine_rig';
import { mapFile } from './exports/map_file';
import { webRig } from './exports/web_rig';

declare const self: DedicatedWorkerGlobalScope;

self.onmessage = async ({ data: request }: MessageEvent<ExportRequest | PictureRequest>) => {
  try {
    await init({ module_or_path: request.module });
    if (!('pixels' in request)) {
      post({ made: drawnPicture(request.order) });
      return;
    }
    const rgba = await received(request.pixels);
    const onProgress = (part: number) => post({ part });
    const { order } = request;
    if (order.kind === 'web-rig') {
      const rig = webRig(request, order, rgba, onProgress);
      post({ made: rig }, [rig.buffer]);
    } else if (order.kind === 'map') {
      const file = mapFile(request, order, rgba, onProgress);
      post({ made: file }, [file.buffer]);
    } else if (order.kind === 'drawing') {
      post({ made: bentDrawing(request, order, rgba, onProgress) });
    } else {
      const rig = engineRig(request, order, rgba, onProgress);
      post(
        { made: rig },
        rig.files.map(({ bytes }) => bytes.buffer),
      );
    }
  } catch (error) {
    // Anything but an error of the module itself is a panic.
    const refused = error instanceof Error && !(error instanceof WebAssembly.RuntimeError);
    post({ refused: refused ? error.message : null });
  }
};

/** The pixels that arrive at a port. @throws Error if the picture was released. */
function received(port: MessagePort): Promise<Uint8Array> {
  return new Promise((resolve, reject) => {
    port.onmessage = ({ data }: MessageEvent<Uint8Array | null>) => {
      port.close();
      if (data) resolve(data);
      else reject(new Error('the pixels of the picture are no longer in memory: open the picture again'));
    };
  });
}

function post(reply: ExportReply, transfer: Transferable[] = []): void {
  self.postMessage(reply, transfer);
}
