/** Reads everything about a picture file, in a worker or in the page. */
import { alphaThreshold } from './alpha';
import { decodePicture, type Platform } from './decode';
import { type Display, displayOf } from './display';
import { isPixelArt, isSmall } from './pixel_art';
import { largestTexture } from './pixels';

/** What the editor must know of a picture. */
export interface PictureFacts {
  readonly width: number;
  readonly height: number;
  readonly alphaThreshold: number | null;
  readonly isSmall: boolean;
  readonly isPixelArt: boolean;
  readonly moves: boolean;
}

export interface ReadPicture extends Display {
  readonly facts: PictureFacts;
  /** Straight alpha: RGBA, rows from the top. */
  readonly rgba: Uint8Array<ArrayBuffer>;
}

/** @throws the errors of {@link decodePicture}. */
export async function readPicture(file: Blob, platform: Platform, signal: AbortSignal): Promise<ReadPicture> {
  const decoded = await decodePicture(file, platform, signal);
  const { width, height, rgba, moves } = decoded;
  const facts = {
    width,
    height,
    alphaThreshold: alphaThreshold(decoded),
    isSmall: isSmall(decoded),
    isPixelArt: isPixelArt(decoded),
    moves,
  };
  return { facts, rgba, ...(await displayOf(decoded.bitmap, largestTexture(platform.createContext))) };
}
