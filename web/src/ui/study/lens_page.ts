/** The lens: weights as bars, the way to each handle, and the falloff of one of them. */

import { html, nothing, type TemplateResult } from 'lit-html';
import type { LensSite, Share } from '../../document/generated/lens';
import type { Dispatch } from '../../editor/events';
import { type LensModel, lensModel } from '../../editor/lens_model';
import { percent, siteName } from '../../editor/lens_words';
import type { EditorModel } from '../../editor/view_model';
import type { Texts } from '../../texts/texts';
import { falloffPart } from './falloff_figure';
import { pixels } from './figure';
import { saveButton } from './save_button';

export function lensPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { lens: state } = model.study;
  const shown = lensModel(model.study);
  const { lens: texts, spoken } = model.texts;
  const [x = 0, y = 0] = (shown?.lens.at ?? []).map(Math.round);
  const words = shown ? spoken.at(x, y) : state.found ? texts.nothingBends : texts.point;
  return html`
    <div class="point">
      <h3>${words}</h3>
      ${pinning(state.pinned, model, dispatch)}
    </div>
    ${shown ? known(shown, model, dispatch) : html`<p class="faint">${texts.note}</p>`}`;
}

/** Fingers do not hover, so for them the lens has nothing to follow. */
function pinning(pinned: boolean, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { lens: words } = model.texts;
  if (model.press === 'tap') return html`<span class="faint">${words.tap}</span>`;
  if (!pinned) return html`<span class="faint">${words.click}</span>`;
  return html`<button
    type="button"
    class="button toggle"
    part="button"
    @click=${() => dispatch({ type: 'lens-released' })}
  >
    ${words.follow}
  </button>`;
}

const known = (shown: LensModel, model: EditorModel, dispatch: Dispatch): TemplateResult => html`
  ${weights(shown, model, dispatch)}
  ${shown.falloff ? falloffPart(shown.falloff, shown.project, model, dispatch) : nothing}
  ${saveButton('lens', model.texts, dispatch)}`;

function weights(
  { lens, project, falloff }: LensModel,
  { texts, worded }: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const { lens: words } = texts;
  const row = (share: Share) =>
    bar(
      worded(siteName(project, share.handle)),
      share.weight,
      share.passed_on,
      share.distance,
      share.site === falloff?.index,
      () => dispatch({ type: 'lens-site-chosen', site: share.site }),
      words,
    );
  const virtual = lens.sites.filter(({ site }) => !lens.shares.some((share) => share.site === site));
  return html`<section class="weights" aria-label=${words.weights}>
    <ul>${lens.shares.map(row)}</ul>
    ${lens.shares.length === 0 ? html`<p class="faint">${words.noHandle}</p>` : nothing}
    ${lens.virtual_weight > 0 ? virtualSites(lens.virtual_weight, virtual, falloff?.index ?? null, words, dispatch) : nothing}
    <p class="faint key">
      <span class="meaning"><span class="swatch own"></span>${words.ownWeight}</span>
      <span class="meaning"><span class="swatch passed"></span>${words.passedOn}</span>
    </p>
  </section>`;
}

/** The sum of the virtual handles. It unfolds to each of them. */
const virtualSites = (
  sum: number,
  sites: readonly LensSite[],
  chosen: number | null,
  words: Texts['lens'],
  dispatch: Dispatch,
): TemplateResult => html`<details class="virtual">
  <summary class="row-of-bar">
    <span class="name">${words.virtualHandles}</span> ${track(sum, 0, 'of-virtual')} <span class="number">${percent(sum)}</span>
    <span class="way faint">${words.countOfThem(sites.length)}</span>
  </summary>
  <ul>
    ${sites.map(({ site, weight, distance }) =>
      bar(
        words.virtual(site + 1),
        weight,
        0,
        distance,
        site === chosen,
        () => dispatch({ type: 'lens-site-chosen', site }),
        words,
      ),
    )}
  </ul>
</details>`;

/** A row of the bars. A press shows the falloff of its site. */
const bar = (
  name: string,
  weight: number,
  passedOn: number,
  distance: number,
  chosen: boolean,
  choose: () => void,
  words: Texts['lens'],
): TemplateResult => html`<li>
  <button type="button" class="row-of-bar" aria-pressed=${String(chosen)} @click=${choose}>
    <span class="name">${name}</span> ${track(weight, passedOn, '')} <span class="number">${percent(weight)}</span>
    <span class="way faint">${passedOn > 0 ? words.distancePassed(pixels(distance), percent(passedOn)) : pixels(distance)}</span>
  </button>
</li>`;

const track = (
  own: number,
  passed: number,
  kind: string,
): TemplateResult => html`<span class="track ${kind}" aria-hidden="true">
  <span class="own" .style=${`width: ${100 * own}%`}></span><span class="passed" .style=${`width: ${100 * passed}%`}></span>
</span>`;
