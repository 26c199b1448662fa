/** The list of keys: opened by its button or by "?", closed by Escape or a press beside it. */
import { html, type TemplateResult } from 'lit-html';
import { COMMANDS, type CommandName, keyHint, modifier } from '../editor/commands';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';

/** A command, or other keys and their effect. `Mod` is Ctrl, and Cmd on a Mac. */
type Row = CommandName | readonly [keys: string, what: string];

const GROUPS: readonly (readonly [title: string, rows: readonly Row[]])[] = [
  [
    'Tools',
    [
      'select',
      'point',
      'bar',
      'polygon',
      'lasso',
      'brush',
      'hand',
      'lens',
      ['Enter', 'Finish a drawing, or place at the crosshair'],
      ['Shift', 'Draw and move by 45°, turn by 15°'],
      ['Alt', 'Lasso: leave edges, or begin a hole'],
    ],
  ],
  [
    'Selection',
    [
      ['Tab', 'Next handle'],
      ['Shift click', 'One more, or one less'],
      'select-all',
      ['Shift F10', 'Menu'],
      'bail',
    ],
  ],
  [
    'Handles',
    [
      ['arrows', 'Move by 1 px, with Shift by 10'],
      [', and .', 'Turn by 1°, with Shift by 15; with Alt, scale'],
      ['Alt drag', 'Turn'],
      ['Alt click', 'Delete'],
      ['Mod while dragging', 'Ignore the guides'],
      'reset',
      'mirror',
      'copy',
      'paste',
      'forward',
      'backward',
      'suggest',
      'without-folds',
      'add-corner',
      'remove-corner',
      'rename',
      'remove',
    ],
  ],
  [
    'Brush',
    [
      'brush-erase',
      'brush-smaller',
      'brush-larger',
      ['Alt drag', 'The opposite: restore, pinch or bloat, erase'],
      ['Enter, arrows', 'Take hold and push; Enter lets go'],
    ],
  ],
  [
    'View',
    [
      ['Space drag', 'Pan'],
      ['Mod wheel', 'Zoom'],
      'fit',
      'actual',
      'zoom-in',
      'zoom-out',
      'compare',
      'preview',
    ],
  ],
  [
    'Timeline',
    [
      'timeline',
      'play',
      'set-key',
      ['R drag', 'Record a motion'],
      ['arrows', 'On the ruler: to the next frame; on a key: to the next key'],
      ['Alt arrows', 'Move keys by a frame'],
    ],
  ],
  ['Document', ['open', 'save', 'save-whole', 'export', 'export-as', 'undo', 'redo']],
];

export const keysButton = (): TemplateResult => html`<button
  type="button"
  class="button keys-button"
  part="button"
  popovertarget="keys"
  data-tip=${COMMANDS.keys.label}
  data-keys="?"
  aria-label=${COMMANDS.keys.label}
  aria-keyshortcuts="?"
>
  ${icon('keys')}
</button>`;

export const keysCard = ({ platform }: EditorModel): TemplateResult => html`<div
  id="keys"
  class="card keys"
  part="menu"
  popover
  role="dialog"
  aria-label=${COMMANDS.keys.label}
  tabindex="-1"
>
  <button
    type="button"
    class="button small"
    part="button"
    popovertarget="keys"
    popovertargetaction="hide"
    aria-label="Close the list of keys"
  >
    ${icon('close')}
  </button>
  <div class="columns">
    ${GROUPS.map(
      ([title, rows]) => html`<section>
        <h3>${title}</h3>
        <dl>${rows.map((row) => line(row, platform))}</dl>
      </section>`,
    )}
  </div>
</div>`;

function line(row: Row, platform: string): TemplateResult {
  const [keys, what] =
    typeof row === 'string'
      ? [keyHint(row, platform), COMMANDS[row].label]
      : [row[0].replace('Mod', modifier(platform)), row[1]];
  return html`<div><dt>${what}</dt><dd>${keys}</dd></div>`;
}
