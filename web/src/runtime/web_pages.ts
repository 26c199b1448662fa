/** Exports rigs for web pages, and copies the code that shows them. */
import type { EditorEffect } from '../editor/effects';
import type { Dispatch } from '../editor/events';
import { asError, isAbort } from '../error';
import { saveFile } from '../io/files';
import { notLoaded } from './lazy_view';
import type { Pictures } from './pictures';

type Order = Extract<EditorEffect, { readonly type: 'export-rig' }>;

export class WebPages {
  readonly #dispatch: Dispatch;
  readonly #pictures: Pictures;
  #exporting: AbortController | null = null;

  constructor(dispatch: Dispatch, pictures: Pictures) {
    this.#dispatch = dispatch;
    this.#pictures = pictures;
  }

  async export(order: Order): Promise<void> {
    const controller = new AbortController();
    this.#exporting = controller;
    try {
      const saved = await saveFile(this.#rig(order, controller.signal), order.name, 'rig');
      this.#dispatch({ type: 'export-ended', saved, error: null });
    } catch (thrown) {
      const error = asError(thrown);
      this.#dispatch({ type: 'export-ended', saved: null, error: isAbort(error) ? null : error });
    } finally {
      // Nobody takes the file if the person has not chosen a place for it.
      controller.abort();
    }
  }

  cancel(): void {
    this.#exporting?.abort();
  }

  /** Where the clipboard is blocked, the person can copy the code by hand. */
  async copyCode(code: string): Promise<void> {
    const copied = await navigator.clipboard.writeText(code).then(
      () => true,
      () => false,
    );
    this.#dispatch({ type: 'code-copied', copied });
  }

  dispose(): void {
    this.cancel();
  }

  async #rig({ project, picture }: Order, signal: AbortSignal): Promise<Blob> {
    const { pixels } = this.#pictures.opened(picture);
    const { rigFile } = await import('./rig_file').catch((cause: unknown) => {
      throw notLoaded(cause);
    });
    const onProgress = (fraction: number) => this.#dispatch({ type: 'export-progressed', fraction });
    return rigFile(project, { file: picture.file as Blob, pixels }, signal, onProgress);
  }
}
