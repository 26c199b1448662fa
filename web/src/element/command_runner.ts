/** Runs the commands of buttons and keys, as far as the state of the editor allows. */
import { selectedHandles } from '../document/document';
import { parsePose, poseText } from '../document/pose_text';
import type { Vec } from '../geometry/vec';
import { draws, places, TOOLS, type ToolName } from '../tools/machine';
import { pressAt } from '../tools/state';
import { COMMANDS, type CommandName } from '../ui/commands';
import type { Crosshair } from './crosshair';
import type { Display } from './display';
import type { Files } from './files';
import type { Focus } from './focus';
import type { HitAreas } from './hit_areas';
import type { LineCommands } from './line_commands';
import type { Notices } from './notices';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import { handleWords } from './wording';
import type { Workbench } from './workbench';

export interface CommandRunnerHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly files: Files;
  readonly notices: Notices;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly crosshair: Crosshair;
  readonly lines: LineCommands;
  readonly focus: Focus;
  readonly areas: HitAreas;
  /** Copies the pose to the clipboard; pastes what is there. */
  copy(): void;
  paste(): void;
  /** Shows the list of keys, or hides it. */
  toggleKeys(): void;
  /** Camera, crosshair or drawing changed. */
  looked(): void;
}

export class CommandRunner {
  readonly #host: CommandRunnerHost;

  constructor(host: CommandRunnerHost) {
    this.#host = host;
  }

