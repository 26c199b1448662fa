/** Loads the templates and styles of the study card when it is first shown: most visitors never open it. */
import type { EditorAccess } from '../editor/access';
import { WarpError } from '../error';
import type { StudyView } from '../ui/study_view';

export class Study {
  readonly #root: ShadowRoot;
  readonly #editor: EditorAccess;
  #view: StudyView | null = null;
  #loading = false;

  constructor(root: ShadowRoot, editor: EditorAccess) {
    this.#root = root;
    this.#editor = editor;
  }

  /** Null until it is loaded. */
  get view(): StudyView | null {
    return this.#view;
  }

  /** Loads the card if the state shows it. @param loaded called once it can be rendered. */
  follow(loaded: () => void): void {
    if (this.#view || this.#loading || this.#editor.state.study.page === null) return;
    this.#loading = true;
    import('../ui/study/study')
      .then(({ study: view }) => {
        this.#dress(view);
        this.#view = view;
        loaded();
      })
      .catch((cause: unknown) => {
        this.#editor.dispatch({ type: 'study-shown', page: null });
        const error = new WarpError('file', 'This card could not be loaded: is the network there?', {
          cause,
        });
        this.#editor.dispatch({ type: 'error-reported', error });
      })
      .finally(() => {
        this.#loading = false;
      });
  }

  /** Style sheets belong to the document that made them. */
  #dress({ style }: StudyView): void {
    const window = this.#root.ownerDocument.defaultView;
    if (!window) return;
    const sheet = new window.CSSStyleSheet();
    sheet.replaceSync(String(style));
    this.#root.adoptedStyleSheets = [...this.#root.adoptedStyleSheets, sheet];
  }
}
