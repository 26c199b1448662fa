/** The time of a player, as a value. */

export interface Step {
  readonly time: number;
  /** Whether it has stopped at the end, or at the beginning if it plays backwards. */
  readonly stops: boolean;
}

/**
 * The time after some seconds.
 *
 * @param length Seconds of the clip; 0 for a pose.
 */
export function advanced(time: number, by: number, length: number, loops: boolean): Step {
  const next = time + by;
  if (next >= 0 && next < length) return { time: next, stops: false };
  if (!loops || length === 0) return { time: next < 0 ? 0 : length, stops: true };
  return { time: ((next % length) + length) % length, stops: false };
}
