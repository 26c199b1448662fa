/** Turns pointer and key events into tool presses in image pixels, cursors and nudges. */
import { handleById, selectedHandles } from '../document/document';
import { isLine } from '../document/handle';
import type { LineHandle } from '../document/project';
import { type Camera, panned, toImage, toStage } from '../geometry/camera';
import { edgesOf, type LinePlace, nearestPlace } from '../geometry/polyline';
import { add, distance, scaled, type Vec } from '../geometry/vec';
import { hand } from '../tools/hand';
import { hit } from '../tools/hit';
import type { Grips, Press, Scene } from '../tools/state';
import { type CommandName, commandsFor } from '../ui/commands';
import { Pointing, type PointingHost, type StagePointer } from '../ui/pointing';
import type { EditCommands } from './edit_commands';
import type { Editing } from './editing';
import { Keyboard } from './keyboard';
import type { Posing } from './posing';
import type { Viewing } from './viewing';

export interface InputHost {
  readonly editing: Editing;
  readonly commands: EditCommands;
  readonly viewing: Viewing;
  readonly posing: Posing;
  readonly editable: boolean;
  readonly disabled: boolean;
  readonly readonly: boolean;
  /** With `play`: handles can only be posed, and gestures and keys of the view are left to the page. Never changes. */
  readonly playing: boolean;
  /** Whether the original is shown, without handles. */
  readonly comparing: boolean;
  /** Camera, cursor or crosshair changed. */
  looked(): void;
  run(command: CommandName): void;
  compare(on: boolean): void;
  /** Cancels or dismisses the innermost thing in progress. Returns whether there was any. */
  bail(): boolean;
  say(text: string): void;
  /** Focuses a handle or one of its corners, or the stage without an id. */
  held(id: string | undefined, corner?: number): void;
}

/** Sizes of the hit areas for a mouse and for a finger, CSS pixels. See `Grips`. */
const REACH = {
  fine: { handle: 14, line: 9, ring: 40, band: 8, slop: 3 },
  coarse: { handle: 24, line: 20, ring: 52, band: 18, slop: 8 },
} as const;

/** CSS pixels that an arrow key moves the picture or the crosshair for each pixel that it would nudge. */
const ARROW_PAN = 40;
const ARROW_CROSSHAIR = 4;

