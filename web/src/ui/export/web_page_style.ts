/** The page of the export panel for web pages. */
import { css } from '../style/css';

export const webPageStyle = css`
  .export .code {
    display: block;
    margin-bottom: 6px;
    font-size: 12px;
    font-weight: 600;
  }
  .export textarea {
    display: block;
    width: 100%;
    margin-top: 6px;
    padding: 8px;
    box-sizing: border-box;
    border: 1px solid var(--_bound);
    border-radius: var(--_radius-item);
    background: none;
    color: inherit;
    font: 11px / 1.45 ui-monospace, monospace;
    overflow-wrap: anywhere;
    resize: none;
    field-sizing: content;
  }
`;
