/** A bar, polygon or lasso being drawn: its corners, the line to the pointer, and its buttons. */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import { CORNERS_NEEDED, isClosed } from '../document/handle';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';
import { distance } from '../geometry/vec';
import { isDrawable } from '../tools/drafting';
import { dots, onStage } from './dots';
import { edgeSwitch } from './edge_switch';
import { icon } from './icons';

export function draftMarks({ draft, camera, stage }: EditorModel): SVGTemplateResult | typeof nothing {
  if (!draft) return nothing;
  const set = draft.corners.map((corner) => toStage(camera, corner));
  const path = (draft.path ?? []).map((place) => toStage(camera, place));
  const next = draft.next && !draft.finishing ? toStage(camera, draft.next) : null;
  const ahead = next ? [...path, next] : path;
  const all = [...set, ...ahead];
  const [first] = set;
  const last = set.at(-1);
  const targets = isDrawable(draft) ? [...(isClosed(draft.kind) ? [0] : []), set.length - 1] : [];
  const at = draft.next && toStage(camera, draft.next);
  const away = (k: number) => (at && set[k] ? distance(set[k], at) : Number.POSITIVE_INFINITY);
  const hot = draft.finishing ? targets.reduce((best, k) => (away(k) < away(best) ? k : best), -1) : -1;
  return svg`<g class="draft">
    ${isClosed(draft.kind) && all.length > 2 ? svg`<path class="body" d="M${all.join('L')}Z"/>` : nothing}
    <path class="line under" d="M${set.join('L')}"/><path class="line" d="M${set.join('L')}"/>
    ${
      ahead.length > 0 && last
        ? svg`<path class="line under" d="M${[last, ...ahead].join('L')}"/>
            ${dots('line next', onStage([last, ...ahead], false, stage))}`
        : nothing
    }
    ${
      isClosed(draft.kind) && first && all.length > 2
        ? dots('line closing', onStage([all.at(-1) ?? first, first], false, stage))
        : nothing
    }
    ${set.map(([x, y], k) => {
      const target = targets.includes(k);
      // A lasso along edges has many corners.
      if (draft.kind === 'lasso' && !target) return nothing;
      return svg`<circle class="corner ${target ? 'target' : ''} ${k === hot ? 'hot' : ''}"
        cx=${x} cy=${y} r=${target ? 6 : 4.5}/>`;
    })}
  </g>`;
}

/** The next thing to do, with buttons for people without an Enter key. */
export function draftBar(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { draft, texts } = model;
  if (!draft) return nothing;
  const ready = isDrawable(draft);
  const missing = CORNERS_NEEDED[draft.kind] - draft.corners.length;
  const words = ready
    ? texts.drawing.ready
    : missing === 1
      ? texts.drawing.oneMore
      : texts.drawing.more(missing);
  return html`<div class="draft-bar card" part="notice" role="group" aria-label=${texts.drawing.label}>
    <span class="words">${words}</span>
    ${draft.kind === 'lasso' ? edgeSwitch(model, dispatch) : nothing}
    ${button('undo', texts.drawing.takeBack, '⌫', () => dispatch({ type: 'corner-taken-back' }))}
    ${button('close', texts.drawing.giveUp, texts.keys.names.escape, () => dispatch({ type: 'command-run', command: 'bail' }))}
    <button type="button" class="button finish" part="button" data-tip=${texts.drawing.finish} data-keys="↵"
      ?disabled=${!ready} @click=${() => dispatch({ type: 'drawing-finished' })}>${icon('done')}${texts.drawing.finish}</button>
  </div>`;
}

const button = (name: 'undo' | 'close', label: string, keys: string, act: () => void): TemplateResult =>
  html`<button type="button" class="button" part="button" data-tip=${label} data-keys=${keys} aria-label=${label}
    @click=${act}>${icon(name)}</button>`;
