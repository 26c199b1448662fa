/** The keys of the keyboard in the timeline. */
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import { isField } from '../untyped';
import { refOf } from './box';
import { selectedRefs } from './tracks';

/** Handles a key, which the editor then ignores. */
export function onKey(event: KeyboardEvent, timeline: TimelineModel, dispatch: Dispatch): void {
  const target = event.target as HTMLElement;
  if (event.defaultPrevented || isField(target)) return;
  if (target instanceof HTMLSelectElement) {
    // Letters choose an option there.
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
    return;
  }
  const handled = ofClipboard(event, timeline, dispatch) || ofPlace(event, target, timeline, dispatch);
  if (handled) event.preventDefault();
}

function ofClipboard(event: KeyboardEvent, timeline: TimelineModel, dispatch: Dispatch): boolean {
  if (!event.ctrlKey && !event.metaKey) return false;
  switch (event.key.toLowerCase()) {
    case 'c':
      dispatch({ type: 'keys-copied' });
      return true;
    case 'v':
      dispatch({ type: 'keys-pasted' });
      return true;
    case 'a':
      dispatch({ type: 'keys-selected', keys: allRefs(timeline) });
      return true;
    default:
      return false;
  }
}

const allRefs = ({ rows }: TimelineModel) =>
  rows.flatMap(({ handle, keys }) => keys.map(({ time }) => ({ handle, time })));

function ofPlace(
  event: KeyboardEvent,
  target: HTMLElement,
  timeline: TimelineModel,
  dispatch: Dispatch,
): boolean {
  if (event.ctrlKey || event.metaKey) return false;
  const isKey = target.matches('.clip-key');
  if ((event.key === 'Delete' || event.key === 'Backspace') && timeline.selectedKeys > 0) {
    dispatch({ type: 'keys-removed' });
    return true;
  }
  if (event.key === 'm' && isKey) {
    dispatch({ type: 'keys-mirrored' });
    return true;
  }
  if (event.key === ' ' && (isKey || target.matches('.ruler'))) {
    dispatch({ type: 'command-run', command: 'play' });
    return true;
  }
  if (target.matches('.ruler, .timeline')) return movesPlayhead(event, timeline, dispatch);
  return isKey && (movesKeys(event, target, dispatch) || goesToKey(event, target, timeline, dispatch));
}

const STEPS: Readonly<Record<string, number>> = { ArrowLeft: -1, ArrowRight: 1 };

function movesPlayhead(event: KeyboardEvent, { clip }: TimelineModel, dispatch: Dispatch): boolean {
  const step = STEPS[event.key];
  if (step !== undefined) dispatch({ type: 'playhead-stepped', frames: step * (event.shiftKey ? 10 : 1) });
  else if (event.key === 'Home') dispatch({ type: 'playhead-moved', time: 0 });
  else if (event.key === 'End') dispatch({ type: 'playhead-moved', time: clip?.duration ?? 0 });
  else return false;
  return true;
}

/** Alt moves the selected keys. The focus follows. */
function movesKeys(event: KeyboardEvent, key: HTMLElement, dispatch: Dispatch): boolean {
  const step = STEPS[event.key];
  if (!event.altKey || step === undefined) return false;
  const row = key.closest('.key-row');
  dispatch({ type: 'keys-stepped', frames: step * (event.shiftKey ? 10 : 1) });
  // Once the row is rendered: a key that passes another one changes places with it.
  queueMicrotask(() => {
    if (!key.matches('[aria-pressed="true"]'))
      row?.querySelector<HTMLElement>('.clip-key[aria-pressed="true"]')?.focus();
  });
  return true;
}

/** Arrow keys go to the next key of the row, or to the nearest one of another row. With Shift they select both. */
function goesToKey(
  event: KeyboardEvent,
  from: HTMLElement,
  timeline: TimelineModel,
  dispatch: Dispatch,
): boolean {
  const to = event.key === 'Enter' || event.key === ' ' ? from : neighbour(event.key, from);
  if (!to) return event.key.startsWith('Arrow');
  const ref = refOf(to);
  dispatch({
    type: 'keys-selected',
    keys: event.shiftKey ? [...selectedRefs(timeline), ref] : [ref],
  });
  dispatch({ type: 'playhead-moved', time: ref.time });
  to.focus();
  return true;
}

function neighbour(key: string, from: HTMLElement): HTMLElement | null {
  const row = from.closest('.key-row');
  if (key === 'ArrowLeft' || key === 'ArrowRight') {
    const keys = [...(row?.querySelectorAll<HTMLElement>('.clip-key') ?? [])];
    return keys[keys.indexOf(from) + (key === 'ArrowLeft' ? -1 : 1)] ?? null;
  }
  if (key !== 'ArrowUp' && key !== 'ArrowDown') return null;
  const time = refOf(from).time;
  let other = sibling(row, key);
  while (other && !other.querySelector('.clip-key')) other = sibling(other, key);
  const keys = [...(other?.querySelectorAll<HTMLElement>('.clip-key') ?? [])];
  const apart = (one: HTMLElement) => Math.abs(refOf(one).time - time);
  return keys.sort((a, b) => apart(a) - apart(b))[0] ?? null;
}

const sibling = (row: Element | null, key: 'ArrowUp' | 'ArrowDown'): Element | null =>
  (key === 'ArrowUp' ? row?.previousElementSibling : row?.nextElementSibling) ?? null;
