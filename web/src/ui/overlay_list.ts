/** The overlays: their button, and the list in the panel, which stays open while people work. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import { OVERLAYS, type OverlayName } from '../editor/overlays';
import type { EditorModel } from '../editor/view_model';
import { captionOf } from './command_button';
import { icon } from './icons';

/** The name and the tooltip of each overlay. */
const TEXTS = {
  mesh: ['Mesh', 'The triangles that the picture is drawn with'],
  cells: ['Cells', 'The part nearest to each handle, virtual handles included'],
  sites: ['Virtual handles', 'Points that move the picture between your handles'],
  graph: ['Cell graph', 'The neighbours among all handles, virtual ones included'],
  creases: ['Creases', 'Places where the picture has turned over'],
  reach: ['Reach', 'How far each place follows a small move of the selected handles'],
  coverage: ['Coverage', 'The number of handles that move each place, virtual ones included'],
  stiffness: ['Stiffness', 'How stiff each place is: by the brush, and inside of stiff polygons'],
  selection: ['Selection', 'The outline of what a lasso lets bend, and the rest dimmed'],
} as const satisfies Record<OverlayName, readonly [label: string, tip: string]>;

export function overlayButton(model: EditorModel, dispatch: Dispatch): TemplateResult {
  // The selection is shown from the beginning.
  const shown = OVERLAYS.filter((name) => model.overlays[name] && name !== 'selection').map(
    (name) => TEXTS[name][0],
  );
  const label = ['Overlays', shown.join(', ').toLowerCase()].filter(Boolean).join(': ');
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
    ${icon('overlays')}${captionOf('Overlays')}
  </button>`;
}

export function overlayList(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const close = (keyed: boolean) => dispatch({ type: 'overlays-opened', open: false, keyed });
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    close(true);
  };
  return html`<section class="overlays" role="group" aria-label="Overlays" @keydown=${onKey}>
    <div class="row">
      <h3>Overlays</h3>
      <button
        type="button"
        class="button small"
        part="button"
        aria-label="Close the list"
        @click=${({ detail }: MouseEvent) => close(detail === 0)}
      >
        ${icon('close')}
      </button>
    </div>
    <div class="checks">${OVERLAYS.map((name) => check(name, model, dispatch))}</div>
  </section>`;
}

const check = (name: OverlayName, model: EditorModel, dispatch: Dispatch): TemplateResult => {
  const [label, tip] = TEXTS[name];
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
    />${label}
  </label>`;
};
