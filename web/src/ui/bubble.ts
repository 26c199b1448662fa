/** The hint that points to a handle. */
import { html, type TemplateResult } from 'lit-html';
import type { Hint } from '../editor/view_model';
import { type Camera, toStage } from '../geometry/camera';

/** A bubble that points to its place. The page chooses its words and their language. */
export function bubble({ text, at, above }: Hint, camera: Camera): TemplateResult {
  const [x, y] = toStage(camera, at);
  return html`<p class="hint bubble ${above ? 'above' : ''}" part="hint" lang="" .style=${`left: ${x}px; top: ${y}px`}>${text}</p>`;
}
