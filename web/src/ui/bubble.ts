/** The hint that points to a handle. */
import { html, type TemplateResult } from 'lit';
import { type Camera, toStage } from '../geometry/camera';
import type { Hint } from './model';

/** A bubble at the place that it points to. Its words are the page's, of whatever language. */
export function bubble({ text, at, above }: Hint, camera: Camera): TemplateResult {
  const [x, y] = toStage(camera, at);
  return html`<p class="hint bubble ${above ? 'above' : ''}" part="hint" lang="" .style=${`left: ${x}px; top: ${y}px`}>${text}</p>`;
}
