/** A canvas with the picture's shape: figures draw on it in pixels of the picture. */
import type { Point } from '../../../src/core';
import { css, type Rgb } from './colours';
import { element } from './elements';
import type { Ground } from './ground';
import type { PixelMap } from './pixel_map';
import { SIZE } from './sizes';

/** More pixels than this a CSS pixel cost time and show nothing. */
const MOST_PIXELS = 2;

export class Board {
  readonly element: HTMLElement;
  readonly #canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D;
  readonly #ground: Ground;
  readonly #observer: ResizeObserver;

  /** @param label Describes the drawing. @param resized Called when the board needs to be drawn. */
  constructor(ground: Ground, label: string, resized: () => void) {
    this.#ground = ground;
    this.#canvas = element('canvas', { role: 'img', ariaLabel: label });
    this.element = element('div', { className: 'board' }, this.#canvas);
    const context = this.#canvas.getContext('2d');
    if (!context) throw new Error('this browser has no 2D canvas');
    this.#context = context;
    this.#observer = new ResizeObserver(() => {
      const { width } = this.element.getBoundingClientRect();
      const pixels = Math.round(width * this.#density);
      if (pixels === 0 || pixels === this.#canvas.width) return;
      this.#canvas.width = pixels;
      this.#canvas.height = Math.round((pixels * SIZE.height) / SIZE.width);
      resized();
    });
    this.#observer.observe(this.element);
  }

  dispose(): void {
    this.#observer.disconnect();
  }

  /** Device pixels a pixel of the picture; 0 until the board has a size. */
  get scale(): number {
    return this.#canvas.width / SIZE.width;
  }

  /** Device pixels a CSS pixel. */
  get #density(): number {
    return Math.min(devicePixelRatio, MOST_PIXELS);
  }

  get pixels(): PixelMap {
    return this.#ground.pixels(this.#canvas.width, this.#canvas.height, this.scale);
  }

  /** The place of a pointer, in pixels of the picture. */
  placeOf({ clientX, clientY }: MouseEvent): Point {
    const { left, top, width, height } = this.element.getBoundingClientRect();
    return [((clientX - left) * SIZE.width) / width, ((clientY - top) * SIZE.height) / height];
  }

  /** Clears the board and draws an image of device pixels on it. */
  begin(image?: ImageData, [x, y]: readonly [number, number] = [0, 0]): void {
    this.#context.resetTransform();
    this.#context.clearRect(0, 0, this.#canvas.width, this.#canvas.height);
    if (image) this.#context.putImageData(image, x, y);
    this.#context.scale(this.scale, this.scale);
    this.#context.lineJoin = 'round';
    this.#context.lineCap = 'round';
  }

  outline(colour: Rgb): void {
    this.#stroke(colour, 1.5, []);
    this.#context.stroke(this.#ground.path);
  }

  /** Circles inside the shape. */
  circles([x, y]: Point, radii: readonly number[], colour: Rgb): void {
    this.#context.save();
    this.#context.clip(this.#ground.path, 'evenodd');
    this.#stroke(colour, 1.25, [4, 4]);
    for (const radius of radii) {
      this.#context.beginPath();
      this.#context.arc(x, y, radius, 0, 2 * Math.PI);
      this.#context.stroke();
    }
    this.#context.restore();
  }

  /** @param points Points × 2. @param width CSS pixels. */
  line(points: ArrayLike<number>, colour: Rgb, { width = 2, dashed = false, casing }: LineLook = {}): void {
    this.#context.beginPath();
    for (let at = 0; at < points.length; at += 2) {
      this.#context.lineTo(points[at] as number, points[at + 1] as number);
    }
    if (casing) {
      this.#stroke(casing, width + 3, []);
      this.#context.stroke();
    }
    this.#stroke(colour, width, dashed ? [5, 5] : []);
    this.#context.stroke();
  }

  /** Fills triangles. @param corners Triangles × 6 coordinates. */
  triangles(corners: readonly (readonly number[])[], colour: Rgb): void {
    this.#context.beginPath();
    for (const [ax = 0, ay = 0, bx = 0, by = 0, cx = 0, cy = 0] of corners) {
      this.#context.moveTo(ax, ay);
      this.#context.lineTo(bx, by);
      this.#context.lineTo(cx, cy);
      this.#context.closePath();
    }
    this.#context.fillStyle = css(colour);
    this.#context.fill();
    // Thin ones would not be seen.
    this.#stroke(colour, 1, []);
    this.#context.stroke();
  }

  /** @param radius CSS pixels. */
  dot([x, y]: Point, radius: number, colour: Rgb, casing: Rgb): void {
    this.#context.beginPath();
    this.#context.arc(x, y, this.#length(radius), 0, 2 * Math.PI);
    this.#stroke(casing, 3, []);
    this.#context.stroke();
    this.#context.fillStyle = css(colour);
    this.#context.fill();
  }

  /** A ring of a radius in pixels of the picture. */
  ring([x, y]: Point, radius: number, colour: Rgb): void {
    this.#context.beginPath();
    this.#context.arc(x, y, radius, 0, 2 * Math.PI);
    this.#stroke(colour, 1.5, [4, 4]);
    this.#context.stroke();
  }

  #stroke(colour: Rgb, width: number, dashes: readonly number[]): void {
    this.#context.strokeStyle = css(colour);
    this.#context.lineWidth = this.#length(width);
    this.#context.setLineDash(dashes.map((dash) => this.#length(dash)));
  }

  /** CSS pixels in pixels of the picture. */
  #length(css: number): number {
    return (css * this.#density) / this.scale;
  }
}

export interface LineLook {
  readonly width?: number;
  readonly dashed?: boolean;
  readonly casing?: Rgb;
}
