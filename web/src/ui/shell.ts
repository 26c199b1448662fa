/** The whole editor as one template: stage, bars, panel and floating parts; a picture that plays has few of them. */

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

/** @param canvas shows the picture; it lives as long as its WebGL context. */
export function shell(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  const { playing } = model;
  return html`${playing ? room(model) : nothing}
  <div class="shell" tabindex="-1" ?inert=${model.disabled}>
    ${playing ? nothing : topBar(model, actions)}
    <div class="middle">
      ${stage(model, actions, canvas)} ${model.picture ? nothing : emptyStage(model, actions)}
      ${playing ? nothing : html`${toolStrip(model, actions)} ${panel(model, actions)}`}
      ${model.progress ? html`<div class="bar" role="progressbar" aria-label=${model.progress.label}></div>` : nothing}
      ${model.hint && !model.comparing ? hint(model.hint, model.camera) : nothing}
      ${playing ? nothing : html`${draftBar(model, actions)} ${toolHint(model)} ${reachHint(model)}`}
      ${model.comparing ? html`<p class="hint" part="hint">Original</p>` : nothing} ${notice(model, actions)}
    </div>
    ${playing ? nothing : statusLine(model, actions)}
    <p class="spoken" role="status" aria-live="polite">${model.announcement}</p>
  </div>`;
}

/** The element's height where the page sets none: that of the picture, or enough for a notice on why there is none. */
function room({ picture }: EditorModel): TemplateResult {
  const size = picture ? `aspect-ratio: ${picture.width} / ${picture.height}` : 'min-height: 240px';
  return html`<div .style=${size}></div>`;
}

/** The picture with its overlays and handles, for editing, posing or only viewing. */
function stage(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  const { camera, playing } = model;
  const handled = !(playing && model.readonly);
  return html`<div
    class="stage ${model.hint ? 'inviting' : ''} ${model.comparing ? 'comparing' : ''}"
    part="stage"
    tabindex=${handled ? (playing ? -1 : 0) : nothing}
    role=${handled ? 'group' : 'img'}
    aria-label=${stageLabel(model)}
    .style=${`cursor: ${model.cursor}`}
  >
    ${canvas}
    <svg class="marks" aria-hidden="true">
      ${playing ? nothing : frame(model)} ${siteOverlay(model.sites, camera, model.overlays)}
      ${foldOverlay(model.folded, camera)} ${handled ? handleMarks(model) : nothing} ${draftMarks(model)}
      ${selectionBox(model)} ${crosshair(model)}
    </svg>
    ${handled ? handleButtons(model, actions) : nothing}
  </div>`;
}

function stageLabel({ picture, playing, readonly }: EditorModel): string {
  if (!picture) return 'No picture';
  return `Picture ${picture.name}${playing && !readonly ? ', to be posed by its handles' : ''}`;
}

/** A bubble at the place that it points to. */
function hint({ text, at, above }: Hint, camera: Camera): TemplateResult {
  const [x, y] = toStage(camera, at);
  return html`<p class="hint bubble ${above ? 'above' : ''}" part="hint" .style=${`left: ${x}px; top: ${y}px`}>${text}</p>`;
}

function emptyStage(model: EditorModel, actions: EditorActions): TemplateResult {
  if (model.progress) return html``;
  if (model.opening)
    return html`<div class="empty opening"><span class="spinner" aria-hidden="true"></span>Opening…</div>`;
  if (model.readonly || model.playing) return html``;
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
