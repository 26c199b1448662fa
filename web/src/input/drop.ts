/** Files dropped on the element. */
import type { NamedFile } from '../editor/events';

export class DropTarget {
  readonly #listening = new AbortController();

  /** @param accepts whether files are accepted now. */
  constructor(element: HTMLElement, accepts: () => boolean, receive: (files: readonly NamedFile[]) => void) {
    const { signal } = this.#listening;
    const mark = (dropping: boolean) => element.classList.toggle('dropping', dropping);
    element.addEventListener(
      'dragover',
      (event) => {
        if (!accepts() || !event.dataTransfer?.types.includes('Files')) return;
        event.preventDefault();
        mark(true);
      },
      { signal },
    );
    element.addEventListener(
      'dragleave',
      (event) => {
        if (!element.contains(event.relatedTarget as Node | null)) mark(false);
      },
      { signal },
    );
    element.addEventListener(
      'drop',
      (event) => {
        mark(false);
        const files = event.dataTransfer?.files;
        if (!accepts() || !files?.length) return;
        event.preventDefault();
        receive([...files].map((file) => ({ name: file.name, file })));
      },
      { signal },
    );
  }

  dispose(): void {
    this.#listening.abort();
  }
}
