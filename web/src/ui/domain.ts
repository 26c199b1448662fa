/**
 * The drawn domain on the original: its rings with their corners, and a veil over the rest. Each corner has a focusable
 * button for keyboards and screen readers. Pointer presses go to the stage.
 */
import { html, nothing, type SVGTemplateResult, svg, type TemplateResult } from 'lit-html';
import { ringsOf } from '../document/domain';
import type { Dispatch } from '../editor/events';
import type { EditorModel } from '../editor/view_model';
import { toStage } from '../geometry/camera';

export function domainMarks(model: EditorModel): SVGTemplateResult | typeof nothing {
  const { document, picture, camera, draft } = model;
  const rings = ringsOf(document.project);
  if (!picture || rings.length === 0) return nothing;
  const path = rings.map((ring) => `M${ring.map((corner) => toStage(camera, corner)).join('L')}Z`).join('');
  const [left, top] = toStage(camera, [0, 0]);
  const [right, bottom] = toStage(camera, [picture.width, picture.height]);
  const all = `M${left},${top}H${right}V${bottom}H${left}Z`;
  return svg`<g class="domain">
    <path class="veil" fill-rule="evenodd" d="${all}${path}"/>
    <path class="pale" d=${path}/><path class="dashes" d=${path}/>
    ${draft ? nothing : cornerMarks(model)}
  </g>`;
}

const cornerMarks = ({ document, camera, ringCorner }: EditorModel): readonly SVGTemplateResult[] =>
  ringsOf(document.project).flatMap((ring, k) =>
    ring.map((corner, index) => {
      const [x, y] = toStage(camera, corner);
      const inHand = ringCorner?.ring === k && ringCorner.index === index;
      return svg`<circle class="ring-corner ${inHand ? 'in-hand' : ''}" cx=${x} cy=${y} r=${inHand ? 5.5 : 3.5}/>`;
    }),
  );

/** The buttons of the corners. */
export function ringButtons(model: EditorModel, dispatch: Dispatch): TemplateResult {
  const rings = ringsOf(model.document.project);
  const { stage: texts } = model.texts;
  return html`<div class="handles" role="group" aria-label=${texts.selectionCorners}>
    ${rings.flatMap((ring, k) =>
      ring.map((corner, index) => {
        const [x, y] = toStage(model.camera, corner);
        const [left = 0, top = 0] = corner.map(Math.round);
        const part = rings.length > 1 ? k + 1 : null;
        return html`<button
          type="button"
          class="ring-button"
          part="handle"
          data-ring=${k}
          data-ring-corner=${index}
          aria-label=${texts.selectionCorner(index + 1, part, left, top)}
          aria-description=${texts.selectionCornerKeys}
          .style=${`transform: translate(${x}px, ${y}px)`}
          @focus=${({ target }: FocusEvent) => {
            if (target instanceof Element && target.matches(':focus-visible'))
              dispatch({ type: 'place-revealed', at: corner });
          }}
        ></button>`;
      }),
    )}
  </div>`;
}
