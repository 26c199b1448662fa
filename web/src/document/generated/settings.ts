// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.

/** The least and the largest value of each number. */
export const RANGES = {
  samples: [100, 2000000],
  shape_factor: [0, 1],
  degree: [5, 32],
  density: [0, 4096],
} as const;

/** The most characters of the name of a handle or a clip. */
export const MAX_NAME = 200;

/** The most cells of a mask of stiffness, each way. */
export const STIFFNESS_CELLS = 128;

/** The least and the greatest number of control points of a displacement along each axis. */
export const DISPLACEMENT_POINTS = [4, 259] as const;

/** The defaults of the format, taken from the paper. */
export const PAPER_SETTINGS = {
  samples: 10000,
  shape_factor: 1,
  degree: 5,
  filling: 'line',
  support: 'paper',
  mode: 'harmonic',
  blend: 'linear',
  density: 0,
  rotation: 0,
} as const;

/** The editor's settings for new projects. */
export const EDITOR_SETTINGS = {
  samples: 10000,
  shape_factor: 1,
  degree: 5,
  filling: 'line',
  support: 'smooth',
  mode: 'rigid',
  blend: 'linear',
  density: 150,
  rotation: 'auto',
} as const;
