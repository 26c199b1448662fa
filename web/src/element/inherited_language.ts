/** The language and the direction of an element, as in HTML: those of the nearest ancestor that sets them. */

/** The tag of the language; empty without one. */
export const inheritedLanguage = (node: Element): string => inherited(node, 'lang') ?? '';

export function isFromRight(node: Element): boolean {
  const direction = inherited(node, 'dir')?.toLowerCase();
  return direction === 'auto' ? getComputedStyle(node).direction === 'rtl' : direction === 'rtl';
}

/** The attribute of the nearest element that has it, across shadow roots. */
function inherited(node: Element, attribute: 'lang' | 'dir'): string | null {
  for (let at: Element | null = node; at; at = parentOf(at)) {
    const value = at.getAttribute(attribute);
    if (value !== null) return value;
  }
  return null;
}

const parentOf = (node: Element): Element | null => {
  const { parentNode } = node;
  return parentNode instanceof ShadowRoot ? parentNode.host : node.parentElement;
};

/** Calls `changed` when an attribute `lang` or `dir` changes in a tree of the element, until the signal is aborted. */
export function followLanguage(node: Element, changed: () => void, signal: AbortSignal): void {
  const observer = new MutationObserver(changed);
  let at: Node | null = node;
  while (at) {
    const root: Node = at.getRootNode();
    observer.observe(root, { subtree: true, attributes: true, attributeFilter: ['lang', 'dir'] });
    at = root instanceof ShadowRoot ? root.host : null;
  }
  signal.addEventListener('abort', () => observer.disconnect());
}
