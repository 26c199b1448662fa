/** Files dropped on the element. */
import type { NamedFile } from '../editor/picture';

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
        const { dataTransfer } = event;
        if (!accepts() || !dataTransfer?.files.length) return;
        event.preventDefault();
        // What is typed next is for the picture.
        if (!element.matches(':focus-within')) element.focus({ preventScroll: true });
        const folders = foldersIn(dataTransfer);
        const files = [...dataTransfer.files];
        receive(files.map((file, k) => ({ name: file.name, file, folder: folders[k] ?? false })));
      },
      { signal },
    );
  }

  dispose(): void {
    this.#listening.abort();
  }
}

/** Which of the files, in their order, are folders: browsers list a folder like a file. */
const foldersIn = ({ items }: DataTransfer): readonly boolean[] =>
  [...items]
    .filter(({ kind }) => kind === 'file')
    .map((item) => item.webkitGetAsEntry()?.isDirectory ?? false);
