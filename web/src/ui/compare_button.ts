/** The button that shows the original. */
import { html, type TemplateResult } from 'lit';
import { ariaKeys, COMMANDS, keyHint } from './commands';
import { icon } from './icons';
import type { EditorActions, EditorModel } from './model';

/** Shows the original while it is held, by pointer or key; a click without a press, as of a screen reader, toggles. */
export function compareButton(model: EditorModel, actions: EditorActions): TemplateResult {
  const hold = () => actions.compare(true);
  const release = () => actions.compare(false);
  const onKey = (event: KeyboardEvent, act: () => void) => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    act();
  };
  return html`<button
    type="button"
    class="button"
    part="button"
    data-command="compare"
    data-tip=${COMMANDS.compare.label}
    data-keys=${keyHint('compare', model.platform)}
    aria-label=${COMMANDS.compare.label}
    aria-keyshortcuts=${ariaKeys('compare')}
    aria-pressed=${String(model.comparing)}
    ?disabled=${model.picture === null}
    @pointerdown=${hold}
    @pointerup=${release}
    @pointerleave=${release}
    @pointercancel=${release}
    @keydown=${(event: KeyboardEvent) => onKey(event, hold)}
    @keyup=${(event: KeyboardEvent) => onKey(event, release)}
    @blur=${release}
    @click=${(event: MouseEvent) => event.detail === 0 && actions.run('compare')}
    @contextmenu=${(event: Event) => event.preventDefault()}
  >
    ${icon('compare')}
  </button>`;
}
