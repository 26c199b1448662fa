/** The name of the selected handle: a button or, while the name is being typed, a field. */
import { html, nothing, type TemplateResult } from 'lit';
import { nameOf } from '../document/handle';
import { MOST_CHARACTERS } from '../document/names';
import type { Handle } from '../document/project';
import { COMMANDS } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import { NAME_FAULTS } from '../editor/notice_texts';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { untyped } from './untyped';

export function nameTitle(handle: Handle, model: EditorModel, dispatch: Dispatch): TemplateResult {
  if (model.renaming?.id === handle.id) return nameField(handle, model, dispatch);
  const name = nameOf(handle);
  if (model.readonly) return html`<h2 class="name">${name}</h2>`;
  return html`<h2>
    <button
      type="button"
      class="name"
      title="${COMMANDS.rename.label} (F2)"
      aria-label="${name}: rename"
      @click=${() => dispatch({ type: 'rename-asked', id: handle.id })}
    >
      <span>${name}</span>${icon('rename')}
    </button>
  </h2>`;
}

/** Commits on Enter and on leaving the field. Escape keeps the old name. */
function nameField(handle: Handle, { renaming }: EditorModel, dispatch: Dispatch): TemplateResult {
  const fault = renaming?.fault ?? null;
  const given = ({ target }: Event, keyed: boolean) =>
    dispatch({ type: 'name-given', name: (target as HTMLInputElement).value, keyed });
  const onKey = (event: KeyboardEvent) => {
    if (event.isComposing || (event.key !== 'Enter' && event.key !== 'Escape')) return;
    event.preventDefault();
    if (event.key === 'Enter') given(event, true);
    else dispatch({ type: 'renaming-ended' });
  };
  return html`<div class="naming">
    <label class="field">
      <input
        type="text"
        data-control="name"
        aria-label="Name of the handle"
        aria-invalid=${String(fault !== null)}
        aria-describedby=${fault ? 'name-fault' : nothing}
        autocomplete="off"
        spellcheck="false"
        maxlength=${MOST_CHARACTERS}
        .value=${untyped(nameOf(handle))}
        @keydown=${onKey}
        @blur=${(event: Event) => given(event, false)}
        @change=${(event: Event) => event.stopPropagation()}
        @input=${(event: Event) => {
          event.stopPropagation();
          dispatch({ type: 'name-typed', name: (event.target as HTMLInputElement).value });
        }}
      />
    </label>
    ${fault ? html`<p class="fault" id="name-fault">${NAME_FAULTS[fault]}</p>` : nothing}
  </div>`;
}
