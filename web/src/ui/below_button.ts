/** The place of a menu below its button. */

/** Room between a menu and its button, and between it and the window's edge, CSS pixels. */
const GAP = 6;

/** Places a popover below its button, as it opens and after. In the top layer, coordinates are those of the window. */
export function placeBelowButton(event: Event): void {
  const popover = event.currentTarget as HTMLElement;
  const button = popover.previousElementSibling;
  if (!button) return;
  const { left, right, bottom } = button.getBoundingClientRect();
  // Before the menu is shown, only the style sheet gives its width.
  const width =
    popover.offsetWidth || Number.parseFloat(getComputedStyle(popover).getPropertyValue('--_width'));
  const start = getComputedStyle(popover).direction === 'rtl' ? right - width : left;
  popover.style.left = `${Math.max(GAP, Math.min(start, innerWidth - width - GAP))}px`;
  popover.style.top = `${bottom + GAP}px`;
}
