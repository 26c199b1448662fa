/**
 * Styles for forced colours, which remove backgrounds and shadows.
 *
 * Selected items and pressed buttons take the system's highlight colours. Pictures are not recoloured, so the handles
 * on them keep their own colours.
 */
import { css } from './css';

export const forcedStyle = css`
  @media (forced-colors: active) {
    .marks,
    .ramp,
    .handles {
      forced-color-adjust: none;
    }
    .button:is([aria-pressed='true'], .on),
    .button[aria-pressed='mixed'],
    .button.toggle[aria-pressed='true'],
    .button.segment[aria-pressed='true'],
    .button.finish:not(:disabled),
    .status .creased [aria-pressed='true'],
    .item[aria-pressed='true'],
    .entry:focus:not([aria-disabled]) {
      forced-color-adjust: none;
      background: Highlight;
      color: HighlightText;
    }
    .button[aria-pressed='true']:disabled {
      background: Highlight;
      color: HighlightText;
    }
    .button[aria-pressed='mixed'] {
      background: ButtonFace;
      color: ButtonText;
      outline: 1px dashed Highlight;
    }
    .item[aria-pressed='true'] .dot {
      border-color: HighlightText;
      background: HighlightText;
    }
    .item .moved {
      background: CanvasText;
    }
    .item[aria-pressed='true'] .moved {
      background: HighlightText;
    }
    .segments,
    .hint,
    .primary {
      border: 1px solid ButtonText;
    }
    .entry[aria-disabled],
    .entry .why,
    .button:disabled:not([aria-pressed='true']),
    .link:disabled {
      opacity: 1;
      color: GrayText;
    }
    .switch [role='switch'] {
      forced-color-adjust: none;
      background: ButtonFace;
      border: 1px solid ButtonText;
    }
    .switch [role='switch']::before {
      inset-block: 1px;
      inset-inline: 1px auto;
      background: ButtonText;
      box-shadow: none;
    }
    .switch [role='switch']:checked {
      background: Highlight;
      border-color: Highlight;
    }
    .switch [role='switch']:checked::before {
      background: HighlightText;
    }
    .bar::before {
      forced-color-adjust: none;
      background: Highlight;
    }
    [data-tip]::after {
      border: 1px solid CanvasText;
    }
    .bubble::before {
      display: none;
    }
    :focus-visible,
    .stage:focus-visible::after {
      outline-color: Highlight;
    }
    .button:is([aria-pressed='true'], .on):focus-visible,
    .item[aria-pressed='true']:focus-visible {
      outline-color: CanvasText;
    }
  }
`;
