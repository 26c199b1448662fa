// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** The colours of 0, 0.2, … 1: sRGB, 0 to 255, and an opacity, 0 to 1. */
export const HEAT_RAMP = [
  [85, 40, 169, 0],
  [59, 98, 196, 0.55],
  [18, 149, 187, 0.65],
  [54, 191, 166, 0.7],
  [142, 223, 124, 0.74],
  [244, 240, 78, 0.78],
] as const;
