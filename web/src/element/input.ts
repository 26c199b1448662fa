/** Turns the pointer on the stage into tool presses in image pixels, and shows what it is over by its cursor. */
import { selectedHandles } from '../document/document';
import { groupTurn } from '../document/group';
import { type Camera, toImage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import { hand } from '../tools/hand';
import { type Hit, hit } from '../tools/hit';
import { places } from '../tools/machine';
import { withoutRings } from '../tools/pressing';
import type { Effect, Press } from '../tools/state';
import { Pointing, type StagePointer } from '../ui/pointing';
import type { ContextMenu } from './context_menu';
import type { Crosshair } from './crosshair';
import type { Display } from './display';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import type { LineCommands } from './line_commands';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

export interface InputHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly areas: HitAreas;
  readonly crosshair: Crosshair;
  readonly lines: LineCommands;
  readonly focus: Focus;
  readonly menu: ContextMenu;
  /** Camera, cursor or crosshair changed. */
  looked(): void;
}

/** A circular arrow: CSS has no cursor for rotation. */
const TURN_CURSOR = `url("data:image/svg+xml,${encodeURIComponent(
  `<svg xmlns='http://www.w3.org/2000/svg' width='24' height='24' fill='none' stroke-linecap='round' stroke-linejoin='round'>
  <g id='a'><path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='white' stroke-width='4'/></g>
  <path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='black' stroke-width='1.8'/></svg>`,
)}") 12 12, grab`;

/** Where the grip leads: by eighths that the ring is turned. */
const SCALE_DIRECTIONS = ['nwse', 'ns', 'nesw', 'ew'] as const;

export class Input {
  readonly #host: InputHost;
  readonly #pointing: Pointing;
  #space = false;
  #hovered: Vec | null = null;
  /** Whether the last press was on something that was there before. */
  #pressed = false;
  /** The last pointer position, and the camera at that moment. */
  #pointer: { readonly at: StagePointer; readonly camera: Camera } | null = null;

