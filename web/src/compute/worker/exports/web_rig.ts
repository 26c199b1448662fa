/** A rig for web pages. */
import type { ExportRequest, WebRigOrder } from '../../exporting_messages';
import { bake } from '../../generated/c2warp_export';

/** @throws Error for clips that no rig can hold. */
export const webRig = (
  { project, width, height }: ExportRequest,
  { file, posable }: WebRigOrder,
  rgba: Uint8Array,
  onProgress: (part: number) => void,
): Uint8Array<ArrayBuffer> =>
  bake(project, width, height, rgba, file, posable, onProgress) as Uint8Array<ArrayBuffer>;
