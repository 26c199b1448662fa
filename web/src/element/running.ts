/** Runs commands, as far as the state of the editor allows. */
import type { ToolName } from '../tools/machine';
import { COMMANDS, type CommandName } from '../ui/commands';
import type { EditCommands } from './edit_commands';
import type { Editing } from './editing';
import type { Files } from './files';
import type { Viewing } from './viewing';

export interface RunningHost {
  readonly editing: Editing;
  readonly commands: EditCommands;
  readonly viewing: Viewing;
  readonly files: Files;
  readonly readonly: boolean;
  readonly editable: boolean;
  choose(tool: ToolName): void;
  /** Switches the comparison with the original on or off. */
  flip(): void;
  bail(): void;
  say(text: string): void;
  addCorner(): void;
  removeCorner(): void;
  /** Opens or closes the settings of the whole picture, in layouts without room to show them always. */
  settings(): void;
  looked(): void;
}

export function run(command: CommandName, host: RunningHost): void {
  const { editing, commands, viewing, files } = host;
  const edit = (change: () => void) => host.editable && change();
  const look = (change: () => void) => {
    change();
    host.looked();
  };
  const take = (tool: ToolName) => {
    host.choose(tool);
    if (editing.machine.tool === tool) host.say(COMMANDS[tool].label);
  };
  // During a drawing, undo takes back its last corner.
  const drawing = () => editing.machine.draft !== null;
  const back = () => editing.apply(editing.machine.back());
  const again = () => editing.apply(editing.machine.again());
  const running: Readonly<Record<CommandName, () => void>> = {
    select: () => take('select'),
    point: () => take('point'),
    bar: () => take('bar'),
    polygon: () => take('polygon'),
    hand: () => take('hand'),
    open: () => !host.readonly && void files.choose(),
    save: () => void files.save(),
    export: () => void files.export(),
    undo: () => edit(() => (drawing() ? look(back) : editing.undo())),
    redo: () => edit(() => (drawing() || editing.machine.takenBack ? look(again) : editing.redo())),
    reset: () => edit(() => commands.reset(false)),
    'reset-all': () => edit(() => commands.reset(true)),
    remove: () => edit(() => (drawing() ? look(back) : commands.remove())),
    'add-corner': () => edit(() => host.addCorner()),
    'remove-corner': () => edit(() => host.removeCorner()),
    forward: () => edit(() => commands.raise(1)),
    backward: () => edit(() => commands.raise(-1)),
    settings: () => host.settings(),
    'select-all': () => {
      const ids = editing.project.handles.map((handle) => handle.id);
      editing.select(ids);
      host.say(`${ids.length} handles selected`);
    },
    compare: () => host.flip(),
    fit: () => look(() => viewing.fit()),
    actual: () => look(() => viewing.actual()),
    'zoom-in': () => look(() => viewing.zoom(1)),
    'zoom-out': () => look(() => viewing.zoom(-1)),
    bail: () => host.bail(),
  };
  running[command]();
}
