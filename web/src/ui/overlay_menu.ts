/** The menu of overlays: a button, and a check box for each. */
import { html, type TemplateResult } from 'lit';
import type { Dispatch } from '../editor/events';
import { OVERLAYS, type OverlayName } from '../editor/overlays';
import type { EditorModel } from '../editor/view_model';
import { placeBelowButton } from './below_button';
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
} as const satisfies Record<OverlayName, readonly [label: string, tip: string]>;

export function overlayMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const shown = OVERLAYS.filter((name) => model.overlays[name]).map((name) => TEXTS[name][0]);
  const label = ['Overlays', shown.join(', ').toLowerCase()].filter(Boolean).join(': ');
  return html`<div class="menu">
    <button
      type="button"
      class="button ${shown.length > 0 ? 'on' : ''}"
      part="button"
      id="overlays-button"
      popovertarget="overlays"
      data-tip=${label}
      aria-label=${label}
    >
      ${icon('overlays')}
    </button>
    <div
      id="overlays"
      class="popover card"
      part="menu"
      popover
      aria-label="Overlays"
      role="group"
      @beforetoggle=${placeBelowButton}
    >
      ${OVERLAYS.map(
        (name) => html`<label class="check" title=${TEXTS[name][1]}>
          <input
            type="checkbox"
            aria-description=${TEXTS[name][1]}
            .checked=${model.overlays[name]}
            @change=${(event: Event) => {
              event.stopPropagation();
              dispatch({
                type: 'overlay-switched',
                overlay: name,
                on: (event.target as HTMLInputElement).checked,
              });
            }}
            @input=${(event: Event) => event.stopPropagation()}
          />${TEXTS[name][0]}
        </label>`,
      )}
    </div>
  </div>`;
}
