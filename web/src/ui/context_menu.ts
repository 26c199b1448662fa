/** The context menu of the selected handles, of a corner, or of a place of the picture. */
import { html, nothing, type TemplateResult } from 'lit-html';
import { selectedHandles } from '../document/document';
import { isLine } from '../document/handle';
import { ariaKeys, type CommandName, keyHint } from '../editor/commands';
import type { Dispatch } from '../editor/events';
import type { MenuState } from '../editor/menu_state';
import type { EditorModel } from '../editor/view_model';
import { beside } from '../geometry/beside';
import type { Vec } from '../geometry/vec';
import { icon, iconOf } from './icons';

type Groups = readonly (readonly CommandName[])[];

const ofPicture = (lasso: readonly CommandName[]): Groups => [
  ['add-point', 'paste'],
  lasso,
  ['select-all', 'reset-all', 'suggest'],
  ['fit'],
];
const OF_POSABLE: Groups = [
  ['reset', 'reset-all'],
  ['undo', 'redo'],
];
const ofHandles = (corners: readonly CommandName[]): Groups => [
  ['reset', 'mirror'],
  ['copy', 'paste'],
  ['forward', 'backward'],
  corners,
  ['rename', 'remove'],
];

export function contextMenu(model: EditorModel, dispatch: Dispatch): TemplateResult | typeof nothing {
  const { menu, press } = model;
  if (!menu) return nothing;
  const groups = groupsOf(menu, model).filter((names) => names.length > 0);
  return html`<div
    class="popover card context ${press}"
    part="menu"
    popover="manual"
    role="menu"
    tabindex="-1"
    aria-label=${model.worded(menu.name)}
    @keydown=${(event: KeyboardEvent) => onKey(event, dispatch)}
    @contextmenu=${(event: Event) => event.preventDefault()}
    @pointerleave=${({ currentTarget }: Event) => (currentTarget as HTMLElement).focus({ preventScroll: true })}
  >
    ${groups.map(
      (names, k) =>
        html`${k > 0 ? html`<hr />` : nothing}${names.map((name) => entry(name, model, dispatch))}`,
    )}
  </div>`;
}

function groupsOf({ about, corner }: MenuState, { posable, document, reasonAgainst }: EditorModel): Groups {
  if (posable) return OF_POSABLE;
  if (about === 'picture') return ofPicture(reasonAgainst('turn-part') === null ? ['turn-part'] : []);
  if (corner) return ofHandles(['add-corner', 'remove-corner']);
  const selected = selectedHandles(document);
  return ofHandles(selected.length === 1 && selected.some(isLine) ? ['add-corner'] : []);
}

/** An entry. A disabled one says why, and can have the focus, so that screen readers read it. */
function entry(name: CommandName, model: EditorModel, dispatch: Dispatch): TemplateResult {
  const reason = model.reasonAgainst(name);
  const possible = reason === null;
  return html`<div
    class="entry"
    role="menuitem"
    tabindex="-1"
    data-command=${name}
    aria-disabled=${possible ? nothing : 'true'}
    aria-description=${reason ?? nothing}
    aria-keyshortcuts=${ariaKeys(name, model.platform) || nothing}
    @click=${() => possible && dispatch({ type: 'menu-command-run', command: name })}
    @pointermove=${({ currentTarget }: Event) => (currentTarget as HTMLElement).focus({ preventScroll: true })}
  >
    ${icon(iconOf(name))}<span>${model.texts.commands[name]} ${possible ? nothing : html`<span class="why" aria-hidden="true">${reason}</span>`}</span>
    <kbd aria-hidden="true">${keyHint(name, model.platform, model.texts)}</kbd>
  </div>`;
}

const entriesOf = (menu: Element): readonly HTMLElement[] => [
  ...menu.querySelectorAll<HTMLElement>('.entry'),
];

function onKey(event: KeyboardEvent, dispatch: Dispatch): void {
  const { key } = event;
  const entries = entriesOf(event.currentTarget as Element);
  const now = entries.indexOf(event.target as HTMLElement);
  const modified = event.ctrlKey || event.metaKey || event.altKey;
  // These keys continue from the element that had the focus before.
  if (key === 'Tab' || (modified && key.length === 1)) {
    dispatch({ type: 'menu-command-run', command: null });
    return;
  }
  if (key === 'Escape') dispatch({ type: 'menu-command-run', command: null });
  else if (key === 'Enter' || key === ' ') entries[now]?.click();
  else {
    const goal = reached(key, now, entries);
    if (!goal) return;
    goal.focus();
  }
  event.preventDefault();
}

/** The entry that a key leads to: up and down in a circle, or the next one with the typed initial. */
function reached(key: string, now: number, entries: readonly HTMLElement[]): HTMLElement | undefined {
  if (key === 'ArrowDown') return entries[(now + 1) % entries.length];
  if (key === 'ArrowUp') return entries.at(Math.max(now, 0) - 1);
  if (key === 'Home') return entries[0];
  if (key === 'End') return entries.at(-1);
  const begins = (entry: HTMLElement) =>
    key.length === 1 && entry.textContent?.trim().toLowerCase().startsWith(key.toLowerCase());
  return [...entries.slice(now + 1), ...entries.slice(0, now + 1)].find(begins);
}

/** Room between the menu and the edges, CSS pixels. */
const EDGE = 4;

/**
 * Shows a menu beside a place in the window: within the element if there is room, and always within the viewport.
 *
 * @param gap between the place and the menu, CSS pixels.
 * @param first focuses the first entry instead of the menu.
 */
export function showMenu(menu: HTMLElement, [x, y]: Vec, gap: number, first: boolean): void {
  menu.togglePopover(true);
  const { offsetWidth, offsetHeight } = menu;
  const { offsetLeft = 0, offsetTop = 0, width = innerWidth, height = innerHeight } = visualViewport ?? {};
  const frame = (menu.getRootNode() as ShadowRoot).host.getBoundingClientRect();
  const bounds = (size: number, seen: Vec, own: Vec): Vec => {
    const both: Vec = [Math.max(seen[0], own[0]) + EDGE, Math.min(seen[1], own[1]) - EDGE];
    return both[1] - both[0] >= size ? both : [seen[0] + EDGE, seen[1] - EDGE];
  };
  const across = bounds(offsetWidth, [offsetLeft, offsetLeft + width], [frame.left, frame.right]);
  const down = bounds(offsetHeight, [offsetTop, offsetTop + height], [frame.top, frame.bottom]);
  menu.style.left = `${beside(x, gap, offsetWidth, across)}px`;
  menu.style.top = `${beside(y, gap, offsetHeight, down)}px`;
  ((first && entriesOf(menu)[0]) || menu).focus({ preventScroll: true });
}
