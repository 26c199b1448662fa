/**
 * The menu beside Open: an address to open, recent work, and the samples of the page. On phones it takes the place of
 * Open, so that the bar has room.
 */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../editor/events';
import type { Sample } from '../editor/page';
import type { EditorModel } from '../editor/view_model';
import type { WorkSnapshot } from '../editor/work';
import { shownName } from '../texts/shown_name';
import type { Texts } from '../texts/texts';
import { placeBelowButton } from './below_button';
import { closePopover } from './close_popover';
import { captionOf } from './command_button';
import { icon, iconOf } from './icons';
import { shortened } from './shortened';

export function filesMenu(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { label } = model.texts.files;
  return html`<div class="menu">
    <button
      type="button"
      class="button slim"
      part="button"
      popovertarget="files"
      data-tip=${label}
      aria-label=${label}
      ?disabled=${!model.canRun('open')}
    >
      ${icon('unfold')}${icon('open')}${captionOf(model.texts.toolbar.open)}
    </button>
    <div
      id="files"
      class="popover card files"
      part="menu"
      popover
      role="dialog"
      aria-label=${label}
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
  ${entryOf('open', model.texts.commands.open, model, dispatch)}
  <form class="address" novalidate @submit=${(event: Event) => openAddress(event, dispatch)}>
    <input
      name="address"
      type="url"
      inputmode="url"
      autocomplete="off"
      spellcheck="false"
      placeholder=${model.texts.files.placeholder}
      aria-label=${model.texts.files.address}
      @keydown=${(event: KeyboardEvent) => event.key !== 'Escape' && event.stopPropagation()}
    />
    <button type="submit" class="button" part="button">${model.texts.files.open}</button>
  </form>
  ${model.recent.length > 0 ? recentWork(model.recent, model.texts, dispatch) : nothing}
  ${model.samples.length > 0 ? samples(model.samples, model.texts, dispatch) : nothing}
  ${model.recent.length > 0 ? nothing : noRecentWork(model.texts)}
  <section aria-label=${model.texts.files.whole}>
    <h2>${model.texts.files.whole}</h2>
    ${entryOf('save-whole', model.texts.files.saveWhole, model, dispatch)}
    ${entryOf('export-whole', model.texts.files.exportWhole, model, dispatch)}
  </section>`;

const recentWork = (
  works: readonly WorkSnapshot[],
  texts: Texts,
  dispatch: Dispatch,
): TemplateResult => html`<section aria-label=${texts.files.recent}>
  <h2>
    ${texts.files.recent}
    ${works.length > 1 ? html`<button type="button" class="link" @click=${() => dispatch({ type: 'recent-removed', id: null })}>${texts.files.removeAll}</button>` : nothing}
  </h2>
  <ul>${works.map((work) => entry(work, texts, dispatch))}</ul>
</section>`;

const noRecentWork = ({ files }: Texts): TemplateResult => html`<section aria-label=${files.recent}>
  <h2>${files.recent}</h2>
  <p class="faint">${files.noRecent}</p>
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
  title=${model.texts.commands[command]}
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
  { files }: Texts,
  dispatch: Dispatch,
): TemplateResult => html`<section aria-label=${files.samples}>
  <h2>${files.samples}</h2>
  <div class="samples">
    ${list.map(
      (sample) => html`<button
        type="button"
        class="button"
        part="button"
        aria-label=${files.openSample(sample.name)}
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

const entry = (work: WorkSnapshot, texts: Texts, dispatch: Dispatch): TemplateResult => html`<li>
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
    <span class="name">${shortened(shownName(work.name))}</span>
    <span class="faint">${steps(work, texts)}</span>
  </button>
  <button
    type="button"
    class="button small"
    part="button"
    aria-label=${texts.files.remove(shownName(work.name))}
    @click=${() => dispatch({ type: 'recent-removed', id: work.id })}
  >
    ${icon('close')}
  </button>
</li>`;

const steps = ({ record: { past } }: WorkSnapshot, { files }: Texts): string =>
  past.length === 0 ? files.drawing : files.steps(past.length);
