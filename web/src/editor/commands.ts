/** All commands that a person can run by button, key or menu, with their keys. Their labels are in the texts. */
import type { Texts } from '../texts/texts';
import type { ToolName } from '../tools/machine';

/** The keys of each command as people read them; `Mod` is Ctrl, and Cmd on a Mac. The first is shown. */
export const COMMANDS = {
  select: ['V'],
  point: ['P'],
  bar: ['B'],
  polygon: ['G'],
  lasso: ['L'],
  brush: ['F'],
  'brush-erase': ['E'],
  'brush-smaller': ['['],
  'brush-larger': [']'],
  hand: ['H'],
  lens: ['I'],
  timeline: ['T'],
  play: ['K'],
  'set-key': ['S'],
  'copy-keys': ['Mod+C'],
  'cut-keys': ['Mod+X'],
  'paste-keys': ['Mod+V'],
  'mirror-keys': ['M'],
  'remove-keys': ['Delete', 'Backspace'],
  'select-all-keys': ['Mod+A'],
  open: ['Mod+O'],
  save: ['Mod+S'],
  'save-whole': ['Mod+Shift+S'],
  export: ['Mod+E'],
  'export-as': ['Mod+Shift+E'],
  'export-all': [],
  'export-whole': [],
  undo: ['Mod+Z'],
  redo: ['Mod+Shift+Z', 'Mod+Y'],
  'reset-all': [],
  reset: ['R'],
  mirror: ['M'],
  copy: ['Mod+C'],
  paste: ['Mod+V'],
  rename: ['F2'],
  suggest: ['N'],
  'without-folds': ['U'],
  remove: ['Delete', 'Backspace'],
  'add-point': [],
  'turn-part': [],
  'add-corner': ['C'],
  'remove-corner': ['X'],
  forward: [']'],
  backward: ['['],
  compare: ['O'],
  preview: ['W'],
  'select-all': ['Mod+A'],
  fit: ['0'],
  actual: ['1'],
  'zoom-in': ['+', '='],
  'zoom-out': ['-'],
  settings: [],
  keys: ['?'],
  bail: ['Escape'],
} as const satisfies Record<string, readonly string[]> & Record<ToolName, readonly string[]>;

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

/** The commands of the selected keys of a clip. They share the keys of the keyboard with those of handles. */
const OF_KEYS: readonly CommandName[] = [
  'copy-keys',
  'cut-keys',
  'paste-keys',
  'mirror-keys',
  'remove-keys',
  'select-all-keys',
];
const OF_HANDLES: readonly CommandName[] = ['copy', 'paste', 'mirror', 'remove', 'select-all'];

const commandsWithout = (...others: readonly (readonly CommandName[])[]): readonly CommandName[] =>
  NAMES.filter((name) => !others.flat().includes(name));

const USUAL = commandsWithout(OF_BRUSH, OF_KEYS);
const WITH_KEYS = commandsWithout(OF_BRUSH, OF_HANDLES);
const WHILE_BRUSHING = commandsWithout(OF_DEPTH, OF_KEYS);
const WHILE_BRUSHING_WITH_KEYS = commandsWithout(OF_DEPTH, OF_HANDLES);

/**
 * The available commands: none for a picture that plays and is readonly, because it acts as a plain image.
 *
 * @param keys whether keyboard commands apply to keys of a clip.
 */
export function commandsFor(
  posable: boolean,
  readonly: boolean,
  tool: ToolName,
  keys: boolean,
): readonly CommandName[] {
  if (posable) return readonly ? [] : WHILE_POSABLE;
  if (tool === 'brush') return keys ? WHILE_BRUSHING_WITH_KEYS : WHILE_BRUSHING;
  return keys ? WITH_KEYS : USUAL;
}

/** Characters that some keyboards type only with Alt, or with Ctrl and Alt. */
const SIGNS = ['[', ']'];
const LETTER_PLACE = /^Key([A-Z])$/;

/**
 * The one of these commands that a key runs, or null. Shift counts only together with Mod, since "+" may need Shift to
 * be typed. A letter of another script counts as the Latin letter of the same key.
 */
export function commandOfKey(event: KeyPress, commands: readonly CommandName[] = USUAL): CommandName | null {
  const types = event.altKey && SIGNS.includes(event.key);
  if (event.altKey && !types) return null;
  const mod = (event.ctrlKey || event.metaKey) && !types;
  const latin = event.key > '\x7f' ? LETTER_PLACE.exec(event.code)?.[1] : undefined;
  const key = latin ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const written = `${mod ? 'Mod+' : ''}${mod && event.shiftKey ? 'Shift+' : ''}${key}`;
  return commands.find((name) => (COMMANDS[name] as readonly string[]).includes(written)) ?? null;
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

/** The key that is `Mod`. */
export const modifier = (platform: string, { keys }: Texts): string =>
  MAC.test(platform) ? '⌘' : keys.names.ctrl;

/** A key as people read it. */
function keyName(key: string, platform: string, texts: Texts): string {
  const { names } = texts.keys;
  if (key === 'Mod') return modifier(platform, texts);
  if (key === 'Shift') return MAC.test(platform) ? '⇧' : names.shift;
  return { Delete: names.delete, Escape: names.escape, '-': '−' }[key] ?? key;
}

/** The first key of a command as a tooltip shows it, or an empty text. */
export function keyHint(name: CommandName, platform: string, texts: Texts): string {
  const key: string = COMMANDS[name][0] ?? '';
  return key
    .split('+')
    .filter((part) => part !== '')
    .map((part) => keyName(part, platform, texts))
    .join(MAC.test(platform) ? '' : ' + ')
    .concat(key === '+' ? '+' : '');
}

/** The keys of a command for `aria-keyshortcuts`. */
export const ariaKeys = (name: CommandName, platform: string): string =>
  (COMMANDS[name] as readonly string[])
    .filter((key) => key !== '+')
    .map((key) => key.replace('Mod', MAC.test(platform) ? 'Meta' : 'Control'))
    .join(' ');
