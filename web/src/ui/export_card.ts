/** On a phone, whose status line has no room for it: an export under way, with its progress. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { progress } from './status';

export const exportCard = (model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing =>
  model.task?.name === 'export' && !model.notice
    ? html`<div class="notice card export-card" part="notice">${progress(model.task, model, dispatch)}</div>`
    : nothing;
