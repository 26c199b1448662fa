/** A point on a board that pointers drag and arrow keys move. */
import type { Point } from '../../../src/core';
import type { Board } from './board';
import { element } from './elements';
import { SIZE } from './sizes';

/** Pixels of the picture that an arrow key moves by. */
const STEP = 4;
const LARGE_STEP = 20;

const STEPS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export interface DragPointOptions {
  readonly name: string;
  readonly at: Point;
  /** Selects the look in `figure.css`. */
  readonly kind: 'handle' | 'place';
  /** The nearest place that the point may have. */
  readonly allowed: (at: Point) => Point;
  readonly moved: () => void;
  /** Called when the point is pressed or focused. */
  readonly chosen?: () => void;
}

export class DragPoint {
  readonly button: HTMLButtonElement;
  readonly #options: DragPointOptions;
  #at: Point;

  constructor(board: Board, options: DragPointOptions) {
    this.#options = options;
    this.#at = options.at;
    this.button = element('button', {
      type: 'button',
      className: `point ${options.kind}`,
      ariaLabel: `${options.name}. Arrow keys move it.`,
    });
    this.#place();
    board.element.append(this.button);
    this.#listen(board);
  }

  get at(): Point {
    return this.#at;
  }

  /** Without `moved`. */
  set at(at: Point) {
    this.#at = at;
    this.#place();
  }

  #listen(board: Board): void {
    const { button } = this;
    let grip: Point | null = null;
    button.addEventListener('pointerdown', (event) => {
      button.setPointerCapture(event.pointerId);
      const [x, y] = board.placeOf(event);
      grip = [this.#at[0] - x, this.#at[1] - y];
      this.#options.chosen?.();
    });
    button.addEventListener('pointermove', (event) => {
      if (!grip) return;
      const [x, y] = board.placeOf(event);
      this.#move([x + grip[0], y + grip[1]]);
    });
    button.addEventListener('lostpointercapture', () => {
      grip = null;
    });
    button.addEventListener('focus', () => this.#options.chosen?.());
    button.addEventListener('keydown', (event) => {
      const direction = STEPS[event.key];
      if (!direction || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      const step = event.shiftKey ? LARGE_STEP : STEP;
      this.#move([this.#at[0] + step * direction[0], this.#at[1] + step * direction[1]]);
    });
  }

  /** In whole pixels, unless rounding leaves the domain. */
  #move([x, y]: Point): void {
    const at = this.#options.allowed([Math.round(x), Math.round(y)]);
    if (at[0] === this.#at[0] && at[1] === this.#at[1]) return;
    this.at = at;
    this.#options.moved();
  }

  #place(): void {
    this.button.style.left = `${(100 * this.#at[0]) / SIZE.width}%`;
    this.button.style.top = `${(100 * this.#at[1]) / SIZE.height}%`;
  }
}
