/** The page of the export panel for maps. */
import { css } from '../style/css';

export const mapStyle = css`
  .export .map-kinds .segments {
    display: grid;
    grid-template-columns: repeat(3, 1fr);
  }
  .export .map-file {
    display: block;
    white-space: normal;
    overflow-wrap: anywhere;
  }
`;