  constructor(stage: HTMLElement, host: InputHost) {
    this.#host = host;
    const { workbench, viewing, permissions, areas } = host;
    const { editing } = workbench;
    this.#pointing = new Pointing(
      stage,
      {
        get camera() {
          return viewing.camera;
        },
        look: (camera) => this.#look(camera),
        pressDown: (pointer, pans) => this.#down(pointer, pans),
        pressMove: (pointer) => this.#apply(editing.machine.move(this.#press(pointer), areas.scene)),
        pressUp: (pointer) => this.#up(pointer),
        pressCancel: () => this.#apply(editing.machine.cancel()),
        holds: (pointer) => this.#holds(pointer),
        pressedBeside: () => permissions.editable && editing.select([]),
        menu: (pointer, staying) => this.#menu(pointer, staying),
        pressedTwice: (pointer) => this.#pressedTwice(pointer),
        hover: (pointer) => this.#hover(pointer),
      },
      permissions.playing ? 'page' : 'editor',
    );
  }

  get cursor(): string {
    const { machine } = this.#host.workbench.editing;
    if (this.#pans || machine.tool === 'hand') return machine.busy ? 'grabbing' : 'grab';
    if (machine.draft) return machine.draft.finishing ? 'pointer' : 'crosshair';
    const places = machine.tool !== 'select';
    const under = this.#hovered && this.#shown ? this.#hit(this.#hovered, !places) : null;
    if (under?.part === 'ring') return TURN_CURSOR;
    if (under?.part === 'grip') return this.#scaleCursor;
    if (under) return machine.busy ? 'grabbing' : 'move';
    return places ? 'crosshair' : 'default';
  }

  get #scaleCursor(): string {
    const turn = groupTurn(selectedHandles(this.#host.workbench.editing.document));
    return `${SCALE_DIRECTIONS[Math.round(turn / 45) & 3]}-resize`;
  }

  /** Whether handles are visible and editable. */
  get #shown(): boolean {
    return this.#host.permissions.editable && this.#host.display.bare === null;
  }

  /** Whether a press moves the view, whatever the tool. */
  get #pans(): boolean {
    return !this.#host.permissions.playing && (!this.#shown || this.#space);
  }

  /** Space pressed or released: while it is held, presses pan. Returns whether it was handled. */
  space(held: boolean): boolean {
    if (this.#host.permissions.playing) return false;
    if (this.#space === held) return true;
    this.#space = held;
    this.#pointing.space = held;
    this.#host.looked();
    return true;
  }

  /** Repeats the last hover if the camera has moved under a resting pointer. */
  follow(): void {
    const pointer = this.#pointer;
    const { viewing, crosshair } = this.#host;
    if (pointer && pointer.camera !== viewing.camera && !crosshair.at) this.#hover(pointer.at);
  }

  release(): void {
    this.#pointing.release();
  }

  #press(pointer: StagePointer): Press {
    const at = toImage(this.#host.viewing.camera, pointer.stage);
    return { at, stage: pointer.stage, shift: pointer.shift, alt: pointer.alt };
  }

  #holds(pointer: StagePointer): boolean {
    const { areas } = this.#host;
    areas.coarse = pointer.coarse;
    return this.#shown && this.#hit(this.#press(pointer).at) !== null;
  }

  /** What of the handles is under a place; nothing while a lasso is in hand. */
  #hit(at: Vec, bodies = true, scene = this.#host.areas.scene): Hit | null {
    return this.#host.display.lassoing ? null : hit(scene, at, bodies);
  }

  #down(pointer: StagePointer, pans: boolean): void {
    const { workbench, areas, crosshair, focus, menu } = this.#host;
    areas.coarse = pointer.coarse;
    menu.close();
    focus.leaveField();
    crosshair.at = null;
    const once = pans || this.#pans ? hand : undefined;
    const press = this.#press(pointer);
    const { machine } = workbench.editing;
    this.#pressed = this.#hit(press.at, machine.tool === 'select', withoutRings(areas.scene)) !== null;
    this.#apply(machine.down(press, areas.scene, once));
  }

  #up(pointer: StagePointer): void {
    const { workbench, areas, focus } = this.#host;
    const { editing } = workbench;
    const press = this.#press(pointer);
    const drawing = editing.machine.draft !== null;
    const held = drawing ? null : this.#hit(press.at, editing.machine.tool === 'select');
    this.#apply(editing.machine.up(press, areas.scene));
    const { selection } = editing.document;
    // Focusing a handle selects it: not one that a Shift-click has just deselected.
    const keeps =
      held !== null && held.part !== 'ring' && held.part !== 'grip' && selection.includes(held.id);
    if (keeps && held.part === 'corner') focus.hold(held.id, held.index);
    else focus.hold(keeps ? held.id : selection[0]);
  }

  /** Select tool only: a double click of others ends a drawing. */
  #pressedTwice(pointer: StagePointer): void {
    const { workbench, lines } = this.#host;
    if (!this.#pans && workbench.editing.machine.tool === 'select') {
      lines.toggleCorner(this.#press(pointer).at);
    }
  }

  /** Opens the menu of what lies under a place, if there is one; not for a finger that places something there. */
  #menu(pointer: StagePointer, staying: boolean): boolean {
    const { workbench, permissions, areas, focus, menu } = this.#host;
    const { machine } = workbench.editing;
    if (!menu.opens) return false;
    areas.coarse = pointer.coarse;
    if (staying && places(machine.tool) && !this.#pressed) return false;
    this.#apply(machine.cancel());
    const { at } = this.#press(pointer);
    const under = this.#hit(at, machine.tool === 'select', withoutRings(areas.scene));
    if (permissions.playing && !under) return false;
    focus.leaveField();
    menu.open(under, at);
    return true;
  }

  #apply(effects: readonly Effect[]): void {
    this.#host.workbench.editing.apply(effects);
    this.#host.looked();
  }

  #look(camera: Camera): void {
    this.#host.viewing.look(camera);
    this.#host.looked();
  }

  #hover(pointer: StagePointer | null): void {
    const before = this.cursor;
    const press = pointer && this.#press(pointer);
    const { workbench, viewing, areas } = this.#host;
    const { machine } = workbench.editing;
    this.#hovered = press?.at ?? null;
    this.#pointer = pointer && { at: pointer, camera: viewing.camera };
    machine.hover(press, areas.scene);
    if (this.cursor !== before || machine.draft) this.#host.looked();
  }
}
