/** Files that are dropped on the element. */
export class Receiving {
  readonly #listening = new AbortController();

  /** @param willing whether files are accepted now. */
  constructor(element: HTMLElement, willing: () => boolean, receive: (files: readonly File[]) => void) {
    const { signal } = this.#listening;
    const mark = (dropping: boolean) => element.classList.toggle('dropping', dropping);
    element.addEventListener(
      'dragover',
      (event) => {
        if (!willing() || !event.dataTransfer?.types.includes('Files')) return;
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
        if (!willing() || !files?.length) return;
        event.preventDefault();
        receive([...files]);
      },
      { signal },
    );
  }

  release(): void {
    this.#listening.abort();
  }
}
