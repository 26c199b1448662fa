/**
 * The menu beside Open: an address to open, recent work, and the samples of the page. On phones it takes the place of
 * Open, so that the bar has room.
 */
import { html, nothing, type TemplateResult } from 'lit-html';
import { COMMANDS } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { Sample } from '../editor/page';
import type { EditorModel } from '../editor/view_model';
import type { WorkSnapshot } from '../editor/work';
import { placeBelowButton } from './below_button';
import { closePopover } from './close_popover';
import { captionOf } from './command_button';
import { icon, iconOf } from './icons';
import { shortened } from './shortened';

const LABEL = 'Open recent work, samples or an address';
const RECENT = 'Recent work';
const WHOLE = 'One file with all';

export function filesMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  return html`<div class="menu">
    <button
      type="button"
      class="button slim"
      part="button"
      popovertarget="files"
      data-tip=${LABEL}
      aria-label=${LABEL}
      ?disabled=${!model.canRun('open')}
    >
      ${icon('unfold')}${icon('open')}${captionOf('Open')}
    </button>
    <div
      id="files"
      class="popover card files"
      part="menu"
      popover
      role="dialog"
      aria-label=${LABEL}
      @beforetoggle=${(event: ToggleEvent) => {
        placeBelowButton(event);
        dispatch({ type: 'popover-toggled', popover: 'files', open: event.newState === 'open' });
      }}
    >
      ${model.filesMenu ? content(model, dispatch) : nothing}
    </div>
  </div>`;
}

const content = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`
  ${entryOf('open', COMMANDS.open.label, model, dispatch)}
  <form class="address" novalidate @submit=${(event: Event) => openAddress(event, dispatch)}>
    <input
      name="address"
      type="url"
      inputmode="url"
      autocomplete="off"
      spellcheck="false"
      placeholder="https://…/picture.png"
      aria-label="Address of a picture or a project"
      @keydown=${(event: KeyboardEvent) => event.key !== 'Escape' && event.stopPropagation()}
    />
    <button type="submit" class="button" part="button">Open</button>
  </form>
  ${model.recent.length > 0 ? recentWork(model.recent, dispatch) : nothing}
  ${model.samples.length > 0 ? samples(model.samples, dispatch) : nothing}
  ${model.recent.length > 0 ? nothing : noRecentWork}
  <section aria-label=${WHOLE}>
    <h2>${WHOLE}</h2>
    ${entryOf('save-whole', 'Save with the picture', model, dispatch)}
    ${entryOf('export-whole', 'Export a PNG that opens again', model, dispatch)}
  </section>`;

const recentWork = (
  works: readonly WorkSnapshot[],
  dispatch: Dispatch,
): TemplateResult => html`<section aria-label=${RECENT}>
  <h2>
    ${RECENT}
    ${works.length > 1 ? html`<button type="button" class="link" @click=${() => dispatch({ type: 'recent-removed', id: null })}>Remove all</button>` : nothing}
  </h2>
  <ul>${works.map((work) => entry(work, dispatch))}</ul>
</section>`;

const noRecentWork = html`<section aria-label=${RECENT}>
  <h2>${RECENT}</h2>
  <p class="faint">Pictures that you have edited are listed here once you open another.</p>
</section>`;

/** A command that closes the menu. */
const entryOf = (
  command: 'open' | 'save-whole' | 'export-whole',
  text: string,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => html`<button
  type="button"
  class="button pick"
  part="button"
  data-command=${command}
  title=${COMMANDS[command].label}
  ?disabled=${!model.canRun(command)}
  @click=${(event: Event) => {
    closePopover(event);
    dispatch({ type: 'command-run', command });
  }}
>
  ${icon(iconOf(command))}${text}
</button>`;

function openAddress(event: Event, dispatch: Dispatch): void {
  event.preventDefault();
  const text = new FormData(event.currentTarget as HTMLFormElement).get('address');
  closePopover(event);
  dispatch({ type: 'address-given', text: String(text) });
}

const samples = (
  list: readonly Sample[],
  dispatch: Dispatch,
): TemplateResult => html`<section aria-label="Samples">
  <h2>Samples</h2>
  <div class="samples">
    ${list.map(
      (sample) => html`<button
        type="button"
        class="button"
        part="button"
        aria-label="Open the sample ${sample.name}"
        @click=${(event: Event) => {
          closePopover(event);
          dispatch({ type: 'sample-chosen', sample });
        }}
      >
        <img src=${sample.src} alt="" loading="lazy" />${sample.name}
      </button>`,
    )}
  </div>
</section>`;

const entry = (work: WorkSnapshot, dispatch: Dispatch): TemplateResult => html`<li>
  <button
    type="button"
    class="button pick"
    part="button"
    @click=${(event: Event) => {
      closePopover(event);
      dispatch({ type: 'back-asked', work });
    }}
  >
    ${work.thumbnail ? html`<img src=${work.thumbnail} alt="" />` : html`<span class="no-thumbnail"></span>`}
    <span class="name">${shortened(work.name)}</span>
    <span class="faint">${steps(work)}</span>
  </button>
  <button
    type="button"
    class="button small"
    part="button"
    aria-label="Remove ${work.name} from the list"
    @click=${() => dispatch({ type: 'recent-removed', id: work.id })}
  >
    ${icon('close')}
  </button>
</li>`;

function steps({ record: { past } }: WorkSnapshot): string {
  if (past.length === 0) return 'a drawing';
  return past.length === 1 ? '1 step' : `${past.length} steps`;
}