/** A circular arrow: CSS has no cursor for rotation. */
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
  /** The last pointer position, and the camera at that moment. */
  #pointer: { readonly at: StagePointer; readonly camera: Camera } | null = null;
  /** Where Enter places a handle, image pixels; null until an arrow key has moved it. */
  crosshair: Vec | null = null;

  constructor(root: ShadowRoot, stage: HTMLElement, host: InputHost) {
    this.#root = root;
    this.#host = host;
    const pointing: PointingHost = {
      get camera() {
        return host.viewing.camera;
      },
      look: (camera) => this.#look(camera),
      pressDown: (pointer, pans) => this.#down(pointer, pans),
      pressMove: (pointer) => this.#apply(host.editing.machine.move(this.#press(pointer), this.scene)),
      pressUp: (pointer) => this.#up(pointer),
      pressCancel: () => this.#apply(host.editing.machine.cancel()),
      holds: (pointer) => this.#holds(pointer),
      pressedBeside: () => host.editable && host.editing.select([]),
      pressedTwice: (pointer) => this.#pressedTwice(this.#press(pointer).at),
      hover: (pointer) => this.#hover(pointer),
    };
    this.#pointing = new Pointing(stage, pointing, host.playing ? 'page' : 'editor');
    this.#keyboard = new Keyboard(root, {
      get disabled() {
        return host.disabled;
      },
      get commands() {
        return commandsFor(host.playing, host.readonly);
      },
      run: (command) => host.run(command),
      compare: (on) => host.compare(on),
      bail: () => host.bail(),
      space: (held) => this.#holdSpace(held),
      arrow: (by) => this.#arrow(by),
      turn: (degrees) => this.#turn(degrees),
      place: () => this.#placeByKey(),
    });
  }

  /** Current sizes of the hit areas, image pixels. */
  get grips(): Grips {
    const reach = this.#coarse ? REACH.coarse : REACH.fine;
    const { scale } = this.#host.viewing.camera;
    return {
      handle: reach.handle / scale,
      line: reach.line / scale,
      ring: reach.ring / scale,
      band: reach.band / scale,
      slop: reach.slop / scale,
    };
  }

  get press(): 'click' | 'tap' {
    return this.#coarse ? 'tap' : 'click';
  }

  get scene(): Scene {
    const { editing, posing } = this.#host;
    return {
      document: editing.document,
      grips: this.grips,
      turns: posing.turns(),
      place: (at) => posing.place(at),
      placeNear: (at) => posing.placeNear(at),
    };
  }

  get cursor(): string {
    const { machine } = this.#host.editing;
    if (this.#pans || machine.tool === 'hand') return machine.busy ? 'grabbing' : 'grab';
    if (machine.draft) return machine.draft.finishing ? 'pointer' : 'crosshair';
    const places = machine.tool !== 'select';
    const under = this.#hovered && this.#shown ? hit(this.scene, this.#hovered, !places) : null;
    if (under?.part === 'ring') return TURN_CURSOR;
    if (under) return machine.busy ? 'grabbing' : 'move';
    return places ? 'crosshair' : 'default';
  }

  /** Whether handles are visible and editable. */
  get #shown(): boolean {
    const { editable, comparing } = this.#host;
    return editable && !comparing;
  }

  /** Whether a press moves the view, whatever the tool. */
  get #pans(): boolean {
    return !this.#host.playing && (!this.#shown || this.#space);
  }

  /** Finishes the current drawing. */
  finish(): void {
    const { editing, editable } = this.#host;
    if (!editable) return;
    this.crosshair = null;
    this.#apply(editing.machine.finish(this.scene));
    if (!editing.machine.draft) this.#host.held(editing.document.selection[0]);
  }

  /** Adds a corner halfway after the focused corner, or else on the longest edge of the only selected handle. */
  addCorner(): void {
    const { document } = this.#host.editing;
    const corner = this.#focusedCorner;
    const [only, ...others] = selectedHandles(document);
    const handle = corner ? handleById(document, corner.id) : others.length === 0 ? only : undefined;
    if (!handle || !isLine(handle)) return;
    const lengths = edgesOf(handle.posed, handle.kind === 'polygon').map(([a, b]) => distance(a, b));
    const longest = lengths.indexOf(Math.max(...lengths));
    const edge = corner ? Math.min(corner.index, lengths.length - 1) : longest;
    this.#addCorner(handle, { edge, share: 0.5 });
  }

  /** Removes the focused corner and focuses the one before it. */
  removeCorner(): void {
    const corner = this.#focusedCorner;
    const handle = corner && handleById(this.#host.editing.document, corner.id);
    if (handle && isLine(handle)) this.#removeCorner(handle, corner.index);
  }

  /** Cancels what is in progress: a drag, a drawing, a number being typed. */
  stop(): void {
    this.crosshair = null;
    this.#finishField();
    this.#host.editing.giveUp();
    this.#host.looked();
  }

  /** Repeats the last hover if the camera has moved under a resting pointer. */
  follow(): void {
    const pointer = this.#pointer;
    if (pointer && pointer.camera !== this.#host.viewing.camera && !this.crosshair) this.#hover(pointer.at);
  }

  release(): void {
    this.#pointing.release();
    this.#keyboard.release();
  }

  #press(pointer: StagePointer): Press {
    const at = toImage(this.#host.viewing.camera, pointer.stage);
    return { at, stage: pointer.stage, shift: pointer.shift, alt: pointer.alt };
  }

  #holds(pointer: StagePointer): boolean {
    this.#coarse = pointer.coarse;
    return this.#shown && hit(this.scene, this.#press(pointer).at) !== null;
  }

  #down(pointer: StagePointer, pans: boolean): void {
    const { machine } = this.#host.editing;
    this.#coarse = pointer.coarse;
    this.#finishField();
    this.crosshair = null;
    const once = pans || this.#pans ? hand : undefined;
    this.#apply(machine.down(this.#press(pointer), this.scene, once));
  }

  /** Commits a number being typed before a press changes the selection, since it belongs to the current one. */
  #finishField(): void {
    const active = this.#root.activeElement;
    if (active instanceof HTMLInputElement) active.blur();
  }

  #up(pointer: StagePointer): void {
    const { editing } = this.#host;
    const press = this.#press(pointer);
    const drawing = editing.machine.draft !== null;
    const held = drawing ? null : hit(this.scene, press.at, editing.machine.tool === 'select');
    this.#apply(editing.machine.up(press, this.scene));
    const { selection } = editing.document;
    // Focusing a handle selects it: not one that a Shift-click has just deselected.
    const keeps = held !== null && held.part !== 'ring' && selection.includes(held.id);
    if (keeps && held.part === 'corner') this.#host.held(held.id, held.index);
    else this.#host.held(keeps ? held.id : selection[0]);
  }

  /** A double click removes a corner or adds one on a line. Select tool only: others end a drawing by it. */
  #pressedTwice(at: Vec): void {
    const { editing } = this.#host;
    if (this.#pans || editing.machine.tool !== 'select') return;
    const under = hit(this.scene, at, false);
    const handle = under && handleById(editing.document, under.id);
    if (!handle || !isLine(handle)) return;
    if (under.part === 'corner') this.#removeCorner(handle, under.index);
    if (under.part !== 'handle') return;
    const place = nearestPlace(handle.posed, handle.kind === 'polygon', at);
    if (place.away <= this.grips.line) this.#addCorner(handle, place);
  }

  #addCorner(handle: LineHandle, at: LinePlace): void {
    this.#host.held(handle.id, this.#host.commands.addCorner(handle, at));
  }

  #removeCorner(handle: LineHandle, index: number): void {
    const before = this.#host.commands.removeCorner(handle, index);
    if (before !== null) this.#host.held(handle.id, before);
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
    const press = pointer && this.#press(pointer);
    const { machine } = this.#host.editing;
    this.#hovered = press?.at ?? null;
    this.#pointer = pointer && { at: pointer, camera: this.#host.viewing.camera };
    machine.hover(press, this.scene);
    if (this.cursor !== before || machine.draft) this.#host.looked();
  }

  #holdSpace(held: boolean): boolean {
    if (this.#host.playing) return false;
    if (this.#space === held) return true;
    this.#space = held;
    this.#pointing.space = held;
    this.#host.looked();
    return true;
  }

  #turn(degrees: number): boolean {
    const { editing, commands, editable } = this.#host;
    if (!editable || editing.document.selection.length === 0) return false;
    commands.turn(degrees);
    return true;
  }

  /** Nudges the focused corner, else the selected handles; else moves a placing tool's crosshair, or the picture. */
  #arrow(by: Vec): boolean {
    const { editing, commands, viewing, editable } = this.#host;
    const { draft } = editing.machine;
    const corner = this.#focusedCorner;
    if (editable && corner && !draft) commands.nudgeCorner(corner.id, corner.index, by);
    else if (editable && editing.document.selection.length > 0 && !draft) commands.nudge(by);
    else if (editable && this.#places) {
      const step = ARROW_CROSSHAIR / viewing.camera.scale;
      this.crosshair = this.#inView(
        add(this.crosshair ?? draft?.corners.at(-1) ?? this.#middle, scaled(by, step)),
      );
      editing.machine.hover(this.#pressAt(this.crosshair), this.scene);
      this.#host.say(`x ${Math.round(this.crosshair[0])}, y ${Math.round(this.crosshair[1])}`);
      this.#host.looked();
    } else if (this.#host.playing) return false;
    else this.#look(panned(viewing.camera, scaled(by, -ARROW_PAN)));
    return true;
  }

  /** Places a handle or sets a corner at the crosshair; without a crosshair, finishes the current drawing. */
  #placeByKey(): boolean {
    const { editing, editable } = this.#host;
    const { machine } = editing;
    if (!editable || !this.#places) return false;
    // A pointer press is in progress: ignore the key.
    if (machine.busy) return true;
    if (machine.draft && !this.crosshair) {
      this.finish();
      return true;
    }
    const press = this.#pressAt(this.crosshair ?? this.#middle);
    // No hit areas: Enter always places, even on an existing handle.
    const scene = { ...this.scene, grips: { ...this.grips, handle: -1, line: -1, band: -1 } };
    this.#apply(machine.down(press, scene));
    this.#apply(machine.up(press, scene));
    this.crosshair = null;
    const [added] = editing.document.selection;
    if (added && handleById(editing.document, added)) this.#host.held(added);
    return true;
  }

  /** Whether the current tool places something on the picture. */
  get #places(): boolean {
    const { tool } = this.#host.editing.machine;
    return tool !== 'select' && tool !== 'hand';
  }

  /** The nearest point within the stage, image pixels. */
  #inView(at: Vec): Vec {
    const { camera, stage } = this.#host.viewing;
    const [x, y] = toStage(camera, at);
    const within = (value: number, most: number) => Math.min(Math.max(value, 0), most);
    return toImage(camera, [within(x, stage.width), within(y, stage.height)]);
  }

  #pressAt(at: Vec): Press {
    return { at, stage: at, shift: false, alt: false };
  }

  /** The corner whose button has the focus, or null. */
  get #focusedCorner(): { readonly id: string; readonly index: number } | null {
    const active = this.#root.activeElement;
    if (!(active instanceof HTMLElement)) return null;
    const { of: id, corner } = active.dataset;
    return id === undefined || corner === undefined ? null : { id, index: Number(corner) };
  }

  get #middle(): Vec {
    const { camera, middle } = this.#host.viewing;
    return toImage(camera, middle);
  }
}
