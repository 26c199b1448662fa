/** Loads the templates and styles of the study card when it is first shown: most visitors never open it. */

import { render } from 'lit-html';
import { byVariant } from '../document/variants';
import type { EditorAccess } from '../editor/access';
import type { EditorState } from '../editor/state';
import type { FigureName } from '../editor/study_state';
import { viewModel } from '../editor/view_model';
import type { C2WarpError } from '../error';
import { svgText } from '../io/svg';
import type { Texts } from '../texts/texts';
import type { StudyView, VariantCanvases } from '../ui/study_view';
import type { Compare } from './compare';
import { LazyView, notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

export class Study {
  readonly #root: ShadowRoot;
  readonly #editor: EditorAccess;
  readonly #pictures: Pictures;
  readonly #texts: () => Texts;
  readonly #card: LazyView<StudyView>;
  #canvases: VariantCanvases;
  /** While the comparison is on show. */
  #compare: Promise<Compare> | null = null;

  constructor(root: ShadowRoot, editor: EditorAccess, pictures: Pictures, texts: () => Texts) {
    this.#root = root;
    this.#editor = editor;
    this.#pictures = pictures;
    this.#texts = texts;
    this.#canvases = this.#freshCanvases();
    this.#card = new LazyView(root, async () => {
      const { studyView } = await import('../ui/study/study');
      return studyView(() => this.#canvases);
    });
  }

  /** Null until it is loaded. */
  get view(): StudyView | null {
    return this.#card.view;
  }

  /** Loads the card if the state shows it. @param loaded called once it can be rendered. */
  follow(loaded: () => void): void {
    this.#followComparison();
    if (this.#editor.state.study.page !== null) this.#card.want(loaded, (error) => this.#failed(error));
  }

  /** A figure as an SVG file, in light colours; null while it is not known. */
  async figureText(name: FigureName, state: EditorState): Promise<string | null> {
    const compare = await this.#compare;
    const figure = this.view?.figure(name, viewModel(state, this.#texts()), compare?.pngs() ?? null);
    if (!figure) return null;
    const place = this.#root.ownerDocument.createElement('div');
    place.className = 'figure-to-save';
    this.#root.append(place);
    try {
      render(figure, place);
      const drawn = place.querySelector('svg');
      return drawn && svgText(drawn);
    } finally {
      place.remove();
    }
  }

  dispose(): void {
    this.#endComparison();
  }

  #failed(error: C2WarpError): void {
    this.#compare = null;
    this.#editor.dispatch({ type: 'study-shown', page: null });
    this.#editor.dispatch({ type: 'error-reported', error });
  }

  /** Begins, follows or ends the comparison, as the state has it. */
  #followComparison(): void {
    const { study, page } = this.#editor.state;
    if (study.page !== 'compare' || page.posable) {
      this.#endComparison();
      return;
    }
    this.#compare ??= import('./compare').then(
      ({ Compare }) => new Compare(this.#editor, this.#pictures, this.#canvases),
    );
    this.#compare.then(
      (compare) => compare.follow(),
      (cause: unknown) => this.#failed(notLoaded(cause)),
    );
  }

  #endComparison(): void {
    if (!this.#compare) return;
    this.#compare.then(
      (compare) => compare.dispose(),
      () => {},
    );
    this.#compare = null;
    // Released ones cannot be drawn on again.
    this.#canvases = this.#freshCanvases();
  }

  #freshCanvases(): VariantCanvases {
    return byVariant(() => this.#root.ownerDocument.createElement('canvas'));
  }
}
