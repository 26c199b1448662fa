/** The name of the selected handle: a button or, while the name is being typed, a field. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { nameOf } from '../document/handle';
import type { Handle } from '../document/project';
import { COMMANDS } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import { NAME_FAULTS } from '../editor/notice_texts';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { nameInput } from './name_input';

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

function nameField(handle: Handle, { renaming }: EditorModel, dispatch: Dispatch): TemplateResult {
  const fault = renaming?.fault ?? null;
  return html`<div class="naming">
    ${nameInput({
      control: 'name',
      label: 'Name of the handle',
      name: nameOf(handle),
      fault: fault && 'name-fault',
      given: (name, keyed) => dispatch({ type: 'name-given', name, keyed }),
      ended: () => dispatch({ type: 'renaming-ended' }),
      typed: (name) => dispatch({ type: 'name-typed', name }),
    })}
    ${fault ? html`<p class="fault" id="name-fault">${NAME_FAULTS[fault]}</p>` : nothing}
  </div>`;
}
