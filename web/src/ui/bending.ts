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
import { icon } from './icons';
import { type FieldLook, numberField } from './number_field';
import { segment } from './segment';

const MODES = {
  rigid: { word: 'Rigid', note: 'Shapes keep their form: an arm bends as an arm does.' },
  harmonic: { word: 'By hand', note: 'You turn the handles, and their motions blend, as in the paper.' },
} as const satisfies Record<PoseMode, object>;

const DETAIL_WORDS = { coarse: 'Coarse', medium: 'Medium', fine: 'Fine' } as const satisfies Record<
  Detail,
  string
>;

export function bending(
  model: EditorModel,
  dispatch: Dispatch,
  open: boolean,
): TemplateResult | typeof nothing {
  if (!model.picture) return nothing;
  const { project } = model.document;
  const mode = modeOf(project);
  const detail = detailOf(project);
  const modes = Object.keys(MODES) as PoseMode[];
  const details = Object.keys(DETAILS) as Detail[];
  const chosen = mode === 'rigid' && detail ? [MODES.rigid.word, DETAIL_WORDS[detail]] : [MODES[mode].word];
  return html`<details class="bending" ?open=${open}>
    <summary>
      <h3>Bending</h3>
      <span class="faint">${chosen.join(', ').toLowerCase()}</span>${icon('unfold')}
    </summary>
    <div class="segments" role="group" aria-label="Bending">
      ${modes.map((name) => segment(MODES[name].word, name === mode, model.readonly, () => dispatch({ type: 'pose-mode-chosen', mode: name })))}
    </div>
    <p class="faint">${MODES[mode].note}</p>
    ${
      mode === 'rigid'
        ? html`<h3>Detail</h3>
          <div class="segments" role="group" aria-label="Detail">
            ${details.map((name) =>
              segment(DETAIL_WORDS[name], name === detail, model.readonly, () =>
                dispatch({ type: 'detail-chosen', detail: name }),
              ),
            )}
          </div>`
        : toggle(
            'Keep widths',
            'Limbs do not shrink between two turns.',
            blendOf(project) === 'rigid',
            model,
            (on) => dispatch({ type: 'blend-chosen', blend: on ? 'rigid' : 'linear' }),
          )
    }
    ${ringsOf(project).length > 0 ? [lassoed(model, dispatch), filled(model, dispatch), feathered(model, dispatch)] : nothing}
    ${toggle('Hold the boundary', 'The outline stays as it is.', project.fix_boundary === true, model, (on) => dispatch({ type: 'boundary-switched', held: on }))}
    ${toggle('Edges where parts cross', 'A thin shadow keeps parts of one colour apart.', project.edges === true, model, (on) => dispatch({ type: 'edges-switched', on }))}
    ${looseParts(model, dispatch)}
    ${toggle('Stop at folds', 'Drags end before the picture turns over.', model.guarded, model, (on) => dispatch({ type: 'fold-guard-switched', on }))}
    ${toggle('Snap to guides', `The axis, other handles, a grid. ${modifier(model.platform)} suspends it.`, model.snapping, model, (on) => dispatch({ type: 'snapping-switched', on }))}
    ${
      model.pixelated === null
        ? nothing
        : toggle('Pixel art', 'No colours are mixed.', model.pixelated, model, (on) =>
            dispatch({ type: 'pixel-art-switched', on }),
          )
    }
    <button
      type="button"
      class="button all-settings"
      part="button"
      @click=${() => dispatch({ type: 'study-shown', page: 'settings' })}
    >
      All settings
    </button>
  </details>`;
}

/** The way back from a lasso to the whole picture. */
const lassoed = (model: EditorModel, dispatch: Dispatch): TemplateResult => html`<div class="switch">
  <span class="text">Selection<span class="faint">Only the part inside of the lasso bends.</span></span>
  <button
    type="button"
    class="button toggle"
    part="button"
    aria-label="Bend all of it"
    ?disabled=${model.readonly}
    @click=${() => dispatch({ type: 'lasso-removed' })}
  >
    All of it
  </button>
</div>`;

/** The background behind a lassoed part. */
const filled = (model: EditorModel, dispatch: Dispatch): TemplateResult =>
  toggle(
    'Fill the background',
    'Where the part moves away, its surroundings go on.',
    isFilled(model.document.project),
    model,
    (on) => dispatch({ type: 'fill-switched', on }),
  );

const FEATHER: FieldLook = {
  name: 'feather',
  label: 'Feather',
  unit: 'px',
  step: 1,
  digits: 1,
  least: 0,
  most: MOST_FEATHER,
  digitKeys: true,
  tip: `Width of the soft rim around what moves, from 0 to ${MOST_FEATHER} pixels`,
};

/** The soft rim of the part. While the boundary is held, nothing moves beyond it. */
function feathered(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { project } = model.document;
  const feather = featherOf(project);
  if (feather === null || project.fix_boundary === true) return nothing;
  const set = (change: NumberChange) => dispatch({ type: 'feather-set', change });
  return html`<div class="switch">
    <span class="text"><span class="faint">A soft rim for the moved part.</span></span>
    ${numberField(FEATHER, [feather], set, model, dispatch)}
  </div>`;
}

/** Shown while there are parts without a handle, or they follow. */
function looseParts(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { project } = model.document;
  const count = model.solved?.looseParts ?? 0;
  const follow = settingsOf(project).loose_parts === 'follow';
  if (project.handles.length === 0 || (count === 0 && !follow)) return nothing;
  const parts = count === 1 ? 'One part has' : `${count} parts have`;
  return toggle('Loose parts follow', `${parts} no handle.`, follow, model, (on) =>
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
