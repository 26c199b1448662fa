/** A drawing with bent paths. */
import type { BentDrawing, DrawingOrder, ExportRequest } from '../../exporting_messages';
import { SolvedProject } from '../../generated/c2warp_export';

/** @throws Error for a drawing that cannot be bent. */
export function bentDrawing(
  { project, width, height }: ExportRequest,
  { svg, grow, clip, time }: DrawingOrder,
  rgba: Uint8Array,
  onProgress: (part: number) => void,
): BentDrawing {
  const bent = new SolvedProject(project, width, height, rgba, onProgress).bent(
    svg,
    grow,
    clip ?? undefined,
    time,
  );
  return { svg: bent.svg, remarks: bent.remarks };
}
