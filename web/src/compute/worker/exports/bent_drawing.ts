/** A drawing with bent paths. */
import type { DrawingOrder, ExportRequest } from '../../exporting_messages';
import { SolvedProject } from '../../generated/c2warp_export';

/** @throws Error for a drawing that cannot be bent. */
export function bentDrawing(
  { project, width, height }: ExportRequest,
  { drawing, grow, clip, time }: DrawingOrder,
  rgba: Uint8Array,
  tell: (part: number) => void,
): string {
  const solved = new SolvedProject(project, width, height, rgba, tell);
  return solved.bent(drawing.svg, drawing.width, drawing.height, grow, clip ?? undefined, time);
}
