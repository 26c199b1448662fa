/** A button that shows the picture without handles while it is held: the original, or the posed picture. */
import { html, type TemplateResult } from 'lit-html';
import { ariaKeys, keyHint, type PreviewCommand } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { captionOf } from './command_button';
import { icon, iconOf } from './icons';

/** Held by pointer or key. A click without a press, as by a screen reader, toggles. */
export function holdButton(
  name: PreviewCommand,
  caption: string,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const hold = () => dispatch({ type: 'preview-held', command: name });
  const release = () => dispatch({ type: 'preview-held', command: null });
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
    data-tip=${model.texts.commands[name]}
    data-keys=${keyHint(name, model.platform, model.texts)}
    aria-label=${model.texts.commands[name]}
    aria-keyshortcuts=${ariaKeys(name, model.platform)}
    aria-pressed=${String(model.preview === name)}
    ?disabled=${!model.canRun(name)}
    @pointerdown=${hold}
    @pointerup=${release}
    @pointerleave=${release}
    @pointercancel=${release}
    @keydown=${(event: KeyboardEvent) => onKey(event, hold)}
    @keyup=${(event: KeyboardEvent) => onKey(event, release)}
    @blur=${release}
    @click=${(event: MouseEvent) => event.detail === 0 && dispatch({ type: 'command-run', command: name })}
    @contextmenu=${(event: Event) => event.preventDefault()}
  >
    ${icon(iconOf(name))}${captionOf(caption)}
  </button>`;
}
