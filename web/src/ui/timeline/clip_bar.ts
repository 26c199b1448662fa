/** The bar of the timeline: playing, the clips, the settings of the open one, and its selected keys. */

import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { CLIP_PRESETS } from '../../document/clip_presets';
import { DURATIONS } from '../../document/clips';
import type { Clip, Ease, Loop } from '../../document/project';
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import { RATES, type Rate } from '../../editor/timeline_state';
import type { EditorModel } from '../../editor/view_model';
import { shownName } from '../../texts/shown_name';
import type { Texts } from '../../texts/texts';
import { commandButton } from '../command_button';
import { type IconName, icon } from '../icons';
import { nameInput } from '../name_input';
import { numberField } from '../number_field';

/** The commands of the selected keys. */
const OF_KEYS = ['copy-keys', 'paste-keys', 'mirror-keys', 'remove-keys'] as const;

export function clipBar(timeline: TimelineModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { clip } = timeline;
  const { timeline: words } = model.texts;
  const small = button(dispatch);
  return html`<div class="clip-bar" role="group" aria-label=${words.clips}>
    ${clip ? clipTools(clip, timeline, model, dispatch) : html`<strong>${words.title}</strong>`}
    <span class="gap"></span>
    ${
      clip
        ? html`<span class="view-tools">
            ${toggle(words.onion, 'onion', timeline.onion, (on) => dispatch({ type: 'onion-switched', on }))}
            ${small(words.zoomOut, 'minus', { type: 'timeline-zoomed', notches: -1 })}
            ${small(words.fit, 'fit', { type: 'timeline-zoomed', notches: 0 })}
            ${small(words.zoomIn, 'plus', { type: 'timeline-zoomed', notches: 1 })}
          </span>`
        : nothing
    }
    <span class="closer">
      ${small(words.close, 'close', { type: 'timeline-opened', open: false })}
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
  const { playing, recordHeld, recording } = timeline;
  const { timeline: words } = model.texts;
  return html`
    ${commandButton('play', model, dispatch, { label: playing ? words.stop : words.play, icon: playing ? 'pause' : 'play' })}
    ${toggle(words.recordTip, 'record', recordHeld || recording, (on) => dispatch({ type: 'record-held', held: on }), words.record)}
    <span class="clip-name">
      ${timeline.renaming ? nameField(clip, words, dispatch) : clipChoice(timeline, clip, words, dispatch)}
      ${small(words.rename, 'rename', { type: 'clip-renaming-switched', on: true })}
      ${small(words.duplicate, 'copy', { type: 'clip-duplicated' })}
      ${small(words.delete, 'remove', { type: 'clip-removed' })}
    </span>
    ${choice(words.loop, clip.loop ?? 'repeat', words.loops, (loop) => dispatch({ type: 'clip-loop-chosen', loop: loop as Loop }))}
    ${durationField(clip, model, dispatch)}
    ${choice(
      words.framesASecond,
      String(timeline.rate),
      Object.fromEntries(RATES.map((rate) => [String(rate), `${rate} fps`])),
      (rate) => dispatch({ type: 'frame-rate-chosen', rate: Number(rate) as Rate }),
    )}
    <span class="of-keys" role="group" aria-label=${words.keys}>
      ${commandButton('set-key', model, dispatch)}
      ${choice(
        words.easeTip,
        timeline.ease ?? '',
        { ...(timeline.ease ? {} : { '': words.ease }), ...words.eases },
        (ease) => ease !== '' && dispatch({ type: 'keys-eased', ease: ease as Ease }),
        timeline.lead === null,
      )}
      ${OF_KEYS.map((name) => commandButton(name, model, dispatch))}
    </span>`;
}

/** Makes buttons with an icon that dispatch an event. */
const button =
  (dispatch: Dispatch) =>
  (label: string, name: IconName, event: Parameters<Dispatch>[0]): TemplateResult =>
    html`<button
    type="button"
    class="button"
    part="button"
    data-tip=${label}
    aria-label=${label}
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
function clipChoice(
  { clips }: TimelineModel,
  clip: Clip,
  words: Texts['timeline'],
  dispatch: Dispatch,
): TemplateResult {
  const choose = (event: Event) => {
    event.stopPropagation();
    const select = event.target as HTMLSelectElement;
    const [kind, value = ''] = [select.value.slice(0, 1), select.value.slice(1)];
    if (kind === '=') dispatch({ type: 'clip-chosen', name: value });
    else dispatch({ type: 'clip-added', preset: CLIP_PRESETS.find((preset) => preset === value) ?? null });
  };
  return html`<select class="choice" aria-label=${words.clip} title=${words.clip} .value=${live(`=${clip.name}`)} @change=${choose}>
    ${clips.map((name) => html`<option value="=${name}" ?selected=${name === clip.name}>${shownName(name)}</option>`)}
    <optgroup label=${words.add}>
      ${CLIP_PRESETS.map((preset) => html`<option value="+${preset}">${words.presets[preset]}</option>`)}
      <option value="+">${words.newClip}</option>
    </optgroup>
  </select>`;
}

function nameField(clip: Clip, words: Texts['timeline'], dispatch: Dispatch): TemplateResult {
  const shown = shownName(clip.name);
  return nameInput({
    control: 'clip-name',
    label: words.nameOfClip,
    name: shown,
    // Without a change, the name is kept.
    given: (name) => dispatch({ type: 'clip-named', name: name === shown ? clip.name : name }),
    ended: () => dispatch({ type: 'clip-renaming-switched', on: false }),
  });
}

const durationField = (clip: Clip, model: EditorModel, dispatch: Dispatch): TemplateResult =>
  numberField(
    {
      name: 'duration',
      label: model.texts.timeline.duration,
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