  /** @param at the place that a command of the context menu is for, image pixels. */
  run(command: CommandName, at?: Vec): void {
    if (!this.#host.permissions.disabled) this.#commands[command](at);
  }

  choose(tool: ToolName): void {
    const { workbench, permissions, display, focus } = this.#host;
    const { editing } = workbench;
    if (permissions.playing || (permissions.readonly && tool !== 'hand')) return;
    editing.apply(editing.machine.choose(tool));
    // Arrow keys move the crosshair of such a tool only while nothing is selected.
    if (draws(tool)) {
      editing.select([]);
      display.openSettings(false);
    }
    // With a placing tool Enter must reach the stage, not the focused handle.
    if (places(tool) && focus.isOnHandles) focus.hold(undefined);
    this.#hideCrosshair();
  }

  /**
   * Cancels or dismisses the innermost thing in progress.
   * @returns whether there was any: if not, Escape is left to the page, such as for a dialog.
   */
  bail(): boolean {
    const { workbench, notices, display, crosshair } = this.#host;
    const { editing } = workbench;
    const { notice } = notices;
    if (editing.machine.busy || editing.machine.draft) {
      editing.apply(editing.machine.bail());
      this.#host.looked();
    } else if (crosshair.at) this.#hideCrosshair();
    else if (display.settings) display.openSettings(false);
    else if (notice && !notice.action) notices.dismiss();
    else if (editing.document.selection.length > 0) editing.select([]);
    else if (notice) notices.dismiss();
    else return false;
    return true;
  }

  /** The pose of what is selected as text, or else that of all handles; null where there is none, or text is copied. */
  copied(): string | null {
    const { workbench, notices, permissions, focus } = this.#host;
    const { document } = workbench.editing;
    const selected = selectedHandles(document);
    const handles = selected.length > 0 ? selected : document.project.handles;
    if (!permissions.editable || focus.isOnText || handles.length === 0) return null;
    notices.say(`Copied the pose of ${handleWords(handles)}`);
    return poseText(handles);
  }

  /** Poses handles as a copied text says. Returns whether the text is a pose. */
  paste(text: string): boolean {
    const { workbench, notices, permissions, focus } = this.#host;
    if (!permissions.editable || focus.isInField) return false;
    try {
      const copied = parsePose(text);
      if (!copied) return false;
      const told = workbench.commands.paste(copied);
      if (told !== null) notices.notify({ kind: 'info', text: told, ofStep: true });
    } catch (error) {
      notices.notify({ kind: 'error', text: `This pose cannot be pasted: ${(error as Error).message}.` });
    }
    return true;
  }

  get #commands(): Readonly<Record<CommandName, (at?: Vec) => void>> {
    const { workbench, viewing, files, permissions, display, lines } = this.#host;
    const { editing, commands } = workbench;
    const { machine } = editing;
    const edit = (change: () => void) => permissions.editable && change();
    const look = (change: () => void) => {
      change();
      this.#host.looked();
    };
    // During a drawing, undo takes back its last corner.
    const drawing = () => machine.draft !== null;
    const back = () => editing.apply(machine.back());
    const again = () => editing.apply(machine.again());
    return {
      select: () => this.#take('select'),
      point: () => this.#take('point'),
      bar: () => this.#take('bar'),
      polygon: () => this.#take('polygon'),
      lasso: () => this.#take('lasso'),
      hand: () => this.#take('hand'),
      open: () => !permissions.readonly && void files.choose(),
      save: () => void files.save(),
      export: () => void files.export(),
      'export-all': () => void files.export(true),
      undo: () => edit(() => (drawing() ? look(back) : editing.undo())),
      redo: () => edit(() => (drawing() || machine.takenBack ? look(again) : editing.redo())),
      reset: () => edit(() => commands.reset(false)),
      'reset-all': () => edit(() => commands.reset(true)),
      mirror: () => edit(() => this.#mirror()),
      remove: () => edit(() => (drawing() ? look(back) : commands.remove())),
      copy: () => this.#host.copy(),
      paste: () => this.#host.paste(),
      'add-point': (at) => edit(() => at && this.#addPoint(at)),
      'add-corner': (at) => edit(() => lines.addCorner(at)),
      'remove-corner': () => edit(() => lines.removeCorner()),
      forward: () => edit(() => commands.raise(1)),
      backward: () => edit(() => commands.raise(-1)),
      settings: () => display.openSettings(!display.settings),
      'select-all': () => {
        const { handles } = editing.project;
        editing.select(handles.map(({ id }) => id));
        if (handles.length > 0) this.#host.notices.say(`Selected ${handleWords(handles)}`);
      },
      compare: () => display.toggleBare('compare'),
      preview: () => display.toggleBare('preview'),
      fit: () => look(() => viewing.fit()),
      actual: () => look(() => viewing.actual()),
      'zoom-in': () => look(() => viewing.zoom(1)),
      'zoom-out': () => look(() => viewing.zoom(-1)),
      keys: () => this.#host.toggleKeys(),
      bail: () => this.bail(),
    };
  }

  /** Adds a point handle with any tool. */
  #addPoint(at: Vec): void {
    const { workbench, areas, focus } = this.#host;
    const { editing } = workbench;
    const press = pressAt(at);
    editing.apply(editing.machine.down(press, areas.bareScene, TOOLS.point));
    editing.apply(editing.machine.up(press, areas.bareScene));
    focus.hold(editing.document.selection[0]);
  }

  /** Mirrors what is selected, and goes on to what was posed by that. */
  #mirror(): void {
    const { workbench, notices, focus } = this.#host;
    const { editing, commands } = workbench;
    const told = commands.mirror();
    if (told !== null) notices.notify({ kind: 'info', text: told, ofStep: true });
    // Keys act on what has the focus.
    if (focus.isOnHandles) focus.hold(editing.document.selection[0]);
  }

  /** Chooses a tool, and announces it if that was possible. */
  #take(tool: ToolName): void {
    this.choose(tool);
    if (this.#host.workbench.editing.machine.tool !== tool) return;
    this.#host.notices.say(COMMANDS[tool].label);
    // Arrows and Enter place with it.
    if (places(tool)) this.#host.focus.hold(undefined);
  }

  #hideCrosshair(): void {
    this.#host.crosshair.at = null;
    this.#host.looked();
  }
}
