/**
 * Copies and pastes while the element has the focus: poses and keys as text, and files to open.
 *
 * Keys bring an event with the clipboard's content. A menu has to ask the browser, which may ask the person, or refuse.
 * So the page keeps the last text that was copied on it: for a refusal and, without asking, while nothing else can have
 * been copied.
 */

import { isKeys } from '../document/key_text';
import { isPose } from '../document/pose_text';
import type { EditorAccess } from '../editor/access';
import { addressIn, pictureInHtml } from '../editor/address';
import { keyHint } from '../editor/commands';
import { holdsKeys } from '../editor/keys_in_hand';
import { mayEdit, mayReceive } from '../editor/permissions';
import { copiedText } from '../editor/update/clipboard';
import type { Texts } from '../texts/texts';
import { say, type Wording } from '../texts/wording';
import type { Focus } from './focus';

/** The text that any element of the page copied last, and whether nothing else can have been copied since. */
const last: { text: string | null; newest: boolean } = { text: null, newest: false };

/** The keys of a command; null where nothing hovers, since menus show no keys there. */
const keysOf = (command: 'copy' | 'paste', texts: Texts): string | null =>
  matchMedia('(hover: none)').matches ? null : keyHint(command, navigator.platform, texts);

export class Clipboard {
  readonly #element: HTMLElement;
  readonly #editor: EditorAccess;
  readonly #focus: Focus;
  readonly #texts: () => Texts;
  readonly #listening = new AbortController();

  constructor(element: HTMLElement, editor: EditorAccess, focus: Focus, texts: () => Texts) {
    this.#element = element;
    this.#editor = editor;
    this.#focus = focus;
    this.#texts = texts;
    const { signal } = this.#listening;
    const other = () => {
      last.newest = false;
    };
    // Browsers send these events to the selected text, or to the body, so the element listens on the document.
    element.ownerDocument.addEventListener('copy', (event) => this.#onCopy(event), { signal });
    element.ownerDocument.addEventListener('paste', (event) => this.#onPaste(event), { signal });
    element.ownerDocument.addEventListener('cut', (event) => this.#onCut(event), { signal });
    element.ownerDocument.defaultView?.addEventListener('blur', other, { signal });
  }

  dispose(): void {
    this.#listening.abort();
  }

  /** Copies by a command. */
  async copy(text: string): Promise<void> {
    Object.assign(last, { text, newest: true });
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const keys = keysOf('copy', this.#texts());
      this.#inform(keys === null ? say('notices.notCopied') : say('notices.notCopiedByMenu', keys));
    }
  }

  /** Pastes by a command. */
  async paste(): Promise<void> {
    const text = last.newest ? last.text : await this.#read();
    if (text === null) {
      const keys = keysOf('paste', this.#texts());
      this.#inform(keys === null ? say('notices.notRead') : say('notices.notReadByMenu', keys));
    } else if (!this.#pasted(text)) this.#inform(say('notices.noPose'));
  }

  async #read(): Promise<string | null> {
    try {
      return await navigator.clipboard.readText();
    } catch {
      return last.text;
    }
  }

  /** Copies the selection. Returns false for an event that is left to the browser. */
  #onCopy(event: ClipboardEvent): boolean {
    const { state, dispatch } = this.#editor;
    const text = this.#concerns(event) && !this.#focus.isOnText ? copiedText(state) : null;
    if (text === null) {
      // Another element of the page may have copied it.
      last.newest = event.clipboardData?.getData('text/plain') === last.text;
      return false;
    }
    dispatch({ type: 'selection-copied' });
    Object.assign(last, { text, newest: true });
    event.clipboardData?.setData('text/plain', text);
    event.preventDefault();
    return true;
  }

  /** Cuts keys. Handles stay, since a copy is one of their pose. */
  #onCut(event: ClipboardEvent): void {
    if (!holdsKeys(this.#editor.state)) last.newest = false;
    else if (this.#onCopy(event)) this.#editor.dispatch({ type: 'command-run', command: 'remove-keys' });
  }

  #onPaste(event: ClipboardEvent): void {
    const { clipboardData } = event;
    if (!clipboardData || !this.#concerns(event)) return;
    const text = clipboardData.getData('text/plain');
    // A field takes the text, also where a picture of it comes with it. It takes nothing else.
    if (text !== '' && this.#focus.isInField) return;
    const files = [...clipboardData.files];
    if (files.length > 0) {
      this.#editor.dispatch({
        type: 'files-received',
        files: files.map((file) => ({ name: file.name, file })),
      });
    } else if (!this.#pasted(text, clipboardData.getData('text/html'))) return;
    event.preventDefault();
  }

  /** Pastes a text that is a pose or keys, or opens what it leads to. Returns whether it is or does. */
  #pasted(text: string, html = ''): boolean {
    const { state, dispatch } = this.#editor;
    if (isPose(text) || isKeys(text)) {
      if (mayEdit(state)) dispatch({ type: 'text-pasted', text });
      return mayEdit(state);
    }
    const address = pictureInHtml(html) ?? addressIn(text);
    if (!address || !mayReceive(state)) return false;
    dispatch({ type: 'address-given', text: address });
    return true;
  }

  #inform(text: Wording): void {
    this.#editor.dispatch({ type: 'person-informed', text });
  }

  #concerns(event: Event): boolean {
    const { state } = this.#editor;
    return mayReceive(state) && !event.defaultPrevented && Boolean(this.#element.shadowRoot?.activeElement);
  }
}
