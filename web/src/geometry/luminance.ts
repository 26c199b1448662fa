/** How light a picture is, in few enough numbers to be searched while a pointer moves. */
export interface Luminance {
  readonly width: number;
  readonly height: number;
  /** Rows from the top, 0 to 255. */
  readonly values: Uint8Array;
  /** Image pixels per number, along either axis; at least 1. */
  readonly step: number;
  /** The same in numbers for 2 × 2 of these each; null if these are few. */
  readonly coarser: Luminance | null;
}
