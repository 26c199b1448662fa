/** All commands that a person can run by button, key or menu: one table for labels, keys, menus and ARIA hints. */
import type { ToolName } from '../tools/machine';

export interface Command {
  readonly label: string;
  /** Keys as people read them; `Mod` is Ctrl, and Cmd on a Mac. The first is shown. */
  readonly keys: readonly string[];
}

export const COMMANDS = {
  select: { label: 'Select and move', keys: ['V'] },
  point: { label: 'Add a point handle', keys: ['P'] },
  bar: { label: 'Draw a bar', keys: ['B'] },
  polygon: { label: 'Draw a polygon', keys: ['G'] },
  lasso: { label: 'Lasso: draw around the part that bends', keys: ['L'] },
  brush: { label: 'Brush', keys: ['F'] },
  'brush-erase': { label: 'The opposite brush, or the eraser', keys: ['E'] },
  'brush-smaller': { label: 'Smaller brush', keys: ['['] },
  'brush-larger': { label: 'Larger brush', keys: [']'] },
  hand: { label: 'Pan', keys: ['H'] },
  lens: { label: 'Look at the weights of a point', keys: ['I'] },
  timeline: { label: 'Animate: show the timeline', keys: ['T'] },
  play: { label: 'Play or stop', keys: ['K'] },
  'set-key': { label: 'Set a key', keys: ['S'] },
  open: { label: 'Open a picture or a project', keys: ['Mod+O'] },
  save: { label: 'Save the project file', keys: ['Mod+S'] },
  'save-whole': { label: 'Save the project with its picture', keys: ['Mod+Shift+S'] },
  export: { label: 'Export by the last choices', keys: ['Mod+E'] },
  'export-as': { label: 'Export as …', keys: ['Mod+Shift+E'] },
  'export-all': { label: 'Export all of it', keys: [] },
  'export-whole': { label: 'Export a PNG that opens again with its handles', keys: [] },
  undo: { label: 'Undo', keys: ['Mod+Z'] },
  redo: { label: 'Redo', keys: ['Mod+Shift+Z', 'Mod+Y'] },
  'reset-all': { label: 'Reset all handles', keys: [] },
  reset: { label: 'Reset', keys: ['R'] },
  mirror: { label: 'Mirror to the other side', keys: ['M'] },
  copy: { label: 'Copy the pose', keys: ['Mod+C'] },
  paste: { label: 'Paste a pose', keys: ['Mod+V'] },
  rename: { label: 'Rename', keys: ['F2'] },
  suggest: { label: 'Suggest handles', keys: ['N'] },
  'without-folds': { label: 'Nearest pose without folds', keys: ['U'] },
  remove: { label: 'Delete', keys: ['Delete', 'Backspace'] },
  'add-point': { label: 'Add a point here', keys: [] },
  'turn-part': { label: 'Turn this part, keep the rest', keys: [] },
  'add-corner': { label: 'Add a corner', keys: ['C'] },
  'remove-corner': { label: 'Delete the corner', keys: ['X'] },
  forward: { label: 'Bring forward', keys: [']'] },
  backward: { label: 'Send back', keys: ['['] },
  compare: { label: 'Hold to compare with the original', keys: ['O'] },
  preview: { label: 'Hold to see it without handles', keys: ['W'] },
  'select-all': { label: 'Select all handles', keys: ['Mod+A'] },
  fit: { label: 'Fit the picture', keys: ['0'] },
  actual: { label: 'Actual size', keys: ['1'] },
  'zoom-in': { label: 'Zoom in', keys: ['+', '='] },
  'zoom-out': { label: 'Zoom out', keys: ['-'] },
  settings: { label: 'How the picture bends', keys: [] },
  keys: { label: 'Keys', keys: ['?'] },
  bail: { label: 'Cancel', keys: ['Escape'] },
} as const satisfies Record<string, Command> & Record<ToolName, Command>;

