/** From pointers and keys to the tools: presses in image pixels, what the pointer would take hold of, nudges. */
import { handleById } from '../document/document';
import { type Camera, toImage } from '../geometry/camera';
import { add, scaled, type Vec } from '../geometry/vec';
import { hand } from '../tools/hand';
import { hit } from '../tools/hit';
import type { Grips, Press, Scene } from '../tools/state';
import type { CommandName } from '../ui/commands';
import { Pointing, type StagePointer } from '../ui/pointing';
import type { Editing } from './editing';
import { Keyboard } from './keyboard';
import type { Posing } from './posing';
import type { Viewing } from './viewing';

export interface InputHost {
  readonly editing: Editing;
  readonly viewing: Viewing;
  readonly posing: Posing;
  readonly editable: boolean;
  /** Camera, cursor or crosshair changed. */
  looked(): void;
  run(command: CommandName): void;
  compare(on: boolean): void;
  /** A press has ended on this handle: it takes the focus. */
  held(id: string | undefined): void;
}

/** CSS pixels that the controls reach, for a mouse and for a finger. */
const REACH = {
  fine: { handle: 14, ring: 40, band: 8, slop: 3 },
  coarse: { handle: 24, ring: 52, band: 18, slop: 8 },
} as const;

/** An arrow key moves the picture or the crosshair by this many CSS pixels for each pixel it would nudge. */
const ARROW_PAN = 40;
const ARROW_CROSSHAIR = 4;

/** A turning arrow, since CSS has no cursor for it. */
const TURN_CURSOR = `url("data:image/svg+xml,${encodeURIComponent(
  `<svg xmlns='http://www.w3.org/2000/svg' width='24' height='24' fill='none' stroke-linecap='round' stroke-linejoin='round'>
  <g id='a'><path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='white' stroke-width='4'/></g>
  <path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='black' stroke-width='1.8'/></svg>`,
)}") 12 12, grab`;

export class Input {
  readonly #root: ShadowRoot;
  readonly #host: InputHost;
  readonly #pointing: Pointing;
  readonly #keyboard: Keyboard;
  #coarse = matchMedia('(pointer: coarse)').matches;
  #space = false;
  #hovered: Vec | null = null;
  /** Where Enter places a handle, once an arrow key has moved it. Image pixels. */
  crosshair: Vec | null = null;

  constructor(root: ShadowRoot, stage: HTMLElement, host: InputHost) {
    this.#root = root;
    this.#host = host;
    this.#pointing = new Pointing(stage, {
      get camera() {
        return host.viewing.camera;
      },
      look: (camera) => this.#look(camera),
      pressDown: (pointer, pans) => this.#down(pointer, pans),
      pressMove: (pointer) => this.#apply(host.editing.machine.move(this.#press(pointer), this.scene)),
      pressUp: (pointer) => this.#up(pointer),
      pressCancel: () => this.#apply(host.editing.machine.cancel()),
      hover: (pointer) => this.#hover(pointer),
    });
    this.#keyboard = new Keyboard(root, {
      run: (command) => host.run(command),
      compare: (on) => host.compare(on),
      space: (held) => this.#holdSpace(held),
      arrow: (by) => this.#arrow(by),
      turn: (degrees) =>
        host.editable && host.editing.document.selection.length > 0 && host.editing.turn(degrees),
      place: () => this.#placeByKey(),
    });
  }

  /** How far the controls reach now, image pixels. */
  get grips(): Grips {
    const reach = this.#coarse ? REACH.coarse : REACH.fine;
    const { scale } = this.#host.viewing.camera;
    return {
      handle: reach.handle / scale,
      ring: reach.ring / scale,
      band: reach.band / scale,
      slop: reach.slop / scale,
    };
  }

  get scene(): Scene {
    const { editing, posing } = this.#host;
    return {
      document: editing.document,
      grips: this.grips,
      turns: posing.turns(),
      place: (at) => posing.place(at),
    };
  }

  get cursor(): string {
    const { machine } = this.#host.editing;
    if (this.#space || machine.tool === 'hand') return machine.busy ? 'grabbing' : 'grab';
    const under = this.#hovered && this.#host.editable ? hit(this.scene, this.#hovered) : null;
    if (under?.part === 'ring') return TURN_CURSOR;
    if (under) return machine.busy ? 'grabbing' : 'move';
    return machine.tool === 'point' ? 'crosshair' : 'default';
  }

  release(): void {
    this.#pointing.release();
    this.#keyboard.release();
  }

  #press(pointer: StagePointer): Press {
    const at = toImage(this.#host.viewing.camera, pointer.stage);
    return { at, stage: pointer.stage, shift: pointer.shift, alt: pointer.alt };
  }

  #down(pointer: StagePointer, pans: boolean): void {
    const { machine } = this.#host.editing;
    this.#coarse = pointer.coarse;
    this.#finishField();
    this.crosshair = null;
    const once = pans || !this.#host.editable ? hand : undefined;
    this.#apply(machine.down(this.#press(pointer), this.scene, once));
  }

  /** A number being typed belongs to what is selected now: it is committed before the press selects something else. */
  #finishField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement) active.blur();
  }

  #up(pointer: StagePointer): void {
    const { editing } = this.#host;
    const press = this.#press(pointer);
    const held = hit(this.scene, press.at);
    this.#apply(editing.machine.up(press, this.scene));
    this.#host.held(held?.part === 'handle' ? held.id : editing.document.selection[0]);
  }

  #apply(effects: Parameters<Editing['apply']>[0]): void {
    this.#host.editing.apply(effects);
    this.#host.looked();
  }

  #look(camera: Camera): void {
    this.#host.viewing.look(camera);
    this.#host.looked();
  }

  #hover(pointer: StagePointer | null): void {
    const before = this.cursor;
    this.#hovered = pointer && this.#press(pointer).at;
    if (this.cursor !== before) this.#host.looked();
  }

  #holdSpace(held: boolean): void {
    if (this.#space === held) return;
    this.#space = held;
    this.#pointing.space = held;
    this.#host.looked();
  }

  /** Nudges what is selected; with the point tool and nothing selected, the crosshair; else the picture. */
  #arrow(by: Vec): void {
    const { editing, viewing, editable } = this.#host;
    if (editable && editing.document.selection.length > 0) editing.nudge(by);
    else if (editable && editing.machine.tool === 'point') {
      const step = ARROW_CROSSHAIR / viewing.camera.scale;
      this.crosshair = add(this.crosshair ?? this.#middle, scaled(by, step));
      this.#host.looked();
    } else {
      const { camera } = viewing;
      this.#look({ ...camera, x: camera.x - ARROW_PAN * by[0], y: camera.y - ARROW_PAN * by[1] });
    }
  }

  #placeByKey(): void {
    const { editing, editable } = this.#host;
    if (!editable || editing.machine.tool !== 'point') return;
    const at = this.crosshair ?? this.#middle;
    const press: Press = { at, stage: at, shift: false, alt: false };
    // Away from handles' reach does not matter here: what is asked for is a new one.
    const scene = { ...this.scene, grips: { ...this.grips, handle: -1, band: -1 } };
    this.#apply(editing.machine.down(press, scene));
    this.#apply(editing.machine.up(press, scene));
    this.crosshair = null;
    const [added] = editing.document.selection;
    if (added && handleById(editing.document, added)) this.#host.held(added);
  }

  get #middle(): Vec {
    const { camera, middle } = this.#host.viewing;
    return toImage(camera, middle);
  }
}
