/** Cursors of the stage in CSS. */
import type { Cursor } from '../editor/cursor';

/** A circular arrow: CSS has no cursor for rotation. */
const TURN = `url("data:image/svg+xml,${encodeURIComponent(
  `<svg xmlns='http://www.w3.org/2000/svg' width='24' height='24' fill='none' stroke-linecap='round' stroke-linejoin='round'>
  <g id='a'><path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='white' stroke-width='4'/></g>
  <path d='M18.5 14.5A7 7 0 1 1 18 8.5M18.6 4.6v4.2h-4.2' stroke='black' stroke-width='1.8'/></svg>`,
)}") 12 12, grab`;

export const cssCursor = (cursor: Cursor): string => (cursor === 'turn' ? TURN : cursor);
