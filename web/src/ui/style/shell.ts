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
    writing-mode: horizontal-tb;
    display: flex;
    flex-direction: column;
  }
  /* The width of the cards at the left and right, and the space between a card and the edge. Floating parts are centred
     in the remaining width. */
  .middle {
    --_left: ${TOOLS.wide}px;
    --_right: ${PANEL.wide}px;
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
      --_left: ${TOOLS.narrow}px;
      --_right: ${PANEL.narrow}px;
    }
  }
  /* Low: the tools have two or three columns. */
  @container ${low} {
    .middle {
      --_left: ${TOOLS.low}px;
      --_right: ${PANEL.narrow}px;
    }
  }
  @container ${lowest} {
    .middle {
      --_left: ${TOOLS.lowest}px;
    }
  }
  .middle.studying {
    --_right: ${STUDY.wide}px;
  }
  .middle.on-compare {
    --_right: max(${STUDY.wide}px, 50%);
  }
  /* Phones have no cards at the sides. Low phones have the tools there. */
  @container ${phone} {
    .middle,
    .middle.studying {
      --_left: 0px;
      --_right: 0px;
      --_edge: 8px;
    }
  }
  @container ${lowPhone} {
    .middle {
      --_left: ${TOOLS.lowPhone.fine}px;
    }
  }
`;
