/** The whole of the editor as one template: stage, bars, panel, and what floats over them. */

import { html, nothing, type TemplateResult } from 'lit';
import { type Camera, toStage } from '../geometry/camera';
import { draftBar, draftMarks } from './drawing';
import { frame } from './frame';
import { crosshair, handleButtons, handleMarks, selectionBox } from './handles';
import { icon } from './icons';
import type { EditorActions, EditorModel, Hint } from './model';
import { foldOverlay, siteOverlay } from './overlays';
import { panel } from './panel';
import { reachHint } from './reach';
import { shortened } from './shortened';
import { statusLine } from './status';
import { toolHint } from './tool-hint';
import { toolStrip, topBar } from './toolbar';

/** @param canvas what the picture is drawn on; it lives as long as its WebGL context. */
export function shell(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  return html`<div class="shell" tabindex="-1" ?inert=${model.disabled}>
    ${topBar(model, actions)}
    <div class="middle">
      ${stage(model, actions, canvas)} ${model.picture ? nothing : emptyStage(model, actions)}
      ${toolStrip(model, actions)} ${panel(model, actions)}
      ${model.progress ? html`<div class="bar" role="progressbar" aria-label=${model.progress.label}></div>` : nothing}
      ${model.hint && !model.comparing ? hint(model.hint, model.camera) : nothing}
      ${draftBar(model, actions)} ${toolHint(model)} ${reachHint(model)}
      ${model.comparing ? html`<p class="hint" part="hint">Original</p>` : nothing} ${notice(model, actions)}
    </div>
    ${statusLine(model, actions)}
    <p class="spoken" role="status" aria-live="polite">${model.announcement}</p>
  </div>`;
}

function stage(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  const { camera } = model;
  return html`<div
    class="stage ${model.hint ? 'inviting' : ''} ${model.comparing ? 'comparing' : ''}"
    part="stage"
    tabindex="0"
    role="group"
    aria-label=${model.picture ? `Picture ${model.picture.name}` : 'No picture'}
    .style=${`cursor: ${model.cursor}`}
  >
    ${canvas}
    <svg class="marks" aria-hidden="true">
      ${frame(model)} ${siteOverlay(model.sites, camera, model.overlays)}
      ${foldOverlay(model.folded, camera)} ${handleMarks(model)} ${draftMarks(model)} ${selectionBox(model)}
      ${crosshair(model)}
    </svg>
    ${handleButtons(model, actions)}
  </div>`;
}

/** A bubble over the place it speaks of. */
function hint({ text, at, above }: Hint, camera: Camera): TemplateResult {
  const [x, y] = toStage(camera, at);
  return html`<p class="hint bubble ${above ? 'above' : ''}" part="hint" .style=${`left: ${x}px; top: ${y}px`}>${text}</p>`;
}

function emptyStage(model: EditorModel, actions: EditorActions): TemplateResult {
  if (model.progress) return html``;
  if (model.opening)
    return html`<div class="empty opening"><span class="spinner" aria-hidden="true"></span>Opening…</div>`;
  if (model.readonly) return html``;
  return html`<div class="empty">
    <p>Drop a picture here, paste one, or</p>
    <button type="button" class="primary" @click=${() => actions.run('open')}>Open a picture</button>
  </div>`;
}

function notice(model: EditorModel, actions: EditorActions): TemplateResult | typeof nothing {
  if (!model.notice) return nothing;
  const { kind, text, action } = model.notice;
  return html`<div class="notice card ${kind}" part="notice" role=${kind === 'error' ? 'alert' : 'status'}>
    <p title=${text}>${shortened(text)}</p>
    ${action ? html`<button type="button" class="link" ?disabled=${model.readonly} @click=${() => action.run()}>${shortened(action.label)}</button>` : nothing}
    <button type="button" class="button small" aria-label="Dismiss" @click=${() => actions.dismiss()}>
      ${icon('close')}
    </button>
  </div>`;
}
