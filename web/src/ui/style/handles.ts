/** The handles: a dot in the middle of a square touch target. */
import { css } from './css';

export const handlesStyle = css`
  .handles {
    position: absolute;
    inset: 0 auto auto 0;
    width: 0;
    height: 0;
  }
  .handle {
    position: absolute;
    left: 0;
    top: 0;
    width: var(--_finger);
    height: var(--_finger);
    margin: calc(var(--_finger) / -2) 0 0 calc(var(--_finger) / -2);
    padding: 0;
    border: 0;
    background: none;
    cursor: inherit;
    border-radius: 50%;
    will-change: transform;
  }
  .handle::before {
    content: '';
    position: absolute;
    inset: 14px;
    border-radius: 50%;
    background: var(--_casing);
    border: 3.5px solid var(--_handle);
    box-shadow:
      0 0 0 1.5px var(--_casing),
      0 1px 5px 1px #0007;
    transition: scale var(--_speed);
  }
  .handle:hover::before {
    scale: 1.14;
  }
  .handle[aria-pressed='true']::before {
    background: var(--_handle);
    border-width: 2.5px;
    border-color: var(--_casing);
    box-shadow:
      0 0 0 2px var(--_handle),
      0 1px 5px 2px #0006;
  }
  .handle:focus-visible {
    outline: none;
  }
  /* Behind another part of the picture: a dashed ring, through which that part shows. */
  .handle.behind::before,
  .handle.behind[aria-pressed='true']::before {
    border: 2px dashed var(--_handle);
    background: #fff4;
    box-shadow: 0 0 0 1px #fffa;
    opacity: 0.8;
  }
  .handle.behind[aria-pressed='true']::before {
    background: #fff9;
    opacity: 1;
  }
  /* Corners of bars and polygons are smaller than point handles, since there are more of them. */
  .handle.corner::before {
    inset: 16px;
    border-width: 2.5px;
  }
  .handle.corner.selected::before {
    inset: 15.5px;
    box-shadow: 0 1px 5px 1px #0008;
  }
  .handle.corner.in-hand::before {
    background: var(--_handle);
    border-color: var(--_casing);
    box-shadow:
      0 0 0 2px var(--_handle),
      0 1px 5px 2px #0006;
  }
  /* The middle of a bar or polygon only shows the focus: users drag the line itself. */
  .handle.middle-mark::before,
  .handle.middle-mark[aria-pressed='true']::before {
    inset: 18.5px;
    border: 0;
    background: var(--_casing);
    box-shadow: 0 0 0 1.5px var(--_handle);
  }
  .handle.middle-mark[aria-pressed='false']:not(:focus-visible)::before {
    opacity: 0;
  }
  /* The marks show the corners of the selection; its buttons show the focus only. */
  .ring-button {
    position: absolute;
    left: 0;
    top: 0;
    width: 22px;
    height: 22px;
    margin: -11px 0 0 -11px;
    padding: 0;
    border: 0;
    border-radius: 50%;
    background: none;
    cursor: inherit;
    pointer-events: none;
  }
  :host(.keyed) .ring-button:focus-visible {
    outline: 2px solid var(--_handle);
    outline-offset: -1px;
    box-shadow: inset 0 0 0 2px var(--_casing);
  }
  .handles.drawing {
    opacity: 0.45;
  }
  :host(.keyed) .handle:focus-visible::before {
    outline: 2px solid var(--_casing);
    outline-offset: 2px;
    box-shadow:
      0 0 0 2px var(--_handle),
      0 0 0 6px var(--_handle);
  }
  .inviting .handle::after {
    content: '';
    position: absolute;
    inset: 14px;
    border-radius: 50%;
    border: 2px solid var(--_casing);
    /* Users must be able to stop motion that lasts more than five seconds (WCAG 2.2.2). */
    animation: invite 1.8s ease-out 2 forwards;
  }
  @keyframes invite {
    from {
      opacity: 0.9;
    }
    70%,
    to {
      scale: 2.6;
      opacity: 0;
    }
  }
  @media (pointer: coarse) {
    .handle::before {
      inset: 12px;
    }
    .handle.corner::before,
    .handle.corner.selected::before {
      inset: 14px;
    }
  }
`;
