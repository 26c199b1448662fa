/**
 * The context menu: what it is about, and the focus, which goes back to where it was. It closes where anything else is
 * pressed or scrolled; a press on the stage does no more than that.
 */
import { toStage } from '../geometry/camera';
import type { Vec } from '../geometry/vec';
import type { Hit } from '../tools/hit';
import { stageToClient } from '../ui/client';
import type { CommandName } from '../ui/commands';
import { showMenu } from '../ui/context_menu';
import type { Menu } from '../ui/model';
import type { CommandRunner } from './command_runner';
import type { Display } from './display';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import { selectionName } from './wording';
import type { Workbench } from './workbench';

export interface ContextMenuHost {
  readonly root: ShadowRoot;
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly areas: HitAreas;
  readonly focus: Focus;
  readonly commands: CommandRunner;
  changed(): void;
}

/** Between a place and the menu, CSS pixels: a finger covers the place, keys are about a handle that is to be seen. */
const GAP = { mouse: 2, other: 16 } as const;

export class ContextMenu {
  readonly #host: ContextMenuHost;
  #shown: Menu | null = null;
  /** What was selected when it opened. */
  #about: readonly string[] = [];
  /** What had the focus before. */
  #before: Element | null = null;
  #listening = new AbortController();

  constructor(host: ContextMenuHost) {
    this.#host = host;
  }

  get shown(): Menu | null {
    return this.#shown;
  }

  /** Opens it at a place, image pixels, about what lies under that: selects it unless it is selected. */
  open(under: Hit | null, at: Vec): void {
    const { workbench, areas, focus, changed } = this.#host;
    const { editing } = workbench;
    this.close();
    if (under && !editing.document.selection.includes(under.id)) editing.select([under.id]);
    // Of several the menu is about all: a corner then stands for its handle.
    const alone = editing.document.selection.length === 1;
    const corner = alone && under?.part === 'corner' ? { id: under.id, index: under.index } : null;
    if (under) focus.hold(under.id, corner?.index);
    else if (!focus.isOnStage) focus.hold(undefined);
    const name = under ? selectionName(editing.document) : 'Picture';
    this.#shown = {
      about: under ? 'handles' : 'picture',
      name: corner ? `Corner ${corner.index + 1} of ${name}` : name,
      corner,
      at,
      bends: areas.scene.place(at) !== null,
    };
    this.#about = editing.document.selection;
    changed();
    queueMicrotask(() => this.#show(at));
  }

  /** The document has changed: closes it where what it is about is no more what is selected. */
  follow(): void {
    const { selection } = this.#host.workbench.editing.document;
    if (selection.join('\n') !== this.#about.join('\n')) this.close();
  }

  /** Closes it. The focus goes back to where it was. */
  close(): void {
    if (!this.#shown) return;
    const { root, changed } = this.#host;
    this.#listening.abort();
    this.#shown = null;
    const before = this.#before?.isConnected ? this.#before : root.querySelector('.stage');
    if (this.#menu?.contains(root.activeElement)) (before as HTMLElement).focus({ preventScroll: true });
    changed();
  }

  /** Closes it and runs one of its commands, or none. */
  run(command: CommandName | null): void {
    const at = this.#shown?.at;
    this.close();
    if (command) this.#host.commands.run(command, at);
  }

  /** Whether there is one now: not while something is being drawn, the picture is shown otherwise, or nothing can be changed. */
  get opens(): boolean {
    const { workbench, permissions, display } = this.#host;
    const { machine } = workbench.editing;
    const drawing = machine.drawings.some(({ kind }) => kind === machine.tool);
    return permissions.editable && display.bare === null && !display.lassoing && !drawing;
  }

  #show(at: Vec): void {
    const { root, viewing, areas } = this.#host;
    const menu = this.#menu;
    const stage = root.querySelector('.stage');
    if (!menu || !stage) return;
    this.#before = root.activeElement;
    const keyed = root.host.classList.contains('keyed');
    const gap = keyed || areas.coarse ? GAP.other : GAP.mouse;
    showMenu(menu, stageToClient(stage, toStage(viewing.camera, at)), gap, keyed);
    this.#listen();
  }

  #listen(): void {
    const { root } = this.#host;
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    const { ownerDocument } = root;
    const view = ownerDocument.defaultView;
    const close = () => this.close();
    /** The last press in the editor: beyond it, what a press is on cannot always be seen. */
    let inside: Event | null = null;
    const pressed = (event: Event) => {
      inside = event;
      const target = event.target as Element;
      if (target.closest('.context')) return;
      close();
      if (target.closest('.stage')) event.preventDefault();
    };
    const scrolled = (event: Event) => {
      if (!(event.target as Element).closest('.context')) close();
    };
    root.addEventListener('pointerdown', pressed, { signal, capture: true });
    root.addEventListener('wheel', scrolled, { signal, capture: true, passive: true });
    view?.addEventListener('pointerdown', (event) => event !== inside && close(), { signal });
    ownerDocument.addEventListener('scroll', close, { signal, capture: true, passive: true });
    view?.addEventListener('resize', close, { signal });
    view?.addEventListener('blur', close, { signal });
  }

  get #menu(): HTMLElement | null {
    return this.#host.root.querySelector('.context');
  }
}
