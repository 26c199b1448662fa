/** The panel: a card at the end of a line, or a sheet above the tools on phones. */

import { FROM_BOTTOM, LOW, SHEET } from '../../editor/sizes';
import { css } from './css';
import { lowPhone, phone, strip } from './layouts';
import { ORDER } from './order';

export const panelStyle = css`
  slot[name='panel']::slotted(*) {
    margin-block-start: 10px;
  }
  .panel {
    position: absolute;
    z-index: ${ORDER.panel};
    inset-inline-end: var(--_edge);
    top: var(--_edge);
    width: 224px;
    max-height: calc(100% - 2 * var(--_edge));
    display: flex;
    flex-direction: column;
    overflow: auto;
    padding: 12px;
  }
  .panel > * {
    flex: none;
  }
  .unfold {
    display: none;
  }
  h2 {
    font-size: 14px;
    font-weight: 650;
    overflow-wrap: anywhere;
  }
  h2::first-letter {
    text-transform: uppercase;
  }
  h2.name {
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  button.name {
    display: flex;
    align-items: center;
    gap: 6px;
    max-width: calc(100% + 12px);
    margin: -4px -6px;
    padding: 4px 6px;
    border: 0;
    border-radius: var(--_radius-item);
    background: none;
    color: inherit;
    font: inherit;
    cursor: text;
  }
  button.name span {
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  button.name span::first-letter {
    text-transform: uppercase;
  }
  button.name .icon {
    width: 15px;
    height: 15px;
    color: var(--_faint);
    opacity: 0;
  }
  button.name:is(:hover, :focus-visible) {
    background: var(--_raised);
  }
  button.name:is(:hover, :focus-visible) .icon {
    opacity: 1;
  }
  @media (hover: none) {
    button.name .icon {
      opacity: 1;
    }
  }
  .naming {
    min-width: 0;
    margin: -7px -8px -6px;
  }
  .naming .field input {
    font-size: 14px;
    font-weight: 650;
    text-align: start;
  }
  .naming .field:has([aria-invalid='true']) {
    border-color: var(--_danger);
  }
  .fault {
    margin: 4px 8px 0;
    color: var(--_danger);
    font-size: 12px;
  }
  h3 {
    font-size: 12px;
    font-weight: 600;
  }
  .row {
    display: flex;
    align-items: center;
    justify-content: flex-end;
    gap: 2px;
    margin: 0 -4px;
    padding-inline-start: 4px;
  }
  .row .faint {
    flex: 1;
    font-size: 12px;
  }
  .overlays .row {
    margin-top: -5px;
  }
  .overlays h3 {
    flex: 1;
  }
  .checks {
    display: grid;
    grid-template-columns: auto auto;
    margin: 0 -8px;
    font-size: 12px;
  }
  .overlays + :is(.properties, .bending),
  .properties + :is(.bending, .list),
  .bending + .list {
    margin-top: 10px;
    padding-top: 12px;
    border-top: 1px solid var(--_line);
  }
  @container ${phone} {
    .unfold {
      display: inline-flex;
    }
    .panel:not(.numbers) .unfold .icon {
      rotate: 180deg;
    }
    .panel {
      display: none;
      top: auto;
      inset-inline-start: var(--_edge);
      bottom: ${FROM_BOTTOM.sheet}px;
      width: auto;
      max-height: 46%;
      padding: 6px 10px 10px;
    }
    .panel.open {
      display: block;
    }
    /* Three columns where they fit, so that the sheet shows all overlays at once. */
    .checks {
      grid-template-columns: repeat(auto-fill, minmax(118px, 1fr));
    }
    /* One line. Its tooltips extend beyond it. */
    .panel:not(.numbers, .settings, .overlaid) {
      overflow: visible;
    }
    .panel:is(.settings, .overlaid) {
      max-height: min(${SHEET.share}%, ${SHEET.tall}px);
    }
    .panel.high {
      top: var(--_edge);
      bottom: auto;
    }
    .panel.away {
      opacity: 0;
      pointer-events: none;
      transition: opacity var(--_speed) 100ms;
    }
    .panel .list,
    .panel:is(.settings, .overlaid) .properties,
    .panel:not(.numbers) :is(.fields, .corners),
    .panel:not(.settings) .bending {
      display: none;
    }
    .panel:is(.settings, .overlaid) .bending {
      margin: 0;
      padding: 0;
      border: 0;
    }
    .properties {
      display: grid;
      grid-template: 'name corners row' auto 'fields fields fields' auto / 1fr auto auto;
      align-items: center;
    }
    .numbers .properties:has(.of-corner) {
      grid-template:
        'name name row' auto 'fields fields fields' auto
        'corners corners corners' auto 'of-corner of-corner of-corner' auto / 1fr auto auto;
    }
    h2 {
      min-width: 0;
    }
    .naming {
      margin-block: 0;
      margin-inline: 0 6px;
    }
    .fault {
      margin: 2px 6px;
    }
    .row {
      grid-area: row;
      margin-inline-start: 0;
      padding: 0;
    }
    .row .faint {
      display: none;
    }
    .row.corners {
      grid-area: corners;
      margin: 0;
    }
    .properties:has(.of-corner) .corners .faint {
      display: block;
    }
  }
  /* Beside five buttons, the name fits in small type only. */
  @container shell (width < 360px) {
    .numbers .properties:has(.corners) h2 {
      font-size: 12px;
    }
  }
  /* Low: beside the tools. */
  @container ${lowPhone} {
    .panel {
      inset-inline-start: var(--_start);
      bottom: var(--_edge);
      max-height: calc(100% - 2 * var(--_edge));
    }
  }
  @container shell (width < 400px) and (height < ${LOW.phone}px) {
    .panel {
      z-index: ${ORDER.panelOverTools};
      inset-inline-start: var(--_edge);
    }
    .tools:has(:focus-visible) ~ .panel {
      z-index: ${ORDER.panel};
    }
  }
  /* An on-screen keyboard leaves a strip: the field takes all of it. */
  @container ${strip} {
    .panel:has(.field :focus) {
      top: auto;
      bottom: var(--_edge);
      max-height: calc(100% - 2 * var(--_edge));
    }
  }
`;
