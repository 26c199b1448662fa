/** The bar of the timeline: playing, the clips, the settings of the open one, and its selected keys. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { CLIP_PRESETS } from '../../document/clip_presets';
import { DURATIONS } from '../../document/clips';
import type { Clip, Ease, Loop } from '../../document/project';
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import { RATES, type Rate } from '../../editor/timeline_state';
import { EASE_NAMES, LOOP_NAMES, PRESET_NAMES } from '../../editor/timeline_texts';
import type { EditorModel } from '../../editor/view_model';
import { commandButton } from '../command_button';
import { type IconName, icon } from '../icons';
import { nameInput } from '../name_input';
import { numberField } from '../number_field';

export function clipBar(timeline: TimelineModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { clip } = timeline;
  const small = button(dispatch);
  return html`<div class="clip-bar" role="group" aria-label="Clips">
    ${clip ? clipTools(clip, timeline, model, dispatch) : html`<strong>Timeline</strong>`}
    <span class="gap"></span>
    ${
      clip
        ? html`<span class="view-tools">
            ${toggle('Onion skin: show the neighbouring keys faintly', 'onion', timeline.onion, (on) => dispatch({ type: 'onion-switched', on }))}
            ${small('Zoom out', 'minus', { type: 'timeline-zoomed', notches: -1 })}
            ${small('Fit the clip', 'fit', { type: 'timeline-zoomed', notches: 0 })}
            ${small('Zoom in', 'plus', { type: 'timeline-zoomed', notches: 1 })}
          </span>`
        : nothing
    }
    <span class="closer">
      ${small('Close the timeline', 'close', { type: 'timeline-opened', open: false })}
    </span>
  </div>`;
}

function clipTools(
  clip: Clip,
  timeline: TimelineModel,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const small = button(dispatch);
  const { playing, recordHeld, recording, selectedKeys: count } = timeline;
  const none = count === 0;
  return html`
    ${commandButton('play', model, dispatch, { label: playing ? 'Stop' : 'Play', icon: playing ? 'pause' : 'play' })}
    ${toggle('Record: hold R and drag a handle, or press this first', 'record', recordHeld || recording, (on) => dispatch({ type: 'record-held', held: on }), 'Record')}
    <span class="clip-name">
      ${timeline.renaming ? nameField(clip, dispatch) : clipChoice(timeline, clip, dispatch)}
      ${small('Rename the clip', 'rename', { type: 'clip-renaming-switched', on: true })}
      ${small('Duplicate the clip', 'copy', { type: 'clip-duplicated' })}
      ${small('Delete the clip', 'remove', { type: 'clip-removed' })}
    </span>
    ${choice('Loop', clip.loop ?? 'repeat', LOOP_NAMES, (loop) => dispatch({ type: 'clip-loop-chosen', loop: loop as Loop }))}
    ${durationField(clip, model, dispatch)}
    ${choice(
      'Frames a second',
      String(timeline.rate),
      Object.fromEntries(RATES.map((rate) => [String(rate), `${rate} fps`])),
      (rate) => dispatch({ type: 'frame-rate-chosen', rate: Number(rate) as Rate }),
    )}
    <span class="of-keys" role="group" aria-label="Keys">
      ${commandButton('set-key', model, dispatch)}
      ${choice(
        'Way to the next key',
        timeline.ease ?? '',
        { ...(timeline.ease ? {} : { '': 'Ease' }), ...EASE_NAMES },
        (ease) => ease !== '' && dispatch({ type: 'keys-eased', ease: ease as Ease }),
        none,
      )}
      ${small('Copy the keys', 'copy', { type: 'keys-copied' }, none)}
      ${small('Paste keys at the playhead', 'paste', { type: 'keys-pasted' }, !timeline.canPaste)}
      ${small('Mirror the keys to the other side', 'mirror', { type: 'keys-mirrored' }, none)}
      ${small('Delete the keys', 'remove', { type: 'keys-removed' }, none)}
    </span>`;
}

/** Makes buttons with an icon that dispatch an event. */
const button =
  (dispatch: Dispatch) =>
  (label: string, name: IconName, event: Parameters<Dispatch>[0], disabled = false): TemplateResult =>
    html`<button
    type="button"
    class="button"
    part="button"
    data-tip=${label}
    aria-label=${label}
    ?disabled=${disabled}
    @click=${() => dispatch(event)}
  >
    ${icon(name)}
  </button>`;

const toggle = (
  label: string,
  name: IconName,
  on: boolean,
  set: (on: boolean) => void,
  word = '',
): TemplateResult => html`<button
  type="button"
  class="button ${name} ${word ? 'worded' : ''}"
  part="button"
  data-tip=${label}
  aria-label=${label}
  aria-pressed=${String(on)}
  @click=${() => set(!on)}
>
  ${icon(name)}${word ? html`<span class="word">${word}</span>` : nothing}
</button>`;

function choice(
  label: string,
  chosen: string,
  options: Readonly<Record<string, string>>,
  choose: (value: string) => void,
  disabled = false,
): TemplateResult {
  return html`<select
    class="choice"
    aria-label=${label}
    title=${label}
    ?disabled=${disabled}
    .value=${live(chosen)}
    @change=${(event: Event) => {
      event.stopPropagation();
      choose((event.target as HTMLSelectElement).value);
    }}
  >
    ${Object.entries(options).map(
      ([value, word]) => html`<option value=${value} ?selected=${value === chosen}>${word}</option>`,
    )}
  </select>`;
}

/** The clips, and at the end of the list those that can be added. */
function clipChoice({ clips }: TimelineModel, clip: Clip, dispatch: Dispatch): TemplateResult {
  const choose = (event: Event) => {
    event.stopPropagation();
    const select = event.target as HTMLSelectElement;
    const [kind, value = ''] = [select.value.slice(0, 1), select.value.slice(1)];
    if (kind === '=') dispatch({ type: 'clip-chosen', name: value });
    else dispatch({ type: 'clip-added', preset: CLIP_PRESETS.find((preset) => preset === value) ?? null });
  };
  return html`<select class="choice" aria-label="Clip" title="Clip" .value=${live(`=${clip.name}`)} @change=${choose}>
    ${clips.map((name) => html`<option value="=${name}" ?selected=${name === clip.name}>${name}</option>`)}
    <optgroup label="Add">
      ${CLIP_PRESETS.map((preset) => html`<option value="+${preset}">${PRESET_NAMES[preset]}</option>`)}
      <option value="+">New clip</option>
    </optgroup>
  </select>`;
}

const nameField = (clip: Clip, dispatch: Dispatch): TemplateResult =>
  nameInput({
    control: 'clip-name',
    label: 'Name of the clip',
    name: clip.name,
    given: (name) => dispatch({ type: 'clip-named', name }),
    ended: () => dispatch({ type: 'clip-renaming-switched', on: false }),
  });

const durationField = (clip: Clip, model: EditorModel, dispatch: Dispatch): TemplateResult =>
  numberField(
    {
      name: 'duration',
      label: 'Duration',
      unit: 's',
      step: 0.1,
      digits: 2,
      least: DURATIONS.least,
      most: DURATIONS.most,
      digitKeys: true,
    },
    [clip.duration],
    (change) => dispatch({ type: 'clip-duration-set', change }),
    model,
    dispatch,
  );
