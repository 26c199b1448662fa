/** The stage: the picture with its overlays and handles, for editing, posing or only viewing. */
import { html, nothing, type TemplateResult } from 'lit';
import { crosshair, selectionBox } from './aims';
import { draftMarks } from './drawing';
import { frame } from './frame';
import { handleButtons } from './handle_buttons';
import { handleMarks } from './handle_marks';
import type { EditorActions, EditorModel } from './model';
import { foldOverlay, siteOverlay } from './overlays';

export function stage(model: EditorModel, actions: EditorActions, canvas: HTMLCanvasElement): TemplateResult {
  const { camera, playing } = model;
  const handled = !(playing && model.readonly);
  return html`<div
    class="stage ${model.hint ? 'inviting' : ''} ${model.bare ? 'bare' : ''}"
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
