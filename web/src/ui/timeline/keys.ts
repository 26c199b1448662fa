/** The keys of the ruler, and of a focused key. All others are those of the editor. */
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import { isField } from '../untyped';
import { refOf } from './box';

/** Handles a key, which the editor then ignores. */
export function onKey(event: KeyboardEvent, timeline: TimelineModel, dispatch: Dispatch): void {
  const target = event.target as HTMLElement;
  if (event.defaultPrevented || isField(target)) return;
  if (ofTimeline(event, target, timeline, dispatch)) event.preventDefault();
}

function ofTimeline(
  event: KeyboardEvent,
  target: HTMLElement,
  timeline: TimelineModel,
  dispatch: Dispatch,
): boolean {
  const { key, ctrlKey, metaKey, altKey } = event;
  if (ctrlKey || metaKey) {
    if (key.toLowerCase() !== 'a') return false;
    dispatch({ type: 'command-run', command: 'select-all-keys' });
    return true;
  }
  const isKey = target.matches('.clip-key');
  if (key === ' ' && (isKey || target.matches('.ruler'))) {
    dispatch({ type: 'command-run', command: 'play' });
    return true;
  }
  if (key === 'Enter' && isKey) {
    const ref = refOf(target);
    dispatch({ type: 'keys-selected', keys: [ref] });
    dispatch({ type: 'playhead-moved', time: ref.time });
    return true;
  }
  return target.matches('.ruler') && !altKey && movesPlayhead(event, timeline, dispatch);
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
