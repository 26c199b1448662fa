/** The settings of bending: two modes, their detail, and switches. Folded to one line while handles are selected. */

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { blendOf, DETAILS, type Detail, detailOf, modeOf } from '../document/bending';
import { featherOf, isFilled, MOST_FEATHER, ringsOf } from '../document/domain';
import type { PoseMode } from '../document/project';
import { settingsOf } from '../document/settings';
import { modifier } from '../editor/commands';
import type { Dispatch, NumberChange } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import type { Texts } from '../texts/texts';
import { icon } from './icons';
import { type FieldLook, numberField } from './number_field';
import { segment } from './segment';

const MODES: readonly PoseMode[] = ['rigid', 'harmonic'];

export function bending(
  model: EditorModel,
  dispatch: Dispatch,
  open: boolean,
): TemplateResult | typeof nothing {
  if (!model.picture) return nothing;
  const { project } = model.document;
  const { bending: words } = model.texts;
  const mode = modeOf(project);
  const detail = detailOf(project);
  const details = Object.keys(DETAILS) as Detail[];
  const chosen = [words.modes[mode], ...(mode === 'rigid' && detail ? [words.details[detail]] : [])];
  return html`<details class="bending" ?open=${open}>
    <summary>
      <h3>${words.title}</h3>
      <span class="faint">${words.chosen(chosen)}</span>${icon('unfold')}
    </summary>
    <div class="segments" role="group" aria-label=${words.title}>
      ${MODES.map((name) => segment(words.modes[name], name === mode, model.readonly, () => dispatch({ type: 'pose-mode-chosen', mode: name })))}
    </div>
    <p class="faint">${words.modeNotes[mode]}</p>
    ${
      mode === 'rigid'
        ? html`<h3>${words.detail}</h3>
          <div class="segments" role="group" aria-label=${words.detail}>
            ${details.map((name) =>
              segment(words.details[name], name === detail, model.readonly, () =>
                dispatch({ type: 'detail-chosen', detail: name }),
              ),
            )}
          </div>`
        : toggle(words.keepWidths, words.keepWidthsNote, blendOf(project) === 'rigid', model, (on) =>
            dispatch({ type: 'blend-chosen', blend: on ? 'rigid' : 'linear' }),
          )
    }
    ${ringsOf(project).length > 0 ? [lassoed(model, dispatch), filled(model, dispatch), feathered(model, dispatch)] : nothing}
    ${toggle(words.holdBoundary, words.holdBoundaryNote, project.fix_boundary === true, model, (on) => dispatch({ type: 'boundary-switched', held: on }))}
    ${toggle(words.edges, words.edgesNote, project.edges === true, model, (on) => dispatch({ type: 'edges-switched', on }))}
    ${looseParts(model, dispatch)}
    ${toggle(words.stopAtFolds, words.stopAtFoldsNote, model.guarded, model, (on) => dispatch({ type: 'fold-guard-switched', on }))}
    ${toggle(words.snap, words.snapNote(modifier(model.platform, model.texts)), model.snapping, model, (on) => dispatch({ type: 'snapping-switched', on }))}
    ${
      model.pixelated === null
        ? nothing
        : toggle(words.pixelArt, words.pixelArtNote, model.pixelated, model, (on) =>
            dispatch({ type: 'pixel-art-switched', on }),
          )
    }
    <button
      type="button"
      class="button all-settings"
      part="button"
      @click=${() => dispatch({ type: 'study-shown', page: 'settings' })}
    >
      ${words.allSettings}
    </button>
  </details>`;
}

/** The way back from a lasso to the whole picture. */
const lassoed = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`<div class="switch">
  <span class="text">${model.texts.bending.selection}<span class="faint">${model.texts.bending.selectionNote}</span></span>
  <button
    type="button"
    class="button toggle"
    part="button"
    aria-label=${model.texts.bending.bendAll}
    ?disabled=${model.readonly}
    @click=${() => dispatch({ type: 'lasso-removed' })}
  >
    ${model.texts.bending.allOfIt}
  </button>
</div>`;

/** The background behind a lassoed part. */
const filled = (model: EditorModel, dispatch: Dispatch): TemplateResult =>
  toggle(
    model.texts.bending.fill,
    model.texts.bending.fillNote,
    isFilled(model.document.project),
    model,
    (on) => dispatch({ type: 'fill-switched', on }),
  );

const featherLook = ({ bending: words }: Texts): FieldLook => ({
  name: 'feather',
  label: words.feather,
  unit: 'px',
  step: 1,
  digits: 1,
  least: 0,
  most: MOST_FEATHER,
  digitKeys: true,
  tip: words.featherTip(MOST_FEATHER),
});

/** The soft rim of the part. While the boundary is held, nothing moves beyond it. */
function feathered(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { project } = model.document;
  const feather = featherOf(project);
  if (feather === null || project.fix_boundary === true) return nothing;
  const set = (change: NumberChange) => dispatch({ type: 'feather-set', change });
  return html`<div class="switch">
    <span class="text"><span class="faint">${model.texts.bending.featherNote}</span></span>
    ${numberField(featherLook(model.texts), [feather], set, model, dispatch)}
  </div>`;
}

/** Shown while there are parts without a handle, or they follow. */
function looseParts(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { project } = model.document;
  const count = model.solved?.looseParts ?? 0;
  const follow = settingsOf(project).loose_parts === 'follow';
  if (project.handles.length === 0 || (count === 0 && !follow)) return nothing;
  const { bending: words } = model.texts;
  return toggle(words.looseParts, words.loosePartsNote(count), follow, model, (on) =>
    dispatch({ type: 'setting-set', setting: { name: 'loose_parts', value: on ? 'follow' : 'stay' } }),
  );
}

const toggle = (
  word: string,
  note: string,
  on: boolean,
  model: EditorModel,
  choose: (on: boolean) => void,
): TemplateResult => html`<label class="switch" title=${note}>
  <span class="text">${word}<span class="faint">${note}</span></span>
  <input
    type="checkbox"
    role="switch"
    aria-label=${word}
    aria-description=${note}
    .checked=${live(on)}
    ?disabled=${model.readonly}
    @change=${(event: Event) => {
      event.stopPropagation();
      choose((event.target as HTMLInputElement).checked);
    }}
    @input=${(event: Event) => event.stopPropagation()}
  />
</label>`;
