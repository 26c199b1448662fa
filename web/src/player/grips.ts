/** Grips on the handles of a player that readers may pose, by pointer and by keyboard. */
import type { View } from './painter';
import type { Handle, Place } from './shares';

export interface Grips {
  readonly element: HTMLElement;
  /** Shows the grips of these handles; null hides all. */
  show(handles: readonly Handle[] | null, view: View | null): void;
}

interface Listeners {
  /** A reader moves a handle by pixels of the picture. */
  moved(id: string, by: Place): void;
  /** The handle returns to rest. */
  reset(id: string): void;
  /** A drag has ended, or a key is released. */
  ended(): void;
}

/** Step of an arrow key, in pixels of the picture; ten times as much with Shift. */
const KEYS: Readonly<Record<string, Place>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export const GRIP_SHEET = `[part=handle]{position:absolute;width:44px;height:44px;margin:-22px;padding:0;border:0;border-radius:50%;background:radial-gradient(#fff 5px,#1b66d6 6px 8px,#0000 9px);cursor:grab;touch-action:none}[part=handle]:active{cursor:grabbing}`;

export function gripsOf(host: HTMLElement, { moved, reset, ended }: Listeners): Grips {
  const element = document.createElement('div');
  const buttons = new Map<string, HTMLButtonElement>();
  let view: View | null = null;

  const gripOf = (id: string) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.setAttribute('part', 'handle');
    button.setAttribute('aria-label', id.replace(/[-_]+/g, ' '));
    let last: Place | undefined;
    let isKeyDown = false;
    button.onpointerdown = (event) => {
      if (event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      last = [event.clientX, event.clientY];
    };
    button.onpointermove = ({ clientX, clientY }) => {
      const { width } = host.getBoundingClientRect();
      if (!last || !view || !width) return;
      // Pixels of the picture for each pixel of the page.
      const scale = view.width / width / view.scale;
      moved(id, [scale * (clientX - last[0]), scale * (clientY - last[1])]);
      last = [clientX, clientY];
    };
    button.onlostpointercapture = () => {
      if (last) ended();
      last = undefined;
    };
    button.onkeydown = (event) => {
      const by = KEYS[event.key];
      if (event.ctrlKey || event.metaKey || event.altKey || !(by || event.key === 'Home')) return;
      event.preventDefault();
      const factor = event.shiftKey ? 10 : 1;
      if (by) moved(id, [factor * by[0], factor * by[1]]);
      else reset(id);
      isKeyDown = true;
    };
    button.onkeyup = button.onblur = () => {
      if (isKeyDown) ended();
      isKeyDown = false;
    };
    return button;
  };

  return {
    element,
    show(handles, shownView) {
      view = shownView;
      const ids = handles && view ? handles.map(({ id }) => id) : [];
      for (const [id, button] of buttons) {
        if (ids.includes(id)) continue;
        button.remove();
        buttons.delete(id);
      }
      if (!handles || !view) return;
      for (const { id, posed } of handles) {
        const button = buttons.get(id) ?? gripOf(id);
        if (!buttons.has(id)) element.append(button);
        buttons.set(id, button);
        const mean = (axis: 0 | 1) => posed.reduce((sum, place) => sum + place[axis], 0) / posed.length;
        button.style.left = `${(100 * (view.x + view.scale * mean(0))) / view.width}%`;
        button.style.top = `${(100 * (view.y + view.scale * mean(1))) / view.height}%`;
      }
    },
  };
}
