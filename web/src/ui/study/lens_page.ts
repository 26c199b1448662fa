/** The lens: weights as bars, the way to each handle, and the falloff of one of them. */
import { html, nothing, type TemplateResult } from 'lit-html';
import type { LensSite, Share } from '../../document/generated/lens';
import type { Dispatch } from '../../editor/events';
import { type LensModel, lensModel } from '../../editor/lens_model';
import { NOTHING_BENDS, percent, siteName, VIRTUAL } from '../../editor/lens_texts';
import type { EditorModel } from '../../editor/view_model';
import { falloffPart } from './falloff_figure';
import { pixels } from './figure';
import { saveButton } from './save_button';

export function lensPage(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { lens: state } = model.study;
  const shown = lensModel(model.study);
  const [x, y] = (shown?.lens.at ?? [0, 0]).map(Math.round);
  const words = shown ? `x ${x}, y ${y}` : state.found ? NOTHING_BENDS : 'Point at the picture';
  return html`
    <div class="point">
      <h3>${words}</h3>
      ${pinning(state.pinned, model.press === 'tap', dispatch)}
    </div>
    ${shown ? known(shown, model, dispatch) : html`<p class="faint">Every point moves by the weights of the handles around it. Arrow keys move the lens, too.</p>`}`;
}

/** Fingers do not hover, so for them the lens has nothing to follow. */
function pinning(pinned: boolean, taps: boolean, dispatch: Dispatch): TemplateResult {
  if (taps) return html`<span class="faint">Tap a point to look at it</span>`;
  if (!pinned) return html`<span class="faint">Click to keep this point</span>`;
  return html`<button
    type="button"
    class="button toggle"
    part="button"
    @click=${() => dispatch({ type: 'lens-released' })}
  >
    Follow the pointer
  </button>`;
}

const known = (shown: LensModel, model: EditorModel, dispatch: Dispatch): TemplateResult => html`
  ${weights(shown, dispatch)}
  ${shown.falloff ? falloffPart(shown.falloff, shown.project, model, dispatch) : nothing}
  ${saveButton('lens', dispatch)}`;

function weights({ lens, project, falloff }: LensModel, dispatch: Dispatch): TemplateResult {
  const row = (share: Share) =>
    bar(
      siteName(project, share.handle),
      share.weight,
      share.passed_on,
      share.distance,
      share.site === falloff?.index,
      () => dispatch({ type: 'lens-site-chosen', site: share.site }),
    );
  const virtual = lens.sites.filter(({ site }) => !lens.shares.some((share) => share.site === site));
  return html`<section class="weights" aria-label="Weights">
    <ul>${lens.shares.map(row)}</ul>
    ${lens.shares.length === 0 ? html`<p class="faint">No handle is on this part, so it stays.</p>` : nothing}
    ${lens.virtual_weight > 0 ? virtualSites(lens.virtual_weight, virtual, falloff?.index ?? null, dispatch) : nothing}
    <p class="faint key">
      <span class="meaning"><span class="swatch own"></span>own weight</span>
      <span class="meaning"><span class="swatch passed"></span>passed on by virtual handles</span>
    </p>
  </section>`;
}

/** The sum of the virtual handles. It unfolds to each of them. */
const virtualSites = (
  sum: number,
  sites: readonly LensSite[],
  chosen: number | null,
  dispatch: Dispatch,
): TemplateResult => html`<details class="virtual">
  <summary class="row-of-bar">
    <span class="name">${VIRTUAL}</span> ${track(sum, 0, 'of-virtual')} <span class="number">${percent(sum)}</span>
    <span class="way faint">${sites.length} of them</span>
  </summary>
  <ul>
    ${sites.map(({ site, weight, distance }) =>
      bar(`Virtual ${site + 1}`, weight, 0, distance, site === chosen, () =>
        dispatch({ type: 'lens-site-chosen', site }),
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
): TemplateResult => html`<li>
  <button type="button" class="row-of-bar" aria-pressed=${String(chosen)} @click=${choose}>
    <span class="name">${name}</span> ${track(weight, passedOn, '')} <span class="number">${percent(weight)}</span>
    <span class="way faint">${pixels(distance)}${passedOn > 0 ? `, ${percent(passedOn)} passed on` : ''}</span>
  </button>
</li>`;

const track = (
  own: number,
  passed: number,
  kind: string,
): TemplateResult => html`<span class="track ${kind}" aria-hidden="true">
  <span class="own" .style=${`width: ${100 * own}%`}></span><span class="passed" .style=${`width: ${100 * passed}%`}></span>
</span>`;
