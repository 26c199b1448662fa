/** What is known of a picture file before it is decoded. */
import type { Orientation } from './exif';

export interface Structure {
  /** Undefined if the file ends before its size, or the type is not supported. */
  readonly size: { readonly width: number; readonly height: number } | undefined;
  /**
   * Whether the end of the picture is in the file. A number is the position where the last scan of a JPEG ends, with or
   * without all of its data. Types that are not supported count as found.
   */
  readonly end: 'found' | 'missing' | number;
  /** Whether the file has several frames. */
  readonly moves: boolean;
  /** The recorded orientation of a WebP, which browsers do not agree on. */
  readonly orientation?: Orientation;
}
