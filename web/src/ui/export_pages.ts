/** The pages of the export panel that are loaded when they are first shown. */
import type { TemplateResult } from 'lit-html';
import type { EngineModel } from '../editor/engine_model';
import type { Dispatch } from '../editor/events';
import type { FilmModel } from '../editor/film_model';
import type { MapModel } from '../editor/map_model';
import type { EditorModel } from '../editor/view_model';
import type { WebPageModel } from '../editor/web_page_model';

export interface ExportPages {
  readonly styles: readonly string[];
  page(page: WebPageModel, model: EditorModel, dispatch: Dispatch): TemplateResult;
  engine(engine: EngineModel, model: EditorModel, dispatch: Dispatch): TemplateResult;
  maps(maps: MapModel, model: EditorModel, dispatch: Dispatch): TemplateResult;
  film(film: FilmModel, model: EditorModel, dispatch: Dispatch): TemplateResult;
}
