/** The editor's icons: drawn on a grid of 20, in strokes of 1.5, coloured by the text around them. */

import { html, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import type { CommandName } from '../editor/commands';

const SHAPES = {
  select: svg`<path d="M5 3.2 15.4 9.6 10.6 10.9 13.4 16.2 11.2 17.3 8.5 12 5 15.4Z"/>`,
  point: svg`<circle cx="8.5" cy="11.5" r="4.6"/><circle cx="8.5" cy="11.5" r="1" fill="currentColor"/><path d="M15.5 2.6v5M13 5.1h5"/>`,
  bar: svg`<circle cx="4.6" cy="15.4" r="2.1"/><circle cx="15.4" cy="4.6" r="2.1"/><path d="m6.2 13.8 7.6-7.6"/>`,
  polygon: svg`<path d="M10 3.4 16.8 8.4 14.2 16.4H5.8L3.2 8.4Z"/><path d="M10 3.4 16.8 8.4 14.2 16.4H5.8L3.2 8.4Z" fill="currentColor" stroke="none" opacity=".22"/>`,
  lasso: svg`<path d="M6.3 12.6C4.3 11.7 3 10.3 3 8.6c0-2.9 3.2-5 7.2-5s6.8 2.1 6.8 4.9-3 4.9-6.9 4.9c-.8 0-1.5-.1-2.2-.2" stroke-dasharray="2.6 1.9"/><circle cx="6.9" cy="13.2" r="1.5"/><path d="M6.1 14.5c-.5 1.1-.4 2.3.9 2.6"/>`,
  brush: svg`<path d="M16.8 3.2c-.9-.9-2-.5-2.7.2L8.6 9.9l1.9 1.9 6.1-5.9c.8-.7 1.1-1.8.2-2.7Z"/><path d="M8.6 9.9c-2-.1-3.4 1-3.7 2.8-.2 1.3-.8 2.2-1.9 2.8 3.4 1.9 7.4.4 7.5-3.7" fill="currentColor" fill-opacity=".32"/>`,
  push: svg`<path d="M3.4 10h9.4M9.4 6.4 13 10l-3.6 3.6"/><path d="M15.2 4.2c1.6 3.6 1.6 8 0 11.6" opacity=".5"/>`,
  pinch: svg`<path d="M3.4 3.4 8 8M8 4.8V8H4.8M16.6 3.4 12 8M12 4.8V8h3.2M3.4 16.6 8 12M8 15.2V12H4.8M16.6 16.6 12 12M12 15.2V12h3.2"/>`,
  bloat: svg`<path d="M8 8 3.4 3.4M6.8 3.4H3.4v3.4M12 8l4.6-4.6M13.2 3.4h3.4v3.4M8 12l-4.6 4.6M6.8 16.6H3.4v-3.4M12 12l4.6 4.6M13.2 16.6h3.4v-3.4"/>`,
  smooth: svg`<path d="M2.8 8.2c1.6-3.4 3.2-3.4 4.8 0s3.2 3.4 4.8 0 3.2-3.4 4.8 0" opacity=".5"/><path d="M2.8 14.4c4.8-1.4 9.6-1.4 14.4 0"/>`,
  stiffen: svg`<path d="m10 3 6 3.5v7L10 17l-6-3.5v-7Z" fill="currentColor" fill-opacity=".22"/><path d="m4 6.5 6 3.5 6-3.5M10 10v7"/>`,
  eraser: svg`<path d="m8 16.4-4-4a1 1 0 0 1 0-1.4l6.6-6.6a1 1 0 0 1 1.4 0l3.8 3.8a1 1 0 0 1 0 1.4l-6.8 6.8ZM7.4 7.6l5.2 5.2M8 16.4h8.6"/>`,
  lens: svg`<circle cx="8.8" cy="8.8" r="5.4"/><path d="m12.8 12.8 4 4M6.6 10.8V9.4M8.8 10.8V6.8M11 10.8V8.2"/>`,
  play: svg`<path d="M6.5 4.2 15.5 10l-9 5.8Z"/>`,
  pause: svg`<path d="M7 4.5v11M13 4.5v11"/>`,
  timeline: svg`<path d="M3 5.5h14M3 14.5h14" opacity=".45"/><path d="M10 2.6v14.8"/><path d="m6 12.4 2.1 2.1L6 16.6l-2.1-2.1ZM14 3.4l2.1 2.1L14 7.6l-2.1-2.1Z" fill="currentColor" stroke="none"/>`,
  'set-key': svg`<path d="m8.5 7 4.5 4.5L8.5 16 4 11.5Z"/><path d="M15.5 2.6v5M13 5.1h5"/>`,
  record: svg`<circle cx="10" cy="10" r="5.2" fill="currentColor" stroke="none"/>`,
  onion: svg`<circle cx="8" cy="10" r="4.6"/><circle cx="12.4" cy="10" r="4.6" opacity=".45"/>`,
  back: svg`<path d="m12 4.5-5.5 5.5 5.5 5.5"/>`,
  next: svg`<path d="m8 4.5 5.5 5.5L8 15.5"/>`,
  forward: svg`<path d="M8 3.5h7.5c.6 0 1 .4 1 1V12" opacity=".45"/><rect x="3.5" y="6.5" width="10" height="10" rx="1.2" fill="currentColor" fill-opacity=".32"/>`,
  backward: svg`<path d="M12 16.5H4.5c-.6 0-1-.4-1-1V8"/><rect x="6.5" y="3.5" width="10" height="10" rx="1.2" opacity=".45"/>`,
  settings: svg`<path d="M3.2 6h6.3M14.3 6h2.5M3.2 14h2.5M10.5 14h6.3"/><circle cx="11.9" cy="6" r="2.2"/><circle cx="8.1" cy="14" r="2.2"/>`,
  fold: svg`<path d="M3.4 15.6 8.2 5.2l3.4 7.2 5-2.6"/><path d="M8.2 5.2 3.4 15.6h6.9l1.3-3.2Z" fill="currentColor" stroke="none" opacity=".28"/><path d="M3.4 15.6h9.8"/>`,
  unfold: svg`<path d="m5.5 8 4.5 4.5L14.5 8"/>`,
  suggest: svg`<path d="M10 7.2v5.2M6 15.6l4-3.2 4 3.2M5 6.6l5 2.2 5-2.2" opacity=".5"/><g fill="currentColor" stroke="none"><circle cx="10" cy="4.6" r="2.1"/><circle cx="4.2" cy="6.4" r="1.7"/><circle cx="15.8" cy="6.4" r="1.7"/><circle cx="5.4" cy="16.2" r="1.7"/><circle cx="14.6" cy="16.2" r="1.7"/></g>`,
  'without-folds': svg`<path d="M3 14.6 8 6.4h9l-5 8.2Z"/><path d="M3 14.6 8 6.4h9l-5 8.2Z" fill="currentColor" stroke="none" opacity=".22"/><path d="m8.2 10.6 1.6 1.6 3-3.4"/>`,
  done: svg`<path d="m4 10.6 4 4 8-9"/>`,
  hand: svg`<path d="M6.4 10.8V5.3a1.2 1.2 0 0 1 2.4 0V9m0-4.9a1.2 1.2 0 0 1 2.4 0V9m0-3.9a1.2 1.2 0 0 1 2.4 0v4.6m0-2.6a1.2 1.2 0 0 1 2.4 0v4.6c0 3.1-2 5.5-5 5.5-2.4 0-3.6-1-4.7-2.8L3.3 10.8a1.3 1.3 0 0 1 2.1-1.4l1.8 2.2"/>`,
  open: svg`<path d="M3 15.5V5.2c0-.6.4-1 1-1h3.6l1.9 2h5.7c.6 0 1 .4 1 1v1.3M3 15.5l2.2-6.4c.1-.4.5-.6.9-.6h10.7c.6 0 1 .6.8 1.1l-2 5.7c-.2.5-.5.7-1 .7H3.6a.6.6 0 0 1-.6-.5Z"/>`,
  save: svg`<path d="M4.5 3.5h8.4l3.6 3.6v8.4c0 .6-.4 1-1 1h-11c-.6 0-1-.4-1-1v-11c0-.6.4-1 1-1Z"/><path d="M6.8 3.6v3.9h5.6V3.6M6.4 16.4v-5h7.2v5"/>`,
  export: svg`<path d="M10 12.4V3.2M6.7 6.3 10 3l3.3 3.3M3.5 12v3.4c0 .6.5 1.1 1.1 1.1h10.8c.6 0 1.1-.5 1.1-1.1V12"/>`,
  undo: svg`<path d="M7.2 4 3.6 7.6l3.6 3.6M4 7.6h7.6a4.6 4.6 0 0 1 0 9.2H8"/>`,
  redo: svg`<path d="m12.8 4 3.6 3.6-3.6 3.6M16 7.6H8.4a4.6 4.6 0 0 0 0 9.2H12"/>`,
  reset: svg`<path d="M4.1 8.1A6.4 6.4 0 1 1 3.6 11M3.6 4.3v3.9h3.9"/>`,
  mirror: svg`<path d="M10 2.9v14.2" stroke-dasharray="2.4 2.3"/><path d="M7 5.4v9.2H2.9Z" opacity=".45"/><path d="M13 5.4v9.2h4.1Z" fill="currentColor" fill-opacity=".32"/>`,
  copy: svg`<rect x="7" y="7" width="9.6" height="9.6" rx="1.2"/><path d="M4.6 13H4.4c-.6 0-1-.4-1-1V4.4c0-.6.4-1 1-1H12c.6 0 1 .4 1 1v.2"/>`,
  paste: svg`<path d="M7 4.4H5.4c-.6 0-1 .4-1 1v10.2c0 .6.4 1 1 1h9.2c.6 0 1-.4 1-1V5.4c0-.6-.4-1-1-1H13"/><rect x="7" y="2.9" width="6" height="3.2" rx="1"/>`,
  remove: svg`<path d="M3.8 5.6h12.4M8 5.4V4c0-.5.4-.9.9-.9h2.2c.5 0 .9.4.9.9v1.4M5.4 5.8l.7 9.9c0 .6.5 1 1.1 1h5.6c.6 0 1.1-.4 1.1-1l.7-9.9M8.4 8.8v5M11.6 8.8v5"/>`,
  'add-corner': svg`<path d="M3.2 16.4 8.6 8.6l8.2 3.6"/><circle cx="8.6" cy="8.6" r="1.9" fill="currentColor" stroke="none"/><path d="M14.6 2.6v5M12.1 5.1h5"/>`,
  'remove-corner': svg`<path d="M3.2 16.4 8.6 8.6l8.2 3.6"/><circle cx="8.6" cy="8.6" r="1.9" fill="currentColor" stroke="none"/><path d="M12.1 5.1h5"/>`,
  compare: svg`<rect x="3" y="4.2" width="14" height="11.6" rx="1.2"/><path d="M10 2.6v14.8"/><path d="M10 5v10h6V5Z" fill="currentColor" stroke="none" opacity=".32"/>`,
  preview: svg`<path d="M2.4 10S5 4.9 10 4.9 17.6 10 17.6 10 15 15.1 10 15.1 2.4 10 2.4 10Z"/><circle cx="10" cy="10" r="2.3"/>`,
  overlays: svg`<path d="M10 3.2 17 7l-7 3.8L3 7ZM3.4 10.3 10 13.9l6.6-3.6M3.4 13.4 10 17l6.6-3.6"/>`,
  fit: svg`<path d="M3.4 7V4.4c0-.6.4-1 1-1H7M13 3.4h2.6c.6 0 1 .4 1 1V7M16.6 13v2.6c0 .6-.4 1-1 1H13M7 16.6H4.4c-.6 0-1-.4-1-1V13"/>`,
  actual: svg`<path d="m3 6.2 2.4-1.7v11M13 6.2l2.4-1.7v11M9.9 7.6v.1M9.9 12.4v.1" stroke-width="1.9"/>`,
  plus: svg`<path d="M10 4.5v11M4.5 10h11"/>`,
  minus: svg`<path d="M4.5 10h11"/>`,
  close: svg`<path d="m5 5 10 10M15 5 5 15"/>`,
  keys: svg`<rect x="2.6" y="5.2" width="14.8" height="9.6" rx="1.4"/><path d="M5.6 8.2h.1M8.5 8.2h.1M11.4 8.2h.1M14.3 8.2h.1M7 11.8h6"/>`,
  light: svg`<circle cx="10" cy="10" r="3.2"/><path d="M10 2.6v1.6M10 15.8v1.6M2.6 10h1.6M15.8 10h1.6M4.8 4.8l1.1 1.1M14.1 14.1l1.1 1.1M15.2 4.8l-1.1 1.1M5.9 14.1l-1.1 1.1"/>`,
  dark: svg`<path d="M16.2 12A6.8 6.8 0 0 1 8 3.8a6.8 6.8 0 1 0 8.2 8.2Z"/>`,
  magnifier: svg`<circle cx="8.6" cy="8.6" r="5.2"/><path d="m12.5 12.5 4.3 4.3"/>`,
  more: svg`<path d="M4.5 10h.1M10 10h.1M15.5 10h.1" stroke-width="2.6"/>`,
  rename: svg`<path d="m12.6 4.4 3 3L7 16H4v-3ZM11 6l3 3"/>`,
  lock: svg`<rect x="5" y="9" width="10" height="7.4" rx="1.4"/><path d="M7.2 9V6.6a2.8 2.8 0 0 1 5.6 0V9"/>`,
} as const satisfies Record<string, SVGTemplateResult>;

export type IconName = keyof typeof SHAPES;

export const icon = (name: IconName): TemplateResult => html`<svg
  class="icon"
  viewBox="0 0 20 20"
  aria-hidden="true"
  fill="none"
  stroke="currentColor"
  stroke-width="1.5"
  stroke-linecap="round"
  stroke-linejoin="round"
>${SHAPES[name]}</svg>`;

/** Icons of commands whose name no icon has. */
const COMMAND_ICONS = {
  'export-all': 'export',
  'export-whole': 'export',
  'save-whole': 'save',
  'export-as': 'export',
  'reset-all': 'reset',
  'add-point': 'point',
  'turn-part': 'polygon',
  'select-all': 'select',
  'copy-keys': 'copy',
  'cut-keys': 'copy',
  'paste-keys': 'paste',
  'mirror-keys': 'mirror',
  'remove-keys': 'remove',
  'select-all-keys': 'select',
  'zoom-in': 'plus',
  'zoom-out': 'minus',
  'brush-erase': 'brush',
  'brush-smaller': 'minus',
  'brush-larger': 'plus',
  bail: 'close',
} as const satisfies Partial<Record<CommandName, IconName>>;

type OwnIcon = keyof typeof COMMAND_ICONS;

const hasOtherIcon = (command: CommandName): command is OwnIcon => command in COMMAND_ICONS;

export const iconOf = (command: CommandName): IconName =>
  hasOtherIcon(command) ? COMMAND_ICONS[command] : (command as Exclude<CommandName, OwnIcon>);
