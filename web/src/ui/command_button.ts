/** A button for a command. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { ariaKeys, type CommandName, keyHint } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { type IconName, icon, iconOf } from './icons';

export interface Look {
  readonly text?: string;
  /** The word below the icon on phones: part of the label. Without it, the text. */
  readonly caption?: string;
  readonly pressed?: boolean;
  /** In place of the command's icon. */
  readonly icon?: IconName;
  /** A fuller label than the table's: "Undo move head". */
  readonly label?: string;
}

/** A word below an icon, shown on phones. */
export const captionOf = (word: string | undefined): TemplateResult | typeof nothing =>
  word === undefined ? nothing : html`<span class="caption" aria-hidden="true">${word}</span>`;

/** A button that runs a command, with the table's label, icon and keys. None where the page leaves the command out. */
export function commandButton(
  name: CommandName,
  model: EditorModel,
  dispatch: Dispatch,
  look: Look = {},
): TemplateResult | typeof nothing {
  if (!model.offers(name)) return nothing;
  const label = look.label ?? model.texts.commands[name];
  return html`<button
    type="button"
    class="button ${look.text ? 'worded' : ''}"
    part="button"
    data-command=${name}
    data-tip=${label}
    data-keys=${keyHint(name, model.platform, model.texts)}
    aria-label=${label}
    aria-keyshortcuts=${ariaKeys(name, model.platform) || nothing}
    aria-pressed=${look.pressed === undefined ? nothing : String(look.pressed)}
    ?disabled=${!model.canRun(name)}
    @click=${() => dispatch({ type: 'command-run', command: name })}
  >
    ${icon(look.icon ?? iconOf(name))}${look.text ? html`<span class="word">${look.text}</span>` : ''}${captionOf(look.caption ?? look.text)}
  </button>`;
}
