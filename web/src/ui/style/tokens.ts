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
    /* A little darker than the surface. */
    --_ground: var(
      --c2-ground,
      light-dark(
        color-mix(in srgb, #37370f 5%, var(--_surface)),
        color-mix(in srgb, #000 28%, var(--_surface))
      )
    );
    --_checker: var(
      --c2-checker,
      light-dark(
        color-mix(in srgb, #212100 9%, var(--_surface)),
        color-mix(in srgb, #000 11%, var(--_surface))
      )
    );
    /* Marks on the picture are the same in light and dark: the handle colour with a casing. */
    --_handle: var(--c2-handle, #2558e8);
    --_casing: #fff;
    /* Meanings: mixed with the text, so that they contrast with any surface that it is read on. */
    --_farthest: color-mix(in srgb, #d93a8c 75%, var(--_text));
    --_nearest: color-mix(in srgb, #2b86dd 70%, var(--_text));
    --_virtual: color-mix(in srgb, #17a56a 75%, var(--_text));
    --_warning: color-mix(in srgb, #d07c00 68%, var(--_text));
    --_danger: color-mix(in srgb, #ea3a2e 68%, var(--_text));
    --_radius: var(--c2-radius, 10px);
    --_radius-control: calc(0.7 * var(--_radius));
    --_radius-item: calc(0.6 * var(--_radius));
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
