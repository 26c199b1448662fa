/** The study card: in place of the panel, or a sheet above the tools on phones. */
import { css } from 'lit';
import { FROM_BOTTOM } from '../../editor/sizes';
import { lowPhone, phone } from '../style/layouts';
import { ORDER } from '../style/order';

export const studyStyle = css`
  .study {
    position: absolute;
    z-index: ${ORDER.panel};
    right: var(--_edge);
    top: var(--_edge);
    width: calc(var(--_right) - 2 * var(--_edge));
    max-height: calc(100% - 2 * var(--_edge));
    display: flex;
    flex-direction: column;
    animation: appear var(--_speed);
  }
  .study header {
    flex: none;
    display: flex;
    align-items: center;
    gap: 6px;
    padding: 6px 8px;
    border-bottom: 1px solid var(--_line);
  }
  .study header .segments {
    flex: 1;
    margin: 0;
  }
  .study .page {
    overflow: auto;
    padding: 12px 14px 14px;
    overscroll-behavior: contain;
  }
  .study .page:focus-visible {
    outline-offset: -3px;
    border-radius: var(--_radius);
  }
  .study h3 {
    font-size: 13px;
  }
  .study p {
    font-size: 12px;
  }
  .setting + .setting,
  .presets {
    margin-top: 12px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  .setting .control {
    display: flex;
    align-items: center;
    gap: 10px;
    margin: 6px 0;
  }
  .setting .segments {
    flex: 1;
    margin: 0;
  }
  .setting .field {
    flex: 1;
    max-width: 150px;
  }
  .setting .slider ~ .field {
    flex: none;
    width: 84px;
  }
  .slider {
    flex: 1;
    min-width: 0;
    height: var(--_control);
    margin: 0;
    accent-color: var(--_accent);
  }
  .presets {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }
  @container ${phone} {
    .study {
      left: var(--_edge);
      top: auto;
      bottom: ${FROM_BOTTOM.sheet}px;
      width: auto;
      max-height: 52%;
    }
  }
  @container ${lowPhone} {
    .study {
      left: var(--_left);
      bottom: var(--_edge);
      max-height: calc(100% - 2 * var(--_edge));
    }
  }
`;
