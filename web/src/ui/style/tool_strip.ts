/** The card of tools: at the start of a line, or at the bottom on phones, within the thumb's reach. */
import { css } from './css';
import { low, lowest, lowestPhone, lowPhone, phone, strip } from './layouts';
import { ORDER } from './order';

export const toolStripStyle = css`
  .tools {
    position: absolute;
    z-index: ${ORDER.tools};
    inset-inline-start: var(--_edge);
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
      grid-template-columns: repeat(4, auto);
    }
  }
  @container ${phone} {
    .tools {
      top: auto;
      inset-inline-start: 50%;
      bottom: 10px;
      translate: calc(-50% * var(--_way)) 0;
      flex-direction: row;
      gap: 4px;
      max-width: calc(100% - 2 * var(--_edge));
    }
    .sheet-switch {
      display: block;
      margin-inline-start: 2px;
      padding-inline-start: 4px;
      border-inline-start: 1px solid var(--_line);
    }
  }
  /* Low phones: the tools are at the start, in columns. */
  @container ${lowPhone} {
    .tools {
      inset-inline-start: var(--_edge);
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
  /* The menu has the lens and the hand. Two fingers and the space bar pan, too. */
  @container ${phone} {
    .tools :is([data-command='lens'], [data-command='hand']) {
      display: none;
    }
  }
  /* No room for a sixth tool and the settings. The menu has the brush. */
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
