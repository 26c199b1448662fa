/** Keys that a control uses itself. All other keys apply to the selection. */

const MOVES: readonly string[] = [
  'ArrowLeft',
  'ArrowRight',
  'ArrowUp',
  'ArrowDown',
  'Home',
  'End',
  'PageUp',
  'PageDown',
];

/** Not for text fields: they keep all their keys. */
export function usesKey(target: Element, { key, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  if (ctrlKey || metaKey) return false;
  // Letters choose an option, and Alt opens the list.
  if (target.matches('select')) return MOVES.includes(key) || key === 'Enter' || key.length === 1;
  return target.matches('input[type=range], [role=slider]') && !altKey && MOVES.includes(key);
}
