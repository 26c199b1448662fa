/** A box drawn over the lanes selects the keys in it. */
import type { KeyRef } from '../../document/clip_keys';
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import { follow } from './gestures';

/** A press that moves less is a click, CSS pixels. */
const SLIP = 4;

export function boxSelection(event: PointerEvent, { rows }: TimelineModel, dispatch: Dispatch): void {
  const tracks = event.currentTarget as HTMLElement;
  // A finger scrolls the rows.
  if (event.button > 0 || event.pointerType === 'touch' || !(event.target as Element).closest('.lane'))
    return;
  const adds = event.shiftKey || event.ctrlKey || event.metaKey;
  const before = rows.flatMap(({ handle, keys }) =>
    keys.filter(({ selected }) => adds && selected).map(({ time }) => ({ handle, time })),
  );
  const box = tracks.ownerDocument.createElement('div');
  box.className = 'key-box';
  const from = event;
  const show = (now: PointerEvent) => {
    if (!box.isConnected && Math.hypot(now.clientX - from.clientX, now.clientY - from.clientY) < SLIP) return;
    tracks.append(box);
    const { left, top } = tracks.getBoundingClientRect();
    const [x, y] = [Math.min(from.clientX, now.clientX), Math.min(from.clientY, now.clientY)];
    Object.assign(box.style, {
      left: `${x - left}px`,
      top: `${y - top}px`,
      width: `${Math.abs(now.clientX - from.clientX)}px`,
      height: `${Math.abs(now.clientY - from.clientY)}px`,
    });
  };
  follow(event, {
    moved: show,
    ended: (_, cancelled) => {
      const inside = box.isConnected ? keysWithin(tracks, box.getBoundingClientRect()) : [];
      box.remove();
      if (!cancelled) dispatch({ type: 'keys-selected', keys: [...before, ...inside] });
    },
  });
}

/** The keys whose middles lie in a rectangle. */
function keysWithin(tracks: Element, box: DOMRect): readonly KeyRef[] {
  const keys = [...tracks.querySelectorAll<HTMLElement>('.clip-key')];
  return keys
    .filter((key) => {
      const { left, top, width, height } = key.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      return x >= box.left && x <= box.right && y >= box.top && y <= box.bottom;
    })
    .map(refOf);
}

/** The key that a button stands for. */
export const refOf = ({ dataset }: HTMLElement): KeyRef => ({
  handle: dataset.keyOf ?? '',
  time: Number(dataset.time),
});
