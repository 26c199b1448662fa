/** What the controls of the templates do. */
import { domainOf } from '../document/domain';
import { alphaThreshold } from '../io/alpha';
import type { EditorActions } from '../ui/model';
import type { Autosave } from './autosave';
import type { CommandRunner } from './command_runner';
import type { ContextMenu } from './context_menu';
import type { Display } from './display';
import type { EditCommands } from './edit_commands';
import type { Focus } from './focus';
import type { LineCommands } from './line_commands';
import type { Notices } from './notices';
import type { Permissions } from './permissions';
import type { Viewing } from './viewing';
import type { Workbench } from './workbench';

export interface ActionsHost {
  readonly workbench: Workbench;
  readonly viewing: Viewing;
  readonly notices: Notices;
  readonly permissions: Permissions;
  readonly display: Display;
  readonly commands: CommandRunner;
  readonly menu: ContextMenu;
  readonly lines: LineCommands;
  readonly focus: Focus;
  readonly autosave: Autosave;
  changed(): void;
  /** The camera has moved. */
  looked(): void;
  switchTheme(): void;
}

export function actionsOf(host: ActionsHost): EditorActions {
  const { workbench, viewing, notices, permissions, display, commands, lines, focus, autosave } = host;
  const { editing, guarding } = workbench;
  /** Applies an edit, or renders the control's old value again if editing is no longer allowed. */
  const edit = (change: (edits: EditCommands) => void) => {
    if (permissions.editable) change(workbench.commands);
    else host.changed();
  };
  return {
    run: (command) => commands.run(command),
    ofMenu: (command) => host.menu.run(command),
    showBare: (view) => display.showBare(view),
    overlay: (name, on) => display.overlay(name, on),
    field: (field, value) => edit((edits) => edits.field(field, value)),
    corner: (axis, value) => edit((edits) => focus.corner && edits.corner(focus.corner, axis, value)),
    automatic: (on) => edit((edits) => edits.automatic(on)),
    bend: (mode) => edit((edits) => edits.bend(mode)),
    detail: (detail) => edit((edits) => edits.detail(detail)),
    blend: (blend) => edit((edits) => edits.blend(blend)),
    unlasso: () =>
      edit((edits) => workbench.picture && edits.unlasso(domainOf(alphaThreshold(workbench.picture)))),
    holdBoundary: (held) => edit((edits) => edits.holdBoundary(held)),
    guard: (on) => {
      guarding.on = on;
      autosave.save();
      host.changed();
    },
    pixelate: (on) => {
      workbench.pixelated = on;
      autosave.save();
      host.looked();
    },
    finish: () => lines.finish(),
    back: () => editing.apply(editing.machine.back()),
    settings: (on) => display.openSettings(on),
    numbers: (on) => display.openNumbers(on),
    select: (ids) => editing.select(ids),
    toggle: (id) => editing.toggle(id),
    hold: (id) => focus.hold(id),
    focused: (corner) => {
      focus.corner = corner;
    },
    refuse: (text) => notices.notify({ kind: 'info', text }),
    reveal: (at) => {
      if (permissions.playing) viewing.contain([at]);
      else viewing.reveal(at);
      host.looked();
    },
    dismiss: () => notices.dismiss(),
    linger: (on) => notices.linger(on),
    theme: () => host.switchTheme(),
  };
}
