/** The time of a clip that plays, by the rules of HTML for media elements. */

export interface MediaTime {
  /** Seconds. */
  readonly time: number;
  /** Seconds of the clip a second. Below 0 the clip plays backwards. As in HTML, the direction of 0 is forwards. */
  readonly rate: number;
  /** Seconds of the clip: 0 for a pose, and NaN for an unknown clip. */
  readonly length: number;
  /** Whether it begins again at the end. Unlike in HTML, it also goes round backwards. */
  readonly loops: boolean;
}

const goesRound = ({ loops, length }: MediaTime): boolean => loops && length > 0;

/** Whether the clip has played to its end. Then `play()` begins again. */
export const hasEnded = (of: MediaTime): boolean => of.rate >= 0 && of.time >= of.length && !goesRound(of);

/** Whether time stands still while it plays: at a rate of 0, and backwards at the beginning. */
export const standsStill = (of: MediaTime): boolean =>
  of.rate === 0 || (of.rate < 0 && of.time <= 0 && !goesRound(of));

/** The time after some seconds of the clock. */
export function advanced(of: MediaTime, seconds: number): number {
  const { time, rate, length } = of;
  const next = time + seconds * rate;
  if (next >= 0 && (rate > 0 ? next < length : next <= length)) return next;
  if (goesRound(of)) return ((next % length) + length) % length;
  return next < 0 ? 0 : length;
}
