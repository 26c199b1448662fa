/** The frame of a figure: it loads the solver, lays out boards and controls, and asks and draws as things move. */
import './figure.css';
import { Board } from './board';
import { Chart } from './chart';
import { type Colours, coloursOf, onTheme } from './colours';
import { element } from './elements';
import { Latest } from './latest';
import { type Scene, scene } from './scene';

export interface Figure {
  readonly scene: Scene;
  /** Takes the boards. */
  readonly stage: HTMLElement;
  /** Takes controls, numbers and legends. */
  readonly panel: HTMLElement;
  /** Of the present theme. */
  readonly colours: Colours;
  /** Asks the solver again, then draws. */
  ask(): void;
  /** Draws the last answer. */
  draw(): void;
  /**
   * Makes a board.
   *
   * @param label Describes the drawing.
   * @param resized Called when the board needs to be drawn: without it, the last answer is.
   */
  board(label: string, resized?: () => void): Board;
  /** Makes a chart, which is drawn with the figure. */
  chart(): Chart;
}

export interface Live {
  /** Asks the solver. */
  answer(): Promise<void>;
  /** Draws the last answer. */
  draw(): void;
}

const NO_WASM = 'This figure computes in your browser, and this browser has no WebAssembly.';

/** Makes the function that mounts a figure in an element, and returns one that removes it. */
export const figure =
  (build: (figure: Figure) => Live) =>
  async (host: HTMLElement): Promise<() => void> => {
    const stage = element('div', { className: 'stage' });
    const panel = element('div', { className: 'panel' });
    const notice = element('p', { className: 'notice', role: 'status' }, 'The solver is loading.');
    const root = element('div', { className: 'figure' }, notice);
    host.append(root);
    const removals: (() => void)[] = [() => root.remove()];
    const failed = (error: unknown) => {
      notice.textContent = `This figure cannot run here: ${(error as Error).message}`;
      root.replaceChildren(notice);
    };
    if (typeof WebAssembly === 'undefined') {
      notice.textContent = NO_WASM;
      return () => root.remove();
    }
    try {
      const loaded = await scene();
      let drawable = false;
      let colours = coloursOf(root);
      const latest = new Latest(async () => {
        await live.answer();
        drawable = true;
        live.draw();
      }, failed);
      const draw = () => drawable && live.draw();
      const removed = <Part extends { dispose(): void }>(part: Part): Part => {
        removals.push(() => part.dispose());
        return part;
      };
      const live = build({
        scene: loaded,
        stage,
        panel,
        get colours() {
          return colours;
        },
        ask: () => latest.ask(),
        draw,
        board: (label, resized = draw) => removed(new Board(loaded.ground, label, resized)),
        chart: () => removed(new Chart(draw)),
      });
      removals.push(
        onTheme(() => {
          colours = coloursOf(root);
          draw();
        }),
      );
      root.replaceChildren(element('div', { className: 'parts' }, stage, panel));
      latest.ask();
    } catch (error) {
      failed(error);
    }
    return () => {
      for (const remove of removals) remove();
    };
  };
