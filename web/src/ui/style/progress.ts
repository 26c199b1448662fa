/** Progress: the moving line and the spinner. */
import { css } from './css';
import { phone } from './layouts';
import { ORDER } from './order';

export const progressStyle = css`
  .bar {
    position: absolute;
    z-index: ${ORDER.progress};
    inset: 0 0 auto;
    height: 3px;
    overflow: hidden;
  }
  .bar::before {
    content: '';
    position: absolute;
    inset: 0;
    width: 35%;
    background: var(--_accent);
    animation: run 1.1s ease-in-out infinite;
  }
  .bar.known::before {
    width: var(--_done);
    animation: none;
    transition: width var(--_speed);
  }
  .task {
    flex: 1;
    font-variant-numeric: tabular-nums;
  }
  .solved .task {
    flex: none;
  }
  /* A short export needs no card. */
  .export-card {
    display: none;
    animation: appear var(--_speed) 0.4s backwards;
  }
  @container ${phone} {
    .export-card {
      display: flex;
    }
  }
  @keyframes run {
    from {
      translate: -100% 0;
    }
    to {
      translate: 300% 0;
    }
  }
  .spinner {
    width: 12px;
    height: 12px;
    border: 2px solid var(--_line);
    border-top-color: var(--_accent);
    border-radius: 50%;
    animation: spin 0.8s linear infinite;
  }
  @keyframes spin {
    to {
      rotate: 1turn;
    }
  }
`;
