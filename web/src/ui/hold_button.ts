/** A button that shows the picture alone while it is held: as it was, or as it is posed. */
import { html, type TemplateResult } from 'lit';
import { ariaKeys, type BareView, COMMANDS, keyHint } from './commands';
import { icon } from './icons';
import type { EditorActions, EditorModel } from './model';
import { isPossible } from './possible';

/** Held by pointer or key; a click without a press, as of a screen reader, toggles. */
export function holdButton(name: BareView, model: EditorModel, actions: EditorActions): TemplateResult {
  const hold = () => actions.showBare(name);
  const release = () => actions.showBare(null);
  const onKey = (event: KeyboardEvent, act: () => void) => {
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    act();
  };
  return html`<button
    type="button"
    class="button"
    part="button"
    data-command=${name}
    data-tip=${COMMANDS[name].label}
    data-keys=${keyHint(name, model.platform)}
    aria-label=${COMMANDS[name].label}
    aria-keyshortcuts=${ariaKeys(name, model.platform)}
    aria-pressed=${String(model.bare === name)}
    ?disabled=${!isPossible(name, model)}
    @pointerdown=${hold}
    @pointerup=${release}
    @pointerleave=${release}
    @pointercancel=${release}
    @keydown=${(event: KeyboardEvent) => onKey(event, hold)}
    @keyup=${(event: KeyboardEvent) => onKey(event, release)}
    @blur=${release}
    @click=${(event: MouseEvent) => event.detail === 0 && actions.run(name)}
    @contextmenu=${(event: Event) => event.preventDefault()}
  >
    ${icon(COMMANDS[name].icon)}
  </button>`;
}
