/** The card of tools: at the left, or at the bottom on phones, within the thumb's reach. */
import { css } from './css';
import { low, lowest, lowestPhone, lowPhone, phone, strip } from './layouts';
import { ORDER } from './order';

export const toolStripStyle = css`
  .tools {
    position: absolute;
    z-index: ${ORDER.tools};
    left: var(--_edge);
    top: var(--_edge);
    display: flex;
    flex-direction: column;
    gap: 2px;
    max-height: calc(100% - 2 * var(--_edge));
    padding: 4px;
  }
  .tools .button {
    width: 40px;
    height: 40px;
  }
  .sheet-switch {
    display: none;
  }
  /* Low: the tools have several columns. */
  @container ${low} {
    .tools {
      display: grid;
      grid-template-columns: auto auto;
    }
  }
  @container ${lowest} {
    .tools {
      grid-template-columns: auto auto auto;
    }
  }
  @container ${phone} {
    .tools {
      top: auto;
      left: 50%;
      bottom: 10px;
      translate: -50% 0;
      flex-direction: row;
      gap: 4px;
      max-width: calc(100% - 2 * var(--_edge));
    }
    .sheet-switch {
      display: block;
      margin-left: 2px;
      padding-left: 4px;
      border-left: 1px solid var(--_line);
    }
  }
  /* Low phones: the tools are at the left, in columns. */
  @container ${lowPhone} {
    .tools {
      left: var(--_edge);
      top: var(--_edge);
      bottom: auto;
      translate: none;
      display: grid;
      grid-template-columns: auto auto;
      gap: 2px;
      max-width: none;
      max-height: none;
    }
    .sheet-switch {
      margin: 0;
      padding: 0;
      border: 0;
    }
  }
  /* No room for the lens, which its card has too, nor for the hand: two fingers and the space bar pan. */
  @container ${low} {
    .tools :is([data-command='lens'], [data-command='hand']) {
      display: none;
    }
  }
  @container ${phone} {
    .tools :is([data-command='lens'], [data-command='hand']) {
      display: none;
    }
  }
  /* No room for a sixth tool and the settings, nor for the bar of the brush. */
  @container ${lowestPhone} {
    .tools [data-command='brush'] {
      display: none;
    }
  }
  /* An on-screen keyboard leaves a strip: the field takes all of it. */
  @container ${strip} {
    .tools:has(~ .panel .field :focus) {
      visibility: hidden;
    }
  }
`;
