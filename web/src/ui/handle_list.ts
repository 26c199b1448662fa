/** The list of all handles. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { anchor, isAtRest } from '../document/handle';
import { nameWords } from '../document/names';
import type { Handle } from '../document/project';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { commandButton } from './command_button';

/** Selects a handle and brings it into view. A press also focuses it, for arrow keys. */
function listed(event: MouseEvent, handle: Handle, dispatch: Dispatch): void {
  dispatch({ type: 'handles-selected', ids: [handle.id] });
  dispatch({ type: 'place-revealed', at: anchor(handle) });
  if (event.detail > 0) dispatch({ type: 'handle-focus-asked', id: handle.id });
}

/** Whether a press adds to the selection, or removes from it. */
const adds = (event: MouseEvent): boolean => event.shiftKey || event.ctrlKey || event.metaKey;

export function handleList(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { project, selection } = model.document;
  const { handleList: words } = model.texts;
  return html`<section class="list">
    <div class="head">
      <h3>${words.title} <span class="faint">${project.handles.length}</span></h3>
      ${model.picture && !model.readonly ? commandButton('suggest', model, dispatch, project.handles.length > 0 ? { label: words.suggestMore } : {}) : nothing}
    </div>
    ${
      project.handles.length === 0
        ? html`<p class="faint">${words.none[model.press]}</p>`
        : html`<ul>
            ${project.handles.map(
              (handle) => html`<li>
                <button
                  type="button"
                  class="item"
                  aria-pressed=${String(selection.includes(handle.id))}
                  @click=${(event: MouseEvent) =>
                    adds(event)
                      ? dispatch({ type: 'handle-toggled', id: handle.id })
                      : listed(event, handle, dispatch)}
                >
                  <span class="dot of-${handle.kind}"></span><span class="name">${model.worded(nameWords(handle))}</span>
                  ${isAtRest(handle) ? nothing : html`<span class="moved" role="img" aria-label=${words.moved} title=${words.movedTip}></span>`}
                </button>
              </li>`,
            )}
          </ul>`
    }
  </section>`;
}

/** Scrolls the list, and nothing else, to the first selected handle. */
export function showSelected(root: ShadowRoot): void {
  const list = root.querySelector('.list ul');
  const item = list?.querySelector('[aria-pressed="true"]');
  if (!list || !item) return;
  const [frame, box] = [list.getBoundingClientRect(), item.getBoundingClientRect()];
  // Scrolling ends at whole pixels, and heights are fractions.
  list.scrollTop +=
    Math.floor(Math.min(0, box.top - frame.top)) + Math.ceil(Math.max(0, box.bottom - frame.bottom));
}
