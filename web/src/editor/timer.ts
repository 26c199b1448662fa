/** Timers by their purpose. Starting one again restarts it. */
export type Timer =
  | 'notice'
  | 'solve-patience'
  | 'merge-end'
  | 'pose-check'
  | 'suggest-patience'
  | 'fill-patience'
  | 'graphics'
  | 'replay';
