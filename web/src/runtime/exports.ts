/** Runs one export at a time: of a picture, a film, a rig, or a map. */

import type { Dispatch } from '../editor/events';
import { asError, isAbort } from '../error';
import type { Wording } from '../texts/wording';

/** How to follow and to stop an export. */
export interface ExportFollowing {
  readonly signal: AbortSignal;
  /** Gets the fraction that is done, and the seconds that are left, once these are known. */
  onProgress(fraction: number, left?: number): void;
  /** Takes a sentence on a part that the file lacks. */
  onRemark(sentence: Wording): void;
}

export class Exports {
  readonly #dispatch: Dispatch;
  #running: AbortController | null = null;

  constructor(dispatch: Dispatch) {
    this.#dispatch = dispatch;
  }

  /** @param exported returns the name of the saved file, or null if the person cancels. */
  async run(exported: (following: ExportFollowing) => Promise<string | null>): Promise<void> {
    const controller = new AbortController();
    this.#running = controller;
    const { signal } = controller;
    const onProgress = (fraction: number, left?: number) =>
      this.#dispatch({ type: 'export-progressed', fraction, ...(left === undefined ? {} : { left }) });
    const remarks: Wording[] = [];
    const onRemark = (sentence: Wording) => void remarks.push(sentence);
    try {
      const saved = await exported({ signal, onProgress, onRemark });
      this.#dispatch({ type: 'export-ended', saved, error: null, remarks });
    } catch (thrown) {
      const error = asError(thrown);
      this.#dispatch({ type: 'export-ended', saved: null, error: isAbort(error) ? null : error });
    } finally {
      // Nobody takes the file if the person has not chosen a place for it.
      controller.abort();
    }
  }

  cancel(): void {
    this.#running?.abort();
  }
}
