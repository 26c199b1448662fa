/** The shell: bars above and below, the picture between them, and the room that the cards at its sides take. */
import { css } from 'lit';
import { low, lowest, lowPhone, narrow, phone } from './layouts';
import { PANEL, TOOLS } from './sizes';

export const shellStyle = css`
  .shell {
    container: shell / size;
    /* What lies over what in here is no matter of the page: its own header may lie over all of it. */
    isolation: isolate;
    position: absolute;
    inset: 0;
    writing-mode: horizontal-tb;
    display: flex;
    flex-direction: column;
  }
  /* What the cards take of the width at the left and at the right: what floats over the picture stands in the middle of
     the rest. And the space between a card and the edge. */
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
  /* Low: the tools stand side by side, in two columns or three. */
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
  /* A phone: no card at the sides; tools again where it is low. */
  @container ${phone} {
    .middle {
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
