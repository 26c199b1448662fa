/** Worker: bakes one rig. The only other worker file that imports generated code. */
import type { BakeReply, BakeRequest } from '../baking_messages';
import init, { bake } from '../generated/c2warp_export';

declare const self: DedicatedWorkerGlobalScope;

self.onmessage = async ({ data }: MessageEvent<BakeRequest>) => {
  try {
    const { module, project, width, height, pixels, file } = data;
    await init({ module_or_path: module });
    const rgba = await received(pixels);
    const rig = bake(project, width, height, rgba, file, (part: number) => post({ part }));
    post({ rig: rig as Uint8Array<ArrayBuffer> }, [rig.buffer]);
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
      else reject(new Error('the pixels of the picture are gone: open the picture again'));
    };
  });
}

function post(reply: BakeReply, transfer: Transferable[] = []): void {
  self.postMessage(reply, transfer);
}
