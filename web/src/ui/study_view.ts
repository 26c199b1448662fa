/** The study card as the shell knows it. Its templates are loaded when it is first shown. */
import type { SVGTemplateResult, TemplateResult } from 'lit-html';
import type { Variant } from '../document/variants';
import type { Dispatch } from '../editor/events';
import type { FigureName } from '../editor/study_state';
import type { EditorModel } from '../editor/view_model';

export type VariantCanvases = Readonly<Record<Variant, HTMLCanvasElement>>;

/** The pictures of the comparison as addresses of PNGs; null where one is not known. */
export type VariantPictures = Readonly<Record<Variant, string | null>>;

/** @param canvases show the methods of the comparison. */
export type MakeStudyView = (canvases: () => VariantCanvases) => StudyView;

export interface StudyView {
  readonly styles: readonly string[];
  /** Marks on the stage. */
  marks(model: EditorModel): SVGTemplateResult;
  /** The SVG of a figure; null while it is not known. @param pictures of the comparison, while that is on show. */
  figure(name: FigureName, model: EditorModel, pictures: VariantPictures | null): TemplateResult | null;
  card(model: EditorModel, dispatch: Dispatch): TemplateResult;
}
