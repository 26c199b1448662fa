/** A row for each handle, with its keys as diamonds. */
import { html, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { isSameKey, type KeyRef } from '../../document/clip_keys';
import type { Clip } from '../../document/project';
import type { Dispatch } from '../../editor/events';
import { secondsText } from '../../editor/seconds';
import type { TimelineKey, TimelineModel, TimelineRow } from '../../editor/timeline_model';
import type { EditorModel } from '../../editor/view_model';
import { isKeyed } from '../handle_buttons';
import { boxSelection } from './box';
import { follow } from './gestures';
import { at, secondsPerPixel } from './scale';

/** A press that moves less is a click, CSS pixels. */
const SLIP = 3;

export function trackRows(timeline: TimelineModel, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { clip, rows } = timeline;
  if (!clip) return html``;
  const entry = entryOf(timeline);
  return html`<div
    class="tracks"
    role="group"
    aria-label=${model.texts.timeline.keys}
    @pointerdown=${(event: PointerEvent) => boxSelection(event, timeline, dispatch)}
  >
    ${repeat(
      rows,
      ({ handle }) => handle,
      (row) => trackRow(row, entry, clip, timeline, model, dispatch),
    )}
  </div>`;
}

function trackRow(
  row: TimelineRow,
  entry: KeyRef | null,
  clip: Clip,
  timeline: TimelineModel,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const name = model.worded(row.name);
  return html`<div class="key-row ${row.selected ? 'selected' : ''}" role="group" aria-label=${name}>
    <button
      type="button"
      class="track-name"
      aria-pressed=${String(row.selected)}
      @click=${(event: MouseEvent) =>
        dispatch(
          event.shiftKey
            ? { type: 'handle-toggled', id: row.handle }
            : { type: 'handles-selected', ids: [row.handle] },
        )}
    >
      ${name}
    </button>
    <div class="lane">
      <div class="time">
        ${row.keys.map((key) => keyButton(key, entry, row, clip, timeline, model, dispatch))}
        <i class="playhead" .style=${at(clip, timeline.time)}></i>
      </div>
    </div>
  </div>`;
}

/** @param entry Tab comes to this key. Arrow keys go to the others. */
function keyButton(
  key: TimelineKey,
  entry: KeyRef | null,
  row: TimelineRow,
  clip: Clip,
  timeline: TimelineModel,
  { texts, worded }: EditorModel,
  dispatch: Dispatch,
): TemplateResult {
  const ref: KeyRef = { handle: row.handle, time: key.time };
  const label = texts.timeline.key[key.ease](worded(row.name), secondsText(key.shown));
  return html`<button
    type="button"
    class="clip-key ${key.ease}"
    data-key-of=${row.handle}
    data-time=${key.time}
    tabindex=${entry && isSameKey(entry, ref) ? 0 : -1}
    .style=${at(clip, key.shown)}
    aria-label=${label}
    aria-pressed=${String(key.selected)}
    title=${label}
    @focus=${(event: FocusEvent) => focused(event, ref, key, dispatch)}
    @pointerdown=${(event: PointerEvent) => press(event, ref, key, clip, timeline, dispatch)}
    @dblclick=${() => dispatch({ type: 'playhead-moved', time: key.time })}
  ></button>`;
}

/** The key that Tab comes to: the one that arrows go from, or else the first of all. */
function entryOf({ rows, lead }: TimelineModel): KeyRef | null {
  const [first] = rows.flatMap(({ handle, keys }) => keys.map(({ time }) => ({ handle, time })));
  return lead ?? first ?? null;
}

export const selectedRefs = ({ rows }: TimelineModel): readonly KeyRef[] =>
  rows.flatMap(({ handle, keys }) =>
    keys.filter(({ selected }) => selected).map(({ time }) => ({ handle, time })),
  );

/** As with handles, keyboard focus selects a key. */
function focused({ target }: FocusEvent, ref: KeyRef, { selected }: TimelineKey, dispatch: Dispatch): void {
  const keyed = target instanceof Element && target.matches(':focus-visible') && isKeyed(target);
  if (keyed && !selected) dispatch({ type: 'keys-selected', keys: [ref] });
}

/** Selects the pressed key, with Shift besides the others, and drags the selected ones. */
function press(
  event: PointerEvent,
  ref: KeyRef,
  key: TimelineKey,
  clip: Clip,
  timeline: TimelineModel,
  dispatch: Dispatch,
): void {
  if (event.button > 0) return;
  event.stopPropagation();
  const before = selectedRefs(timeline);
  const others = before.filter(({ handle, time }) => handle !== ref.handle || time !== ref.time);
  const adds = event.shiftKey || event.ctrlKey || event.metaKey;
  if (adds) dispatch({ type: 'keys-selected', keys: key.selected ? others : [...before, ref] });
  else if (!key.selected) dispatch({ type: 'keys-selected', keys: [ref] });
  const button = event.currentTarget as HTMLElement;
  button.focus();
  const scale = secondsPerPixel(button.parentElement ?? button, clip);
  const from = event.clientX;
  let dragged = false;
  const by = (now: PointerEvent) => (now.clientX - from) * scale;
  follow(event, {
    moved: (now) => {
      dragged ||= Math.abs(now.clientX - from) > SLIP;
      if (dragged) dispatch({ type: 'keys-dragged', by: by(now), ended: false });
    },
    ended: (now, cancelled) => {
      if (dragged && cancelled) dispatch({ type: 'keys-drag-cancelled' });
      else if (dragged) dispatch({ type: 'keys-dragged', by: by(now), ended: true });
      else if (!adds) {
        dispatch({ type: 'keys-selected', keys: [ref] });
        dispatch({ type: 'playhead-moved', time: ref.time });
      }
    },
  });
}
