/**
 * Colour schemes, and private properties for all sheets: colours, shapes, speed.
 *
 * Pages restyle the editor through the `--c2-*` properties. The sheets read the names with an underscore.
 */
import { css } from './css';

export const tokensStyle = css`
  :host {
    color-scheme: light dark;
    --_accent: var(--c2-accent, light-dark(#2558e8, #7ea2ff));
    --_on-accent: light-dark(#fff, #0c1430);
    --_surface: var(--c2-surface, light-dark(#fff, #232427));
    --_text: var(--c2-text, light-dark(#1e1f22, #ececea));
    /* Mixed from the two above, so that they follow a page that sets those. */
    --_raised: color-mix(in srgb, var(--_text) 6.5%, var(--_surface));
    --_line: color-mix(in srgb, var(--_text) 12%, var(--_surface));
    --_faint: color-mix(in srgb, var(--_text) 66%, var(--_surface));
    /* The boundary of controls: contrast 3:1 to the surface (WCAG 1.4.11). */
    --_bound: color-mix(in srgb, var(--_text) 53%, var(--_surface));
    --_ground: var(--c2-ground, light-dark(#f5f5f3, #191a1c));
    --_checker: var(--c2-checker, light-dark(#ebebe8, #1f2023));
    /* Marks on the picture are the same in light and dark: the handle colour with a casing. */
    --_handle: var(--c2-handle, #2558e8);
    --_casing: #fff;
    /* Tooltips and hints. */
    --_inverse: light-dark(#26272b, #ececea);
    --_on-inverse: light-dark(#fff, #1e1f22);
    --_warning: light-dark(#9a5b00, #f0b45a);
    --_danger: light-dark(#b3261e, #ff8f85);
    --_radius: var(--c2-radius, 10px);
    --_radius-control: 7px;
    --_radius-item: 6px;
    /* Heights of controls for mouse and touch. */
    --_control: 34px;
    --_finger: 44px;
    --_shadow: 0 1px 2px light-dark(#0000000f, #0006), 0 6px 24px light-dark(#00000014, #0007);
    --_speed: 140ms;
  }
  :host([theme='light']) {
    color-scheme: light;
  }
  :host([theme='dark']) {
    color-scheme: dark;
  }
  @media (prefers-contrast: more) {
    :host {
      --_line: var(--_bound);
      --_faint: color-mix(in srgb, var(--_text) 90%, var(--_surface));
      --_bound: color-mix(in srgb, var(--_text) 75%, var(--_surface));
    }
  }
  @media (prefers-reduced-motion: reduce) {
    :host {
      --_speed: 0s;
    }
  }
`;
