/** The stage on the page: listens to its size, to pointer and keys, and draws on its canvas. */
import { deviceView, toImage, toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { clientToStage, stageToClient } from '../ui/client';
import type { CommandRunner } from './command_runner';
import type { ContextMenu } from './context_menu';
import type { Crosshair } from './crosshair';
import type { Display } from './display';
import { Drawing } from './drawing';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import { Input } from './input';
import { Keyboard } from './keyboard';
import type { LineCommands } from './line_commands';
import type { Notices } from './notices';
import type { Permissions } from './permissions';
import type { Reaching } from './reaching';
import type { StageKeys } from './stage_keys';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

export interface StageHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly notices: Notices;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly areas: HitAreas;
  readonly crosshair: Crosshair;
  readonly lines: LineCommands;
  readonly focus: Focus;
  readonly commands: CommandRunner;
  readonly menu: ContextMenu;
  readonly stageKeys: StageKeys;
  readonly reaching: Reaching;
  /** Size, camera, cursor or crosshair changed. */
  looked(): void;
}

export class Stage {
  /** Null without WebGL2. */
  readonly drawing: Drawing | null;
  readonly #root: ShadowRoot;
  readonly #element: HTMLElement;
  readonly #host: StageHost;
  readonly #sizing: ResizeObserver;
  #input: Input;
  #keyboard: Keyboard;

  constructor(root: ShadowRoot, element: HTMLElement, canvas: HTMLCanvasElement, host: StageHost) {
    this.#root = root;
    this.#element = element;
    this.#host = host;
    this.#sizing = new ResizeObserver(([entry]) => entry && this.#resized(entry.contentRect));
    this.#sizing.observe(element);
    this.#measure();
    [this.#input, this.#keyboard] = this.#listen();
    this.drawing = this.#draw(canvas);
  }

  get cursor(): string {
    return this.#input.cursor;
  }

  /** The place of the picture, image pixels, at a place in the window. */
  imageAt(client: Vec): Vec {
    return toImage(this.#host.viewing.camera, clientToStage(this.#element, client));
  }

  /** The place in the window of a place of the picture, image pixels. */
  clientAt(image: Vec): Vec {
    return stageToClient(this.#element, toStage(this.#host.viewing.camera, image));
  }

  /** Adapts to the current `play` and `readonly`. */
  rearrange(): void {
    this.#release();
    [this.#input, this.#keyboard] = this.#listen();
    this.#measure();
    this.#host.viewing.fit();
    this.#host.looked();
  }

  /** Cancels what is in progress: a drag, a drawing, a number being typed. */
  stop(): void {
    this.#host.menu.close();
    this.#host.crosshair.at = null;
    this.#host.focus.leaveField();
    this.#host.workbench.editing.giveUp();
    this.#host.looked();
  }

  /** Camera, cursor or crosshair has changed: draw again. */
  look(): void {
    this.#input.follow();
    this.drawing?.look();
  }

  dispose(): void {
    this.#sizing.disconnect();
    this.#host.menu.close();
    this.#release();
    this.drawing?.dispose();
  }

  #listen(): [Input, Keyboard] {
    const { permissions, display, commands, stageKeys } = this.#host;
    const input = new Input(this.#element, this.#host);
    return [input, new Keyboard(this.#root, { permissions, display, commands, stageKeys, input })];
  }

  #draw(canvas: HTMLCanvasElement): Drawing | null {
    const { workbench, viewing, display, reaching, notices } = this.#host;
    const { posing } = workbench;
    try {
      return new Drawing(canvas, {
        view: () => ({
          ...deviceView(viewing.camera, viewing.stage, devicePixelRatio),
          compare: display.original,
          overlays: display.bare || display.lassoing ? {} : display.overlays,
          pixelated: display.pixelated,
        }),
        pose: () => posing.pose(),
        came: () => this.#host.looked(),
        heat: () => {
          if (display.bare || display.lassoing) return null;
          const { reach, coverage } = display.overlays;
          const values = coverage ? posing.coverage() : reach ? reaching.reach() : null;
          return values && { values, lines: reach };
        },
      });
    } catch (error) {
      notices.report(error);
      return null;
    }
  }

  #measure(): void {
    const { clientWidth: width, clientHeight: height } = this.#element;
    this.#host.viewing.resize({ width, height });
  }

  #resized({ width, height }: DOMRectReadOnly): void {
    const { workbench, viewing, areas, focus } = this.#host;
    const { editing } = workbench;
    // A hidden stage receives no more pointer moves.
    if (width === 0 || height === 0) editing.apply(editing.machine.cancel());
    viewing.resize(
      { width, height },
      {
        typing: focus.isInField && areas.press === 'tap',
        pressing: editing.machine.busy,
      },
    );
    this.#host.looked();
  }

  #release(): void {
    this.#input.release();
    this.#keyboard.release();
  }
}
