/** The shell: bars above and below, the picture between them, and the room that the cards at its sides take. */
import { css } from 'lit';

export const shellStyle = css`
  .shell {
    container: shell / size;
    position: absolute;
    inset: 0;
    writing-mode: horizontal-tb;
    display: flex;
    flex-direction: column;
    outline: none;
  }
  /* What the cards at both sides take of the width: what floats over the picture stands in the middle of the rest. */
  .middle {
    --_left: 84px;
    --_right: 260px;
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
  @container shell (width < 900px) {
    .middle {
      --_left: 72px;
      --_right: 248px;
    }
  }
  /* Low: the tools stand side by side, in two columns or three. */
  @container shell (width >= 640px) and (height < 372px) {
    .middle {
      --_left: 134px;
    }
  }
  @container shell (width >= 640px) and (height < 290px) {
    .middle {
      --_left: 182px;
    }
  }
  /* A phone: no card at the sides; tools again where it is low. */
  @container shell (width < 640px) {
    .middle {
      --_left: 0px;
      --_right: 0px;
    }
  }
  @container shell (width < 640px) and (height < 372px) {
    .middle {
      --_left: 108px;
    }
  }
`;
