/** The film page of the export panel. */
import { css } from '../style/css';

export const filmStyle = css`
  .export .formats .segment {
    flex-basis: 22%;
  }
  .export .film-fields {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 6px 0;
  }
  .export .option .choice {
    flex: 1;
    min-width: 0;
  }
  .export .film-refusal {
    margin: 8px 2px;
    color: var(--_danger);
    font-size: 12px;
  }
  .export .formats .segment:disabled {
    opacity: 0.45;
  }
`;
