/** The canvas of a player: its size in device pixels, and whether it is in sight. */
import type { View } from './painter';

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Screen {
  readonly context: CanvasRenderingContext2D | null;
  readonly isSeen: boolean;
  /** Follows the size and the place of the element, until `unwatch`. */
  watch(): void;
  unwatch(): void;
  /** Shows the canvas, shaped as a picture of this size. Null shows the content of the element in its place. */
  showPicture(size: Size | null): void;
  /** A picture of this size as large as fits, in the middle; null on a canvas without a size. */
  viewOf(size: Size): View | null;
}

interface Listeners {
  /** It came into sight, or left it. */
  seen(): void;
  /** The canvas has another size, and is empty. */
  sized(): void;
}

/** The longest side of a drawing, device pixels. Some graphics cards have no larger ones. */
const MOST_PX = 4096;

const SHEET = `:host{display:inline-block;position:relative}:host([hidden]),slot[hidden],canvas[hidden]{display:none}canvas{position:absolute;inset:0;width:100%;height:100%}`;

export function screenOf(host: HTMLElement, listeners: Listeners): Screen {
  const root = host.attachShadow({ mode: 'open' });
  const canvas = document.createElement('canvas');
  canvas.setAttribute('part', 'canvas');
  canvas.hidden = true;
  const content = document.createElement('slot');
  root.append(canvas, content);
  // Style sheets of this kind are allowed by every security policy.
  const [fixed, shape] = [new CSSStyleSheet(), new CSSStyleSheet()];
  fixed.replaceSync(SHEET);
  root.adoptedStyleSheets = [fixed, shape];

  let isSeen = false;
  const sight = new IntersectionObserver((entries) => {
    isSeen = entries.at(-1)?.isIntersecting === true;
    listeners.seen();
  });
  const size = new ResizeObserver((entries) => {
    const { contentRect, devicePixelContentBoxSize } = entries.at(-1) as ResizeObserverEntry;
    // Safari does not know the exact size.
    const exact = devicePixelContentBoxSize?.[0];
    const width = exact?.inlineSize ?? Math.round(contentRect.width * devicePixelRatio);
    const height = exact?.blockSize ?? Math.round(contentRect.height * devicePixelRatio);
    const shrunk = Math.min(1, MOST_PX / Math.max(width, height));
    canvas.width = Math.floor(width * shrunk);
    canvas.height = Math.floor(height * shrunk);
    listeners.sized();
  });

  return {
    context: canvas.getContext('2d'),
    get isSeen() {
      return isSeen;
    },
    watch() {
      sight.observe(host);
      try {
        size.observe(canvas, { box: 'device-pixel-content-box' });
      } catch {
        size.observe(canvas);
      }
    },
    unwatch() {
      sight.disconnect();
      size.disconnect();
      isSeen = false;
    },
    showPicture(size) {
      canvas.hidden = !size;
      content.hidden = size !== null;
      const { width, height } = size ?? { width: 0, height: 0 };
      const sheet = `:host{width:${width}px;max-width:100%;aspect-ratio:${width}/${height}}`;
      shape.replaceSync(size ? sheet : '');
    },
    viewOf(size) {
      const { width, height } = canvas;
      if (width === 0 || height === 0) return null;
      const scale = Math.min(width / size.width, height / size.height);
      const x = (width - size.width * scale) / 2;
      const y = (height - size.height * scale) / 2;
      return { width, height, scale, x, y };
    },
  };
}
