/** Constructed style sheets: elements of a document share one, and another document needs its own. */

const SHEETS = new WeakMap<readonly string[], WeakMap<Document, CSSStyleSheet>>();

/** Applies style sheets to a shadow root, in cascade order. */
export function dress(root: ShadowRoot, styles: readonly string[]): void {
  const { ownerDocument } = root;
  // A document without a window shows nothing.
  const view = ownerDocument.defaultView;
  if (!view) return;
  const sheets = SHEETS.get(styles) ?? new WeakMap<Document, CSSStyleSheet>();
  SHEETS.set(styles, sheets);
  let sheet = sheets.get(ownerDocument);
  if (!sheet) {
    sheet = new view.CSSStyleSheet();
    sheet.replaceSync(styles.join('\n'));
    sheets.set(ownerDocument, sheet);
  }
  root.adoptedStyleSheets = [sheet];
}
