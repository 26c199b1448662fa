/** Where a label beside a dot covers no other dot. */
import type { Size } from './camera';
import type { Vec } from './vec';

/**
 * Returns the middle of the first place for a label on the stage that is clear of all dots. If there is none, returns
 * the first place on the stage, or else the first of all.
 *
 * @param places the middles to choose from, at least one.
 * @param label the size of the label.
 * @param room the minimum distance between a dot's middle and the label.
 */
export function clearPlace(
  places: readonly [Vec, ...Vec[]],
  label: Size,
  dots: readonly Vec[],
  room: number,
  stage: Size,
): Vec {
  const [x, y] = [label.width / 2, label.height / 2];
  const seen = places.filter(
    (at) => at[0] >= x && at[1] >= y && at[0] <= stage.width - x && at[1] <= stage.height - y,
  );
  const isClear = (at: Vec) =>
    dots.every((dot) => Math.abs(dot[0] - at[0]) >= x + room || Math.abs(dot[1] - at[1]) >= y + room);
  return seen.find(isClear) ?? seen[0] ?? places[0];
}
