/** From seconds to places on a lane and back. */
import type { Clip } from '../../document/project';

/** The style of a mark at a time of the clip. */
export const at = ({ duration }: Clip, seconds: number): string =>
  `left: ${((100 * seconds) / duration).toFixed(4)}%`;

/** The time under a place in the window. @param lane as long as the clip. */
export function timeAt(lane: Element, { duration }: Clip, clientX: number): number {
  const { left, width } = lane.getBoundingClientRect();
  return width > 0 ? ((clientX - left) / width) * duration : 0;
}

/** Seconds a CSS pixel. */
export const secondsPerPixel = (lane: Element, { duration }: Clip): number =>
  duration / Math.max(1, lane.getBoundingClientRect().width);

const STEPS = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200];

/** Seconds between labels, so that there are not too many of them. */
export const labelStep = ({ duration }: Clip, zoom: number | null): number => {
  const most = zoom ? (duration * zoom) / 60 : 10;
  return STEPS.find((step) => duration / step <= most) ?? duration;
};
