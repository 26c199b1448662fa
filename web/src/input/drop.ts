/** Files and links dropped on the element. */
import { addressInList, pictureInHtml } from '../editor/address';
import type { NamedFile } from '../editor/picture';

/** Receives dropped data. */
export interface DropReceiver {
  files(files: readonly NamedFile[]): void;
  /** An address; null if the dropped data has none. */
  address(address: string | null): void;
}

/** The types that are taken. Browsers provide no more information before the drop. */
const TAKEN = ['Files', 'text/uri-list', 'text/html'];

export class DropTarget {
  readonly #listening = new AbortController();

  /** @param accepts whether files are accepted now. */
  constructor(element: HTMLElement, accepts: () => boolean, receive: DropReceiver) {
    const { signal } = this.#listening;
    const mark = (dropping: boolean) => element.classList.toggle('dropping', dropping);
    element.addEventListener(
      'dragover',
      (event) => {
        if (!accepts() || !isTaken(event.dataTransfer)) return;
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
        if (!accepts() || !isTaken(dataTransfer)) return;
        event.preventDefault();
        // What is typed next is for the picture.
        if (!element.matches(':focus-within')) element.focus({ preventScroll: true });
        const files = [...dataTransfer.files];
        const folders = foldersIn(dataTransfer);
        if (files.length > 0) {
          receive.files(files.map((file, k) => ({ name: file.name, file, folder: folders[k] ?? false })));
        } else receive.address(addressOf(dataTransfer));
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

const isTaken = (transfer: DataTransfer | null): transfer is DataTransfer =>
  transfer?.types.some((type) => TAKEN.includes(type)) ?? false;

/** The address of a dragged picture, or else of the link. */
const addressOf = (transfer: DataTransfer): string | null =>
  pictureInHtml(transfer.getData('text/html')) ?? addressInList(transfer.getData('text/uri-list'));
