/** The language of an element as HTML has it: that of the nearest ancestor with an attribute `lang`. */

/** The nearest element with a language, through shadow roots; empty without one. */
export function inheritedLanguage(node: Element): string {
  for (let at: Element | null = node; at; at = parentOf(at)) {
    const tag = at.getAttribute('lang');
    if (tag !== null) return tag;
  }
  return '';
}

const parentOf = (node: Element): Element | null => {
  const { parentNode } = node;
  return parentNode instanceof ShadowRoot ? parentNode.host : node.parentElement;
};

/** Calls `changed` whenever an attribute `lang` changes on the way to the root, until the signal is aborted. */
export function followLanguage(node: Element, changed: () => void, signal: AbortSignal): void {
  const observer = new MutationObserver(changed);
  let at: Node | null = node;
  while (at) {
    const root: Node = at.getRootNode();
    observer.observe(root, { subtree: true, attributes: true, attributeFilter: ['lang'] });
    at = root instanceof ShadowRoot ? root.host : null;
  }
  signal.addEventListener('abort', () => observer.disconnect());
}
