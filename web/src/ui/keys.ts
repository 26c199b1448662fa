/** The list of keys: opened by its button or by "?", closed by Escape or a press beside it. */

import { html, type TemplateResult } from 'lit-html';
import { type CommandName, keyHint, modifier } from '../editor/commands';
import type { EditorModel } from '../editor/view_model';
import type { Texts } from '../texts/texts';
import { TOOL_NAMES } from '../tools/machine';
import { icon } from './icons';

/** A command, or other keys and their effect. */
type Row = CommandName | readonly [keys: PressName, effect: keyof Texts['keys']['effects']];
type PressName = keyof Texts['keys']['presses'];

const GROUPS = {
  tools: [...TOOL_NAMES, ['enter', 'finish'], ['shift', 'straight'], ['alt', 'lassoAlt']],
  selection: [['tab', 'next'], ['shiftClick', 'oneMore'], 'select-all', ['shiftF10', 'menu'], 'bail'],
  handles: [
    ['arrows', 'move'],
    ['turn', 'turnBy'],
    ['altDrag', 'turn'],
    ['altClick', 'remove'],
    ['modDrag', 'ignoreGuides'],
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
  brush: ['brush-erase', 'brush-smaller', 'brush-larger', ['altDrag', 'opposite'], ['enterArrows', 'push']],
  view: [
    ['spaceDrag', 'pan'],
    ['modWheel', 'zoom'],
    'fit',
    'actual',
    'zoom-in',
    'zoom-out',
    'compare',
    'preview',
  ],
  timeline: [
    'timeline',
    'play',
    'set-key',
    ['recordDrag', 'record'],
    ['arrows', 'ruler'],
    ['altArrows', 'moveKeys'],
  ],
  document: ['open', 'save', 'save-whole', 'export', 'export-as', 'undo', 'redo'],
} as const satisfies Record<keyof Texts['keys']['groups'], readonly Row[]>;

export const keysButton = ({ texts }: EditorModel): TemplateResult => html`<button
  type="button"
  class="button keys-button"
  part="button"
  popovertarget="keys"
  data-tip=${texts.commands.keys}
  data-keys="?"
  aria-label=${texts.commands.keys}
  aria-keyshortcuts="?"
>
  ${icon('keys')}
</button>`;

export const keysCard = ({ platform, texts }: EditorModel): TemplateResult => html`<div
  id="keys"
  class="card keys"
  part="menu"
  popover
  role="dialog"
  aria-label=${texts.commands.keys}
  tabindex="-1"
>
  <button
    type="button"
    class="button small"
    part="button"
    popovertarget="keys"
    popovertargetaction="hide"
    aria-label=${texts.keys.close}
  >
    ${icon('close')}
  </button>
  <div class="columns">
    ${(Object.keys(GROUPS) as (keyof typeof GROUPS)[]).map(
      (name) => html`<section>
        <h3>${texts.keys.groups[name]}</h3>
        <dl>${GROUPS[name].map((row) => line(row, platform, texts))}</dl>
      </section>`,
    )}
  </div>
</div>`;

function line(row: Row, platform: string, texts: Texts): TemplateResult {
  const [keys, effect] =
    typeof row === 'string'
      ? [keyHint(row, platform, texts), texts.commands[row]]
      : [pressText(row[0], platform, texts), texts.keys.effects[row[1]]];
  return html`<div><dt>${effect}</dt><dd>${keys}</dd></div>`;
}

function pressText(name: PressName, platform: string, texts: Texts): string {
  const press = texts.keys.presses[name];
  return typeof press === 'string' ? press : press(modifier(platform, texts));
}
