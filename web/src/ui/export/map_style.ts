/** The page of the export panel for maps. */
import { css } from '../style/css';

export const mapStyle = css`
  .export .map-kinds .segment {
    flex-basis: 30%;
  }
  .export .map-file {
    display: block;
    white-space: normal;
    overflow-wrap: anywhere;
  }
`;
