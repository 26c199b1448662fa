// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** Least width and height of a picture, in pixels. */
export const MIN_SIDE = 2;

/** Greatest width and height of a picture, in pixels. */
export const MAX_SIDE = 16384;

/** Greatest number of pixels of a picture. */
export const MAX_PIXELS = 100000000;

/** Greatest length of a project file, in bytes. */
export const MAX_PROJECT_BYTES = 100000000;
