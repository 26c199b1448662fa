/** The film page of the export panel. */
import { css } from 'lit';

export const filmStyle = css`
  .export .formats .segments {
    display: grid;
    grid-template-columns: repeat(4, 1fr);
  }
  .export .film-fields {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 6px 0;
  }
  .export .option select {
    flex: 1;
    min-width: 0;
    height: var(--_control);
    padding: 0 6px;
    border: 1px solid transparent;
    border-bottom-color: var(--_bound);
    border-radius: var(--_radius-control);
    background: var(--_raised);
    color: inherit;
    font: inherit;
    font-size: 13px;
  }
  .export .film-refusal {
    margin: 8px 2px;
    color: var(--_danger);
    font-size: 12px;
  }
  .export .formats .segment:disabled {
    opacity: 0.45;
  }
  @media (pointer: coarse) {
    .export .option select {
      height: var(--_finger);
      font-size: 16px;
    }
  }
`;
