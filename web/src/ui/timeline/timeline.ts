/** The timeline: the clips of the project below the stage. Loaded when it is first shown. */
import { html, type TemplateResult } from 'lit-html';
import type { Dispatch } from '../../editor/events';
import type { TimelineModel } from '../../editor/timeline_model';
import type { EditorModel } from '../../editor/view_model';
import type { TimelineView } from '../timeline_view';
import { clipBar } from './clip_bar';
import { firstClip } from './first_clip';
import { onKey } from './keys';
import { ruler } from './ruler';
import { timelineStyle } from './style';
import { trackRows } from './tracks';

function bar(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const { timeline } = model;
  if (!timeline) return html``;
  return html`<section
    class="timeline ${timeline.recording ? 'recording' : ''}"
    part="timeline"
    aria-label=${model.texts.timeline.title}
    data-control="timeline"
    tabindex="-1"
    @keydown=${(event: KeyboardEvent) => onKey(event, timeline, dispatch)}
  >
    ${clipBar(timeline, model, dispatch)}
    ${timeline.clip ? lanes(timeline, model, dispatch) : firstClip(model, dispatch)}
  </section>`;
}

/** The rows with the ruler above them. All of them scroll together. */
const lanes = (timeline: TimelineModel, model: EditorModel, dispatch: Dispatch): TemplateResult => {
  const { clip, zoom } = timeline;
  const width = zoom && clip ? `--_time-width: ${Math.round(clip.duration * zoom)}px` : '';
  return html`<div class="lanes" .style=${width}>
    ${ruler(timeline, model.texts.timeline, dispatch)} ${trackRows(timeline, model, dispatch)}
  </div>`;
};

export const timelineView: TimelineView = { styles: [timelineStyle], bar };
