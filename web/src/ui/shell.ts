/** The whole editor as one template: stage, bars, panel and floating parts; a picture that plays has few of them. */
import { html, nothing, type TemplateResult } from 'lit';
import { bubble } from './bubble';
import { contextMenu } from './context_menu';
import { draftBar } from './drawing';
import { emptyStage } from './empty';
import { keysCard } from './keys';
import { legends } from './legends';
import type { EditorActions, EditorModel } from './model';
import { notice } from './notice';
import { panel } from './panel';
import { disabledStage, stage } from './stage';
import { statusLine } from './status';
import { LEAST_HEIGHT } from './style/sizes';
import { toolHint } from './tool_hint';
import { toolStrip } from './tool_strip';
import { topBar } from './toolbar';
import { tooltips } from './tooltips';

/** @param canvas shows the picture; it lives as long as its WebGL context. */
export function shell(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  const { playing } = model;
  return html`${playing ? room(model) : nothing}
  <div class="shell" lang="en" tabindex="-1" ?inert=${model.disabled} ${tooltips(model)}>
    ${playing ? nothing : topBar(model, actions)}
    <div class="middle">
      ${stage(model, actions, canvas)} ${model.picture ? nothing : emptyStage(model, actions)}
      ${playing ? nothing : html`${toolStrip(model, actions)} ${panel(model, actions)}`}
      ${model.progress ? html`<div class="bar" role="progressbar" aria-label=${model.progress.label}></div>` : nothing}
      ${model.hint && !model.bare ? bubble(model.hint, model.camera) : nothing}
      ${playing ? nothing : html`${draftBar(model, actions)} ${toolHint(model)} ${legends(model)}`}
      ${model.bare === 'compare' ? html`<p class="hint" part="hint">Original</p>` : nothing} ${notice(model, actions)}
    </div>
    ${contextMenu(model, actions)}
    ${playing ? nothing : html`${keysCard(model)} ${statusLine(model, actions)}`}
    <p class="spoken" role="status" aria-live="polite">${model.announcement}</p>
  </div>
  ${model.disabled ? disabledStage(model) : nothing}`;
}

/** The element's height where the page sets none: that of the picture, or enough for a notice on why there is none. */
function room({ picture }: EditorModel): TemplateResult {
  const size = picture
    ? `aspect-ratio: ${picture.width} / ${picture.height}`
    : `min-height: ${LEAST_HEIGHT}px`;
  return html`<div .style=${size}></div>`;
}
