// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** The defaults of the format, which are the paper's. */
export const PAPER_SETTINGS = {
  mode: 'harmonic',
  support: 'paper',
  density: 0,
  rotation: 0,
} as const;

/** The editor's settings for new projects. */
export const EDITOR_SETTINGS = {
  mode: 'rigid',
  support: 'smooth',
  density: 100,
  rotation: 'auto',
} as const;
