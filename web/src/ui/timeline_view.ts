/** The timeline as the shell knows it. Its templates are loaded when it is first shown. */
import type { TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';

export interface TimelineView {
  readonly styles: readonly string[];
  bar(model: EditorModel, dispatch: Dispatch): TemplateResult;
}
