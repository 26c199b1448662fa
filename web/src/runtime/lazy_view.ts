/** A part of the page that is loaded when it is first shown: most visitors never open it. */

import type { C2WarpError } from '../error';
import { say } from '../texts/wording';
import { editorError } from './editor_error';

export interface LazyStyles {
  /** Its style sheets. */
  readonly styles: readonly string[];
}

export class LazyView<View extends LazyStyles> {
  readonly #root: ShadowRoot;
  readonly #load: () => Promise<View>;
  #view: View | null = null;
  #loading = false;

  constructor(root: ShadowRoot, load: () => Promise<View>) {
    this.#root = root;
    this.#load = load;
  }

  /** Null until it is loaded. */
  get view(): View | null {
    return this.#view;
  }

  /** Loads the view unless that has begun. @param loaded called once it can be rendered. */
  want(loaded: () => void, failed: (error: C2WarpError) => void): void {
    if (this.#view || this.#loading) return;
    this.#loading = true;
    this.#load()
      .then((view) => {
        this.#dress(view);
        this.#view = view;
        loaded();
      })
      .catch((cause: unknown) => failed(notLoaded(cause)))
      .finally(() => {
        this.#loading = false;
      });
  }

  /** Style sheets belong to the document that made them. */
  #dress({ styles }: LazyStyles): void {
    const window = this.#root.ownerDocument.defaultView;
    if (!window) return;
    const sheet = new window.CSSStyleSheet();
    sheet.replaceSync(styles.join('\n'));
    this.#root.adoptedStyleSheets = [...this.#root.adoptedStyleSheets, sheet];
  }
}

export const notLoaded = (cause: unknown): C2WarpError =>
  editorError('file', say('errors.cardNotLoaded'), { cause });
