/** The editor's page: one element fills it, and opens the work of the last visit or else the sample. */
import './element';

const editor = document.querySelector('c2-warp');
const THEME = 'theme';

if (editor) {
  editor.theme = stored((storage) => storage.getItem(THEME));
  // The editor's theme switch sets the attribute.
  new MutationObserver(() => {
    const { theme } = editor;
    if (theme) stored((storage) => storage.setItem(THEME, theme));
  }).observe(editor, { attributeFilter: [THEME] });
  // Keys then work before the first click, and before the picture is open.
  editor.updateComplete.then(() => editor.focus({ preventScroll: true }));
}

/** Returns the result of `ask` on the browser's storage, or `null` if the browser refuses storage. */
function stored<T>(ask: (storage: Storage) => T): T | null {
  try {
    return ask(localStorage);
  } catch {
    return null;
  }
}
