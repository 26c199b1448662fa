/** What keys do on the stage: arrows nudge, move the crosshair or pan, comma and full stop turn or scale, Enter places. */
import { handleById } from '../document/document';
import { anchor, isLine } from '../document/handle';
import { panned } from '../geometry/camera';
import { scaled, type Vec } from '../geometry/vec';
import { places } from '../tools/machine';
import { pressAt } from '../tools/state';
import type { ContextMenu } from './context_menu';
import type { Crosshair } from './crosshair';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import type { LineCommands } from './line_commands';
import type { Notices } from './notices';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

export interface StageKeysHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly permissions: Permissions;
  readonly areas: HitAreas;
  readonly crosshair: Crosshair;
  readonly lines: LineCommands;
  readonly focus: Focus;
  readonly menu: ContextMenu;
  readonly notices: Notices;
  /** Camera, crosshair or drawing changed. */
  looked(): void;
}

/** CSS pixels that an arrow key moves the picture for each pixel that it would nudge. */
const PAN = 40;

/** Each method returns whether the key was handled: if not, it is left to the page. */
export class StageKeys {
  readonly #host: StageKeysHost;

  constructor(host: StageKeysHost) {
    this.#host = host;
  }

  /**
   * Nudges the focused corner, else the selected handles; else moves a placing tool's crosshair, or the picture.
   * @param by one step or, with Shift, ten.
   */
  arrow(by: Vec): boolean {
    const { workbench, viewing, permissions, focus } = this.#host;
    const { editing, commands } = workbench;
    const { editable } = permissions;
    const { draft } = editing.machine;
    const { corner } = focus;
    if (editable && corner && !draft) commands.nudgeCorner(corner, by);
    else if (editable && editing.document.selection.length > 0 && !draft) commands.nudge(by);
    else if (editable && this.#places) this.#moveCrosshair(by);
    else if (permissions.playing) return false;
    else {
      viewing.look(panned(viewing.camera, scaled(by, -PAN)));
      this.#host.looked();
    }
    return true;
  }

  turn(degrees: number, scale?: number): boolean {
    const { workbench, permissions } = this.#host;
    if (!permissions.editable || workbench.editing.document.selection.length === 0) return false;
    workbench.commands.turn(degrees, scale);
    return true;
  }

  /** Places a handle or sets a corner at the crosshair; without a crosshair, finishes the current drawing. */
  place(): boolean {
    const { workbench, permissions, areas, crosshair, lines, focus } = this.#host;
    const { editing } = workbench;
    const { machine } = editing;
    if (!permissions.editable || !this.#places) return false;
    // A pointer press is in progress: ignore the key.
    if (machine.busy) return true;
    if (machine.draft && !crosshair.at) {
      lines.finish();
      return true;
    }
    const press = pressAt(crosshair.place);
    editing.apply(machine.down(press, areas.bareScene));
    editing.apply(machine.up(press, areas.bareScene));
    this.#host.looked();
    crosshair.at = null;
    const [added] = editing.document.selection;
    if (added && handleById(editing.document, added)) focus.hold(added);
    return true;
  }

  /** Opens the menu of the handle or corner that has the focus, or of the picture. */
  menu(): boolean {
    const { workbench, viewing, permissions, crosshair, focus, menu } = this.#host;
    const { held } = focus;
    // A pointer press is in progress: ignore the key.
    if (workbench.editing.machine.busy) return true;
    if (!menu.opens || (permissions.playing && !held)) return false;
    const handle = held && handleById(workbench.editing.document, held.id);
    const corner = handle && isLine(handle) && held?.part === 'corner' ? handle.posed[held.index] : undefined;
    const at = corner ?? (handle ? anchor(handle) : crosshair.place);
    if (!permissions.playing) viewing.reveal(at);
    this.#host.looked();
    menu.open(held, at);
    return true;
  }

  #moveCrosshair(by: Vec): void {
    const { workbench, areas, crosshair } = this.#host;
    const { machine } = workbench.editing;
    const at = crosshair.move(by, machine.draft?.corners.at(-1));
    machine.hover(pressAt(at), areas.scene);
    this.#host.notices.say(`x ${Math.round(at[0])}, y ${Math.round(at[1])}`);
    this.#host.looked();
  }

  /** Whether the current tool places something on the picture. */
  get #places(): boolean {
    return places(this.#host.workbench.editing.machine.tool);
  }
}
