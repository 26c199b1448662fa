/**
 * What is copied and pasted while the element has the focus: poses as text, and files to open.
 *
 * Keys bring an event with what is on the clipboard. A menu has to ask the browser, which may ask the person, or refuse.
 * So the page keeps the last pose that was copied on it: for when it is refused and, unasked, as long as nobody can have
 * copied anything else.
 */
import { keyHint } from '../ui/commands';
import { NO_POSE, notCopiedText, notReadText } from './notice_texts';

export interface ClipboardHost {
  /** Whether anything is copied and pasted now. */
  willing(): boolean;
  receive(files: readonly File[]): void;
  /** What is to be copied as text; null leaves it to the browser. */
  copied(): string | null;
  /** Takes a text. Returns whether it was meant for the editor. */
  pasted(text: string): boolean;
  tell(text: string): void;
}

/** The pose that was copied last on this page, by any element, and whether nothing else can have been copied since. */
const last: { text: string | null; newest: boolean } = { text: null, newest: false };

/** Menus tell no keys either where nothing hovers. */
const keysOf = (command: 'copy' | 'paste'): string | null =>
  matchMedia('(hover: none)').matches ? null : keyHint(command, navigator.platform);

export class Clipboard {
  readonly #element: HTMLElement;
  readonly #host: ClipboardHost;
  readonly #listening = new AbortController();

  constructor(element: HTMLElement, host: ClipboardHost) {
    this.#element = element;
    this.#host = host;
    const { signal } = this.#listening;
    const other = () => {
      last.newest = false;
    };
    // Browsers send these events to where text is selected, or to the body: the element hears them at the document.
    element.ownerDocument.addEventListener('copy', (event) => this.#copy(event), { signal });
    element.ownerDocument.addEventListener('paste', (event) => this.#paste(event), { signal });
    element.ownerDocument.addEventListener('cut', other, { signal });
    element.ownerDocument.defaultView?.addEventListener('blur', other, { signal });
  }

  release(): void {
    this.#listening.abort();
  }

  /** Copies the pose by a command. */
  async copy(): Promise<void> {
    const text = this.#host.copied();
    if (text === null) return;
    Object.assign(last, { text, newest: true });
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      this.#host.tell(notCopiedText(keysOf('copy')));
    }
  }

  /** Pastes a pose by a command. */
  async paste(): Promise<void> {
    const text = last.newest ? last.text : await this.#read();
    if (text === null) this.#host.tell(notReadText(keysOf('paste')));
    else if (!this.#host.pasted(text)) this.#host.tell(NO_POSE);
  }

  async #read(): Promise<string | null> {
    try {
      return await navigator.clipboard.readText();
    } catch {
      return last.text;
    }
  }

  #copy(event: ClipboardEvent): void {
    const text = this.#concerns(event) ? this.#host.copied() : null;
    if (text === null) {
      // Another element of the page may have copied it.
      last.newest = event.clipboardData?.getData('text/plain') === last.text;
      return;
    }
    Object.assign(last, { text, newest: true });
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
