/** The overlays: their button, and the list in the panel, which stays open while people work. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import { OVERLAYS, type OverlayName } from '../editor/overlays';
import type { EditorModel } from '../editor/view_model';
import { captionOf } from './command_button';
import { icon } from './icons';

export function overlayButton(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { overlays: words } = model.texts;
  // The selection is shown from the beginning.
  const shown = OVERLAYS.filter((name) => model.overlays[name] && name !== 'selection').map(
    (name) => words.names[name],
  );
  const label = shown.length > 0 ? words.titleWith(shown) : words.title;
  const open = !model.overlayList;
  return html`<button
    type="button"
    class="button ${shown.length > 0 ? 'on' : ''}"
    part="button"
    data-control="overlay-button"
    data-tip=${label}
    aria-label=${label}
    aria-expanded=${String(model.overlayList)}
    @click=${({ detail }: MouseEvent) => dispatch({ type: 'overlays-opened', open, keyed: detail === 0 })}
  >
    ${icon('overlays')}${captionOf(words.title)}
  </button>`;
}

export function overlayList(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { overlays: words } = model.texts;
  const close = (keyed: boolean) => dispatch({ type: 'overlays-opened', open: false, keyed });
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    close(true);
  };
  return html`<section class="overlays" role="group" aria-label=${words.title} @keydown=${onKey}>
    <div class="row">
      <h3>${words.title}</h3>
      <button
        type="button"
        class="button small"
        part="button"
        aria-label=${words.close}
        @click=${({ detail }: MouseEvent) => close(detail === 0)}
      >
        ${icon('close')}
      </button>
    </div>
    <div class="checks">${OVERLAYS.map((name) => check(name, model, dispatch))}</div>
  </section>`;
}

const check = (name: OverlayName, model: EditorModel, dispatch: Dispatch): TemplateResult => {
  const { names, tips } = model.texts.overlays;
  const tip = tips[name];
  return html`<label class="check" title=${tip}>
    <input
      type="checkbox"
      data-control=${name === OVERLAYS[0] ? 'overlays' : ''}
      aria-description=${tip}
      .checked=${model.overlays[name]}
      @change=${(event: Event) => {
        event.stopPropagation();
        const on = (event.target as HTMLInputElement).checked;
        dispatch({ type: 'overlay-switched', overlay: name, on });
      }}
      @input=${(event: Event) => event.stopPropagation()}
    />${names[name]}
  </label>`;
};
