/** Elements with properties and children. */

export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  properties: Partial<HTMLElementTagNameMap[K]> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** A symbol with an index, as r_d. */
export const symbol = (name: string, index: string): HTMLElement =>
  element('i', {}, name, element('sub', {}, index));
