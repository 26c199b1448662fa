/** The stage: the picture with its overlays and handles, for editing, posing or only viewing. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import { classMap } from 'lit-html/directives/class-map.js';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { shownName } from '../texts/shown_name';
import { crosshair, selectionBox, waitingMarks } from './aims';
import { askedMarks } from './asked_marks';
import { brushMarks } from './brush_marks';
import { cornerMarks } from './client';
import { creaseMarks } from './crease_marks';
import { cssCursor } from './cursor';
import { domainMarks, ringButtons } from './domain';
import { draftMarks } from './drawing';
import { frame } from './frame';
import { guideLines } from './guides';
import { handleButtons } from './handle_buttons';
import { handleMarks } from './handle_marks';
import { nameMarks } from './name_marks';
import {
  cellOverlay,
  creaseOverlay,
  onionOverlay,
  outlineOverlay,
  selectionOverlay,
  siteOverlay,
} from './overlays';

/** @param studied marks of the study card. */
export function stage(
  model: EditorModel,
  dispatch: Dispatch,
  canvas: HTMLCanvasElement,
  studied: SVGTemplateResult | typeof nothing,
): TemplateResult {
  const { posable } = model;
  const handled = !(posable && model.readonly);
  return html`<div
    class=${classMap({ stage: true, inviting: model.hint !== null, previewing: model.preview !== null, awaiting: model.awaiting })}
    part="stage"
    tabindex=${handled ? (posable ? -1 : 0) : nothing}
    role=${handled ? 'application' : 'img'}
    aria-label=${stageLabel(model)}
    aria-description=${model.picture && handled && !model.readonly ? model.texts.stage.keys : nothing}
    .style=${`cursor: ${cssCursor(model.cursor)}`}
  >
    ${canvas} ${cornerMarks()}
    <svg class="marks" aria-hidden="true">
      ${guideLines(model)} ${model.tool === 'lasso' ? domainMarks(model) : posedMarks(model, handled)} ${draftMarks(model)}
      ${brushMarks(model)} ${studied} ${crosshair(model)} ${waitingMarks(model)}
    </svg>
    ${handled ? (model.tool === 'lasso' ? ringButtons(model, dispatch) : handleButtons(model, dispatch)) : nothing}
  </div>`;
}

/** The marks on the posed picture. */
const posedMarks = (model: EditorModel, handled: boolean): SVGTemplateResult => svg`
  ${model.posable ? nothing : frame(model)} ${selectionOverlay(model.selected, model.camera)} ${cellOverlay(model.overlays.cells ? model.borders : null, model.camera)}
  ${siteOverlay(model.sites, model.camera, model.overlays)}
  ${model.onion.map((outline) => onionOverlay(outline, model.camera))} ${outlineOverlay(model.outline, model.camera)}
  ${creaseOverlay(model.creased, model.camera)} ${creaseMarks(model)} ${handled ? handleMarks(model) : nothing} ${askedMarks(model)} ${handled ? nameMarks(model) : nothing}
  ${selectionBox(model)}`;

/** The picture for screen readers while the editor is inert. */
export const disabledStage = (model: EditorModel): TemplateResult =>
  html`<p class="spoken" role="img" aria-label=${model.texts.stage.disabled(pictureLabel(model))}></p>`;

const stageLabel = (model: EditorModel): string =>
  model.posable && !model.readonly ? model.texts.stage.posable(pictureLabel(model)) : pictureLabel(model);

/** The label of the picture. In an editor people may open other pictures than the one that the page describes. */
function pictureLabel({ picture, posable, alt, texts }: EditorModel): string {
  if (!picture) return texts.stage.noPicture;
  return (posable && alt) || texts.stage.picture(shownName(picture.name));
}
