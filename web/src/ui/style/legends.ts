/** The legends of heat maps. */
import { css } from './css';

export const legendsStyle = css`
  .legend {
    display: flex;
    align-items: center;
    gap: 10px;
    padding: 7px 16px;
    font-size: 12px;
    white-space: nowrap;
    animation: appear var(--_speed);
  }
  .ramp {
    width: 120px;
    height: 10px;
    border-radius: calc(0.5 * var(--_radius));
    background-color: #b9b5b0;
  }
  /* The mark of one half, like the bold isoline. */
  .ramp.lined::before {
    content: '';
    display: block;
    width: 2px;
    height: 100%;
    margin: auto;
    background: #080d29d9;
  }
  /* The legend stays while something is selected. Without room beside the picture, the picture takes precedence. */
  @container shell (height < 440px) {
    .legend {
      display: none;
    }
  }
`;
