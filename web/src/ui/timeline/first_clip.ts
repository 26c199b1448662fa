/** The timeline of a project without clips: three that suit any handles, or one without keys. */
import { html, type TemplateResult } from 'lit-html';
import { CLIP_PRESETS, type ClipPreset } from '../../document/clip_presets';
import type { Dispatch } from '../../editor/events';
import type { EditorModel } from '../../editor/view_model';

export const firstClip = (
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => html`<div class="first-clip">
  <p>${model.texts.timeline.first}</p>
  <div class="clip-presets">
    ${CLIP_PRESETS.map((preset) => presetButton(preset, model, dispatch))}
    <button
      type="button"
      class="button worded"
      part="button"
      ?disabled=${model.readonly}
      @click=${() => dispatch({ type: 'clip-added', preset: null })}
    >
      ${model.texts.timeline.newClip}
    </button>
  </div>
</div>`;

const presetButton = (
  preset: ClipPreset,
  model: EditorModel,
  dispatch: Dispatch,
): TemplateResult => html`<button
  type="button"
  class="button worded preset"
  part="button"
  data-preset=${preset}
  data-tip=${model.texts.timeline.presetTips[preset]}
  ?disabled=${model.readonly || model.document.project.handles.length === 0}
  @click=${() => dispatch({ type: 'clip-added', preset })}
>
  ${model.texts.timeline.presets[preset]}
</button>`;
