/** The messages between the page and the worker that reads pictures. Each picture has its own port. */

import type { C2WarpErrorCode } from '../error';
import type { Wording } from '../texts/wording';
import type { Display } from './display';
import type { PictureFacts } from './read_picture';

/** The message to the worker itself. */
export interface ReadRequest {
  readonly file: Blob;
  readonly port: MessagePort;
}

/** The first and only reply. */
export type ReadReply =
  | { readonly kind: 'read'; readonly facts: PictureFacts; readonly display: Display }
  | {
      readonly kind: 'refused';
      readonly code: C2WarpErrorCode;
      readonly message: string;
      readonly wording: Wording | undefined;
    }
  /** The page must read this picture, because the worker lacks a part of the platform. */
  | { readonly kind: 'lacking' };

export type PictureRequest =
  /** Sends a copy of the pixels to another worker; null if the picture was released. */
  | { readonly kind: 'send'; readonly to: MessagePort }
  /** Sends the luminance of the picture; null if it was released. */
  | { readonly kind: 'luminance'; readonly to: MessagePort }
  /** Stops reading, or frees the pixels. */
  | { readonly kind: 'release' };
