/** What is copied and pasted while the element has the focus: poses as text, and files to open. */
export interface ClipboardHost {
  /** Whether anything is copied and pasted now. */
  willing(): boolean;
  receive(files: readonly File[]): void;
  /** What is to be copied as text; null leaves it to the browser. */
  copied(): string | null;
  /** Takes a text. Returns whether it was meant for the editor. */
  pasted(text: string): boolean;
}

export class Clipboard {
  readonly #element: HTMLElement;
  readonly #host: ClipboardHost;
  readonly #listening = new AbortController();

  constructor(element: HTMLElement, host: ClipboardHost) {
    this.#element = element;
    this.#host = host;
    const { signal } = this.#listening;
    // Browsers send these events to where text is selected, or to the body: the element hears them at the document.
    element.ownerDocument.addEventListener('copy', (event) => this.#copy(event), { signal });
    element.ownerDocument.addEventListener('paste', (event) => this.#paste(event), { signal });
  }

  release(): void {
    this.#listening.abort();
  }

  #copy(event: ClipboardEvent): void {
    const text = this.#concerns(event) ? this.#host.copied() : null;
    if (text === null) return;
    event.clipboardData?.setData('text/plain', text);
    event.preventDefault();
  }

  #paste(event: ClipboardEvent): void {
    const { clipboardData } = event;
    if (!clipboardData || !this.#concerns(event)) return;
    const { files } = clipboardData;
    if (files.length > 0) this.#host.receive([...files]);
    else if (!this.#host.pasted(clipboardData.getData('text/plain'))) return;
    event.preventDefault();
  }

  #concerns(event: Event): boolean {
    return (
      this.#host.willing() && !event.defaultPrevented && Boolean(this.#element.shadowRoot?.activeElement)
    );
  }
}
