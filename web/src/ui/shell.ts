/** The whole editor as one template. A page that plays shows only a few of its parts. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import { LEAST_HEIGHT, OWN_HEIGHT } from '../editor/sizes';
import type { EditorModel } from '../editor/view_model';
import { brushBar } from './brush_bar';
import { bubble } from './bubble';
import { contextMenu } from './context_menu';
import { draftBar } from './drawing';
import { emptyStage } from './empty';
import { exportCard } from './export_card';
import type { ExportPages } from './export_pages';
import { keysCard } from './keys';
import { legends } from './legends';
import { notice } from './notice';
import { panel } from './panel';
import { progressBar } from './progress';
import { disabledStage, stage } from './stage';
import { statusLine } from './status';
import type { StudyView } from './study_view';
import type { TimelineView } from './timeline_view';
import { toolHint } from './tool_hint';
import { toolStrip } from './tool_strip';
import { topBar } from './toolbar';
import { tooltips } from './tooltips';

/** The parts that are loaded when they are first shown; null until then. */
export interface LaterParts {
  readonly study: StudyView | null;
  readonly timeline: TimelineView | null;
  readonly exportPages: ExportPages | null;
}

/**
 * @param language the tag of the texts.
 * @param canvas shows the picture, and lives as long as its WebGL context.
 */
export function shell(
  model: EditorModel,
  language: string,
  dispatch: Dispatch,
  canvas: HTMLCanvasElement,
  { study, timeline, exportPages }: LaterParts,
): TemplateResult {
  const { posable } = model;
  const studying = study !== null && model.study.page !== null && !posable;
  return html`${room(model)}
  <div class="shell ${model.timeline?.lead ? 'of-keys' : ''}" lang=${language} dir=${model.rtl ? 'rtl' : 'ltr'} tabindex="-1" ?inert=${model.disabled} ${tooltips(model)}>
    ${posable ? nothing : topBar(model, dispatch, exportPages)}
    <div class="middle ${studying ? `studying on-${model.study.page}` : ''}">
      ${stage(model, dispatch, canvas, studying ? study.marks(model) : nothing)} ${model.picture ? nothing : emptyStage(model, dispatch)}
      ${posable ? nothing : html`${model.offers('select') ? toolStrip(model, dispatch) : nothing} ${studying ? study.card(model, dispatch) : panel(model, dispatch)}`}
      ${model.task ? progressBar(model.task) : nothing}
      ${model.hint && !model.preview && !studying ? bubble(model.hint, model.camera) : nothing}
      ${posable ? nothing : html`${draftBar(model, dispatch)} ${brushBar(model, dispatch)} ${toolHint(model, dispatch)} ${legends(model)}`}
      ${model.preview === 'compare' ? html`<p class="hint" part="hint">${model.texts.stage.original}</p>` : nothing}
      ${posable ? nothing : exportCard(model, dispatch)} ${notice(model, dispatch)}
    </div>
    ${timeline && model.timeline ? timeline.bar(model, dispatch) : nothing} ${contextMenu(model, dispatch)}
    ${posable ? nothing : html`${keysCard(model)} ${statusLine(model, dispatch)}`}
    <p class="spoken" role="status" aria-live="polite">${model.announcement}</p>
  </div>
  ${model.disabled ? disabledStage(model) : nothing}`;
}

/** The default height of the element: that of the picture, or enough for the editor. */
function room({ posable, picture }: EditorModel): TemplateResult {
  if (!posable) return html`<div .style=${`height: ${OWN_HEIGHT}px`}></div>`;
  const size = picture
    ? `aspect-ratio: ${picture.width} / ${picture.height}`
    : `min-height: ${LEAST_HEIGHT}px`;
  return html`<div .style=${size}></div>`;
}