export type CommandName = keyof typeof COMMANDS;

const PREVIEWS = ['compare', 'preview'] as const satisfies readonly CommandName[];

/** A command that shows the picture without handles and overlays while its key or button is held. */
export type PreviewCommand = (typeof PREVIEWS)[number];

export const isPreview = (command: CommandName): command is PreviewCommand =>
  (PREVIEWS as readonly CommandName[]).includes(command);

const NAMES = Object.keys(COMMANDS) as CommandName[];

/** The commands available where handles can only be posed. */
const WHILE_POSABLE: readonly CommandName[] = [
  'undo',
  'redo',
  'reset',
  'reset-all',
  'select-all',
  'compare',
  'preview',
  'bail',
];

/** The commands of the brush. Its keys for sizes, which paint programs share, are those of depths otherwise. */
const OF_BRUSH: readonly CommandName[] = ['brush-erase', 'brush-smaller', 'brush-larger'];
const OF_DEPTH: readonly CommandName[] = ['forward', 'backward'];

const WHILE_BRUSHING = NAMES.filter((name) => !OF_DEPTH.includes(name));
const OTHERWISE = NAMES.filter((name) => !OF_BRUSH.includes(name));

/** The available commands: none for a picture that plays and is readonly, because it acts as a plain image. */
export function commandsFor(posable: boolean, readonly: boolean, tool: ToolName): readonly CommandName[] {
  if (posable) return readonly ? [] : WHILE_POSABLE;
  return tool === 'brush' ? WHILE_BRUSHING : OTHERWISE;
}

/** Characters that some keyboards type only with Alt, or with Ctrl and Alt. */
const SIGNS = ['[', ']'];
const LETTER_PLACE = /^Key([A-Z])$/;

/**
 * The one of these commands that a key runs, or null. Shift counts only together with Mod, since "+" may need Shift to
 * be typed. A letter of another script counts as the Latin letter of the same key.
 */
export function commandOfKey(
  event: KeyPress,
  commands: readonly CommandName[] = OTHERWISE,
): CommandName | null {
  const types = event.altKey && SIGNS.includes(event.key);
  if (event.altKey && !types) return null;
  const mod = (event.ctrlKey || event.metaKey) && !types;
  const latin = event.key > '\x7f' ? LETTER_PLACE.exec(event.code)?.[1] : undefined;
  const key = latin ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const written = `${mod ? 'Mod+' : ''}${mod && event.shiftKey ? 'Shift+' : ''}${key}`;
  return commands.find((name) => (COMMANDS[name].keys as readonly string[]).includes(written)) ?? null;
}

/** The parts of a KeyboardEvent that count. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
  readonly shiftKey: boolean;
}

const MAC = /Mac|iPhone|iPad/;
const SYMBOLS: Readonly<Record<string, string>> = { Delete: 'Del', Escape: 'Esc', '-': '−' };

/** The key that is `Mod`. */
export const modifier = (platform: string): string => (MAC.test(platform) ? '⌘' : 'Ctrl');

/** The first key of a command as a tooltip shows it, or an empty text. */
export function keyHint(name: CommandName, platform: string): string {
  const key = COMMANDS[name].keys[0] ?? '';
  const mac = MAC.test(platform);
  return key
    .split('+')
    .filter((part) => part !== '')
    .map((part) => {
      if (part === 'Mod') return modifier(platform);
      if (part === 'Shift' && mac) return '⇧';
      return SYMBOLS[part] ?? part;
    })
    .join(mac ? '' : ' + ')
    .concat(key === '+' ? '+' : '');
}

/** The keys of a command for `aria-keyshortcuts`. */
export const ariaKeys = (name: CommandName, platform: string): string =>
  (COMMANDS[name].keys as readonly string[])
    .filter((key) => key !== '+')
    .map((key) => key.replace('Mod', MAC.test(platform) ? 'Meta' : 'Control'))
    .join(' ');
