/** The hint that points to a handle. */
import { html, type TemplateResult } from 'lit-html';
import type { Hint } from '../editor/view_model';
import { type Camera, toStage } from '../geometry/camera';

/** A bubble that points to its place. The page chooses its words and their language. */
export function bubble({ text, at, place }: Hint, camera: Camera): TemplateResult {
  const [x, y] = toStage(camera, at);
  const style = `left: ${x}px; top: ${y}px; --_along: ${place.along}`;
  return html`<p class="hint bubble ${place.side}" part="hint" lang="" .style=${style}>${text}</p>`;
}
