/** The ruler: seconds of the clip, and the playhead. */

import { html, type TemplateResult } from 'lit-html';
import type { Clip } from '../../document/project';
import type { Dispatch } from '../../editor/events';
import { secondsText } from '../../editor/seconds';
import type { TimelineModel } from '../../editor/timeline_model';
import type { Texts } from '../../texts/texts';
import { follow } from './gestures';
import { at, labelStep, timeAt } from './scale';

export function ruler(timeline: TimelineModel, words: Texts['timeline'], dispatch: Dispatch): TemplateResult {
  const { clip, time } = timeline;
  if (!clip) return html``;
  const go = (event: PointerEvent) => {
    const lane = (event.currentTarget as Element).querySelector('.time');
    if (lane) dispatch({ type: 'playhead-moved', time: timeAt(lane, clip, event.clientX) });
  };
  return html`<div class="ruler-row">
    <output class="now" aria-label=${words.playhead}>${secondsText(time)}</output>
    <div
      class="ruler"
      role="slider"
      tabindex="0"
      data-key-place="ruler"
      aria-label=${words.playhead}
      aria-valuemin="0"
      aria-valuemax=${clip.duration}
      aria-valuenow=${Number(time.toFixed(3))}
      aria-valuetext=${secondsText(time)}
      @pointerdown=${(event: PointerEvent) => {
        if (event.button > 0) return;
        go(event);
        follow(event, { moved: go, ended: () => {} });
      }}
    >
      <div class="time">
        ${labels(clip, timeline.zoom)}
        <i class="playhead" .style=${at(clip, time)}></i>
      </div>
    </div>
  </div>`;
}

function labels(clip: Clip, zoom: number | null): readonly TemplateResult[] {
  const step = labelStep(clip, zoom);
  const count = Math.floor(clip.duration / step + 1e-6) + 1;
  return Array.from({ length: count }, (_, k) => {
    const seconds = k * step;
    return html`<span class="second" .style=${at(clip, seconds)}>${Number(seconds.toFixed(2))}</span>`;
  });
}
