/** A press that is followed until it ends, wherever the pointer goes. */

export interface Gesture {
  moved(event: PointerEvent): void;
  /** `cancelled`: the browser has taken the pointer. */
  ended(event: PointerEvent, cancelled: boolean): void;
}

export function follow(begun: PointerEvent, gesture: Gesture): void {
  const target = begun.currentTarget as HTMLElement;
  const listening = new AbortController();
  const { signal } = listening;
  const isSame = ({ pointerId }: PointerEvent) => pointerId === begun.pointerId;
  const end = (event: PointerEvent, cancelled: boolean) => {
    if (!isSame(event)) return;
    listening.abort();
    gesture.ended(event, cancelled);
  };
  target.setPointerCapture(begun.pointerId);
  target.addEventListener('pointermove', (event) => isSame(event) && gesture.moved(event), { signal });
  target.addEventListener('pointerup', (event) => end(event, false), { signal });
  target.addEventListener('pointercancel', (event) => end(event, true), { signal });
}
