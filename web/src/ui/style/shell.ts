/** The shell: bars above and below, the picture between them, and the space of the cards at its sides. */

import { PANEL, STUDY, TOOLS } from '../../editor/sizes';
import { css } from './css';
import { low, lowest, lowPhone, narrow, phone } from './layouts';

export const shellStyle = css`
  .shell {
    container: shell / size;
    /* Keeps the stacking order inside the editor, so that a page header can lie over all of it. */
    isolation: isolate;
    position: absolute;
    inset: 0;
    /* Signs of shifts along a line. */
    --_way: 1;
    writing-mode: horizontal-tb;
    display: flex;
    flex-direction: column;
  }
  .shell[dir='rtl'] {
    --_way: -1;
  }
  /* Arrows along a line. */
  .shell[dir='rtl'] :is([data-command='undo'], [data-command='redo'], .player .button:not(:first-child)) .icon {
    scale: -1 1;
  }
  /* Numbers with their units, and texts of another direction. */
  .shell[dir='rtl'] :is(span, output, dd, td) {
    unicode-bidi: plaintext;
  }
  /* Places, numbers and times go from left to right in all languages. */
  .stage,
  .figure,
  .field,
  .time,
  .code textarea {
    direction: ltr;
  }
  /* The width of the cards at the start and end, and the space between a card and the edge. Floating parts are centred
     in the remaining width. */
  .middle {
    --_start: ${TOOLS.wide}px;
    --_end: ${PANEL.wide}px;
    --_edge: 12px;
    position: relative;
    flex: 1;
    min-height: 0;
  }
  .top,
  .status {
    flex: none;
    display: flex;
    align-items: center;
    background: var(--_surface);
    padding: 0 8px;
  }
  @container ${narrow} {
    .middle {
      --_start: ${TOOLS.narrow}px;
      --_end: ${PANEL.narrow}px;
    }
  }
  /* Low: the tools have two or four columns. */
  @container ${low} {
    .middle {
      --_start: ${TOOLS.low.fine}px;
      --_end: ${PANEL.narrow}px;
    }
  }
  @container ${lowest} {
    .middle {
      --_start: ${TOOLS.lowest.fine}px;
    }
  }
  .middle.studying {
    --_end: ${STUDY.wide}px;
  }
  .middle.on-compare {
    --_end: max(${STUDY.wide}px, 50%);
  }
  /* Phones have no cards at the sides. Low phones have the tools there. */
  @container ${phone} {
    .middle,
    .middle.studying {
      --_start: 0px;
      --_end: 0px;
      --_edge: 8px;
    }
  }
  @container ${lowPhone} {
    .middle {
      --_start: ${TOOLS.lowPhone.fine}px;
    }
  }
`;
