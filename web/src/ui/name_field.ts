/** The name of the selected handle: a button or, while the name is being typed, a field. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { nameOf } from '../document/handle';
import { nameWords } from '../document/names';
import type { Handle } from '../document/project';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { icon } from './icons';
import { nameInput } from './name_input';

export function nameTitle(handle: Handle, model: EditorModel, dispatch: Dispatch): TemplateResult {
  if (model.renaming?.id === handle.id) return nameField(handle, model, dispatch);
  const { panel: words } = model.texts;
  const name = model.worded(nameWords(handle));
  if (model.readonly) return html`<h2 class="name">${name}</h2>`;
  return html`<h2>
    <button
      type="button"
      class="name"
      title=${words.renameTip('F2')}
      aria-label=${words.rename(name)}
      @click=${() => dispatch({ type: 'rename-asked', id: handle.id })}
    >
      <span>${name}</span>${icon('rename')}
    </button>
  </h2>`;
}

function nameField(handle: Handle, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { renaming, texts } = model;
  const shown = model.worded(nameWords(handle));
  // A generated name is shown as a description. If it is not edited, it stays.
  const own = (name: string) => (name === shown ? nameOf(handle) : name);
  const fault = renaming?.fault ?? null;
  return html`<div class="naming">
    ${nameInput({
      control: 'name',
      label: texts.panel.name,
      name: shown,
      fault: fault && 'name-fault',
      given: (name, keyed) => dispatch({ type: 'name-given', name: own(name), keyed }),
      ended: () => dispatch({ type: 'renaming-ended' }),
      typed: (name) => dispatch({ type: 'name-typed', name: own(name) }),
    })}
    ${fault ? html`<p class="fault" id="name-fault">${texts.panel.nameFaults[fault]}</p>` : nothing}
  </div>`;
}
