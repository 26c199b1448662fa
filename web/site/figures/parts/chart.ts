/** A small chart on a canvas: axes, curves, and lines across it. */
import { css, type Rgb } from './colours';
import { element } from './elements';

export interface Axes {
  readonly x: readonly [from: number, to: number];
  readonly y: readonly [from: number, to: number];
  readonly xTicks: readonly number[];
  readonly yTicks: readonly number[];
  readonly xName: string;
}

/** CSS pixels between the canvas and the axes. */
const LEFT = 34;
const RIGHT = 12;
const TOP = 20;
const BOTTOM = 40;
const HEIGHT = 190;

export class Chart {
  readonly element: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D;
  readonly #observer: ResizeObserver;
  #axes: Axes = { x: [0, 1], y: [0, 1], xTicks: [], yTicks: [], xName: '' };

  constructor(resized: () => void) {
    this.element = element('canvas', { className: 'chart', role: 'img' });
    const context = this.element.getContext('2d');
    if (!context) throw new Error('this browser has no 2D canvas');
    this.#context = context;
    this.#observer = new ResizeObserver(() => {
      const width = Math.round(this.element.clientWidth * devicePixelRatio);
      if (width === 0 || width === this.element.width) return;
      this.element.width = width;
      this.element.height = Math.round(HEIGHT * devicePixelRatio);
      resized();
    });
    this.#observer.observe(this.element);
  }

  dispose(): void {
    this.#observer.disconnect();
  }

  /** Clears the chart and draws its axes. @param label Describes the chart. */
  begin(axes: Axes, label: string, ink: Rgb, line: Rgb): void {
    this.#axes = axes;
    this.element.ariaLabel = label;
    const context = this.#context;
    context.resetTransform();
    context.clearRect(0, 0, this.element.width, this.element.height);
    context.scale(devicePixelRatio, devicePixelRatio);
    context.font = `12px ${getComputedStyle(this.element).fontFamily}`;
    context.lineJoin = 'round';
    this.#stroke(line, 1);
    context.beginPath();
    context.moveTo(LEFT, TOP);
    context.lineTo(LEFT, HEIGHT - BOTTOM);
    context.lineTo(this.#width - RIGHT, HEIGHT - BOTTOM);
    context.stroke();
    for (const tick of axes.xTicks)
      this.#text(String(tick), this.#x(tick), HEIGHT - BOTTOM + 16, ink, 'center');
    for (const tick of axes.yTicks) this.#text(String(tick), LEFT - 6, this.#y(tick) + 4, ink, 'right');
    this.#text(axes.xName, this.#width - RIGHT, HEIGHT - 6, ink, 'right');
  }

  curve(points: readonly (readonly [number, number])[], colour: Rgb, filled = false): void {
    const context = this.#context;
    context.beginPath();
    for (const [x, y] of points) context.lineTo(this.#x(x), this.#y(y));
    this.#stroke(colour, 2);
    context.stroke();
    if (!filled) return;
    context.lineTo(this.#x(points.at(-1)?.[0] ?? 0), this.#y(0));
    context.lineTo(this.#x(points[0]?.[0] ?? 0), this.#y(0));
    context.fillStyle = css(colour, 0.12);
    context.fill();
  }

  /** A vertical line for a radius r with an index. @param row Counts lines of text down from the top. */
  radius(x: number, index: string, colour: Rgb, row: number): void {
    const at = this.#x(x);
    this.#rule([at, TOP], [at, HEIGHT - BOTTOM], colour);
    const context = this.#context;
    const { font } = context;
    const left = at - 16;
    const top = TOP + 4 + 18 * row;
    context.font = font.replace('12px', 'italic 14px');
    this.#text('r', left, top, colour, 'left');
    context.font = font.replace('12px', '11px');
    this.#text(index, left + 6, top + 4, colour, 'left');
    context.font = font;
  }

  /** A horizontal line with its name. */
  horizontal(y: number, name: string, colour: Rgb): void {
    const at = this.#y(y);
    this.#rule([LEFT, at], [this.#width - RIGHT, at], colour);
    this.#text(name, LEFT + 6, at - 5, colour, 'left');
  }

  dot([x, y]: readonly [number, number], colour: Rgb): void {
    this.#context.beginPath();
    this.#context.arc(this.#x(x), this.#y(y), 5, 0, 2 * Math.PI);
    this.#context.fillStyle = css(colour);
    this.#context.fill();
  }

  get #width(): number {
    return this.element.width / devicePixelRatio;
  }

  #x(x: number): number {
    const [from, to] = this.#axes.x;
    return LEFT + ((x - from) / (to - from)) * (this.#width - LEFT - RIGHT);
  }

  #y(y: number): number {
    const [from, to] = this.#axes.y;
    return HEIGHT - BOTTOM - ((y - from) / (to - from)) * (HEIGHT - BOTTOM - TOP);
  }

  #rule(from: readonly [number, number], to: readonly [number, number], colour: Rgb): void {
    this.#stroke(colour, 1.25);
    this.#context.setLineDash([4, 3]);
    this.#context.beginPath();
    this.#context.moveTo(...from);
    this.#context.lineTo(...to);
    this.#context.stroke();
    this.#context.setLineDash([]);
  }

  #text(text: string, x: number, y: number, colour: Rgb, align: CanvasTextAlign): void {
    this.#context.fillStyle = css(colour);
    this.#context.textAlign = align;
    this.#context.fillText(text, x, y);
  }

  #stroke(colour: Rgb, width: number): void {
    this.#context.strokeStyle = css(colour);
    this.#context.lineWidth = width;
  }
}
