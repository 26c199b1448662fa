/** The canvas of a player: its size in device pixels, and whether it is in view. */
import { GRIP_SHEET } from './grips';
import type { View } from './painter';

export interface Size {
  readonly width: number;
  readonly height: number;
}

export interface Screen {
  readonly context: CanvasRenderingContext2D | null;
  readonly isSeen: boolean;
  /** Follows the size and the position of the element, until `unwatch`. */
  watch(): void;
  unwatch(): void;
  /** Shows the canvas in the shape of a picture of this size. Null shows the poster or the slotted content instead. */
  showPicture(size: Size | null): void;
  /** The address of an image to show until the picture is ready; empty for no image. */
  setPoster(address: string): void;
  /** The size that the page sets; by default, the size of the picture, or else of the poster. */
  setSize(size: Size | null): void;
  /** The view of a picture of this size, as large as possible and centred; null on an empty canvas. */
  viewOf(size: Size): View | null;
}

interface Listeners {
  /** It came into view, or left it. */
  seen(): void;
  /** The canvas was resized, and is empty. */
  sized(): void;
}

/** The longest side of a drawing, device pixels. Some graphics cards do not support larger ones. */
const MOST_PX = 4096;

const SHEET = `:host{display:inline-block;position:relative}:host([hidden]),[hidden]{display:none}canvas,img{position:absolute;inset:0;width:100%;height:100%;object-fit:contain}`;

/** @param grips shown above the picture. */
export function screenOf(host: HTMLElement, grips: HTMLElement, listeners: Listeners): Screen {
  const root = host.attachShadow({ mode: 'open' });
  const canvas = document.createElement('canvas');
  canvas.setAttribute('part', 'canvas');
  const content = document.createElement('slot');
  const poster = document.createElement('img');
  poster.setAttribute('part', 'poster');
  poster.alt = '';
  root.append(canvas, poster, content, grips);
  // Style sheets of this kind are allowed by every security policy.
  const [fixed, shape] = [new CSSStyleSheet(), new CSSStyleSheet()];
  fixed.replaceSync(SHEET + GRIP_SHEET);
  root.adoptedStyleSheets = [fixed, shape];

  let picture: Size | null = null;
  let given: Size | null = null;
  const arrange = () => {
    const { naturalWidth: width, naturalHeight: height } = poster;
    const hasPoster = width > 0 && poster.hasAttribute('src');
    canvas.hidden = !picture;
    poster.hidden = picture !== null || !hasPoster;
    content.hidden = picture !== null || hasPoster;
    const size = given ?? picture ?? (hasPoster ? { width, height } : null);
    const sheet = `:host{width:${size?.width}px;max-width:100%;aspect-ratio:${size?.width}/${size?.height}}`;
    shape.replaceSync(size ? sheet : '');
  };
  poster.onload = arrange;
  poster.onerror = arrange;
  arrange();

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
      picture = size;
      arrange();
    },
    setPoster(address) {
      if (address) poster.src = address;
      else poster.removeAttribute('src');
      arrange();
    },
    setSize(size) {
      given = size;
      arrange();
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
