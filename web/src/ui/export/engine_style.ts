/** The page of the export panel for game engines. */
import { css } from '../style/css';

export const engineStyle = css`
  .export .engine-formats .segment {
    flex-basis: 40%;
  }
  .export .engine-fields {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 6px 0 10px;
  }
  .export .engine-fields > :last-child {
    grid-column: 1 / -1;
  }
  .export .engine-loss {
    width: 100%;
    margin: 8px 0 0;
    border-collapse: collapse;
    font-size: 12px;
    font-variant-numeric: tabular-nums;
  }
  .export .engine-loss caption {
    margin: 0 2px 4px;
    color: var(--_faint);
    text-align: start;
  }
  .export .engine-loss :is(th, td) {
    padding: 3px 2px;
    font-weight: 400;
    text-align: end;
  }
  .export .engine-loss [scope='row'] {
    text-align: start;
    overflow-wrap: anywhere;
  }
  .export .engine-loss [scope='col'] {
    color: var(--_faint);
  }
  .export .engine-loss tbody tr {
    border-top: 1px solid var(--_line);
  }
`;
