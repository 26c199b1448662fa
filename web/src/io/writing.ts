/** The messages between the page and the workers that write files. */

import type { Wording } from '../texts/wording';

/** Through the port: the next pixels in straight alpha, the end of the file, or of all. */
export type WriteRequest = { readonly rgba: Uint8Array<ArrayBuffer> } | 'end' | 'abandon';

/** What failed. */
export type WriteFault = 'encoder' | 'storage';

export interface Refusal {
  /** Why, as words that follow a colon. */
  readonly refused: Wording;
  readonly fault: WriteFault;
}

/** Answers each request: the pixels before these are written; the file; all is gone; or why it cannot be made. */
export type WriteReply<File> = 'taken' | { readonly file: File } | 'gone' | Refusal;
