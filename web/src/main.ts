/** The editor's page: one element that fills it, opened on the sample or on what was left here last time. */
import './element';

const editor = document.querySelector('c2-warp');
const THEME = 'theme';

if (editor) {
  editor.theme = stored((storage) => storage.getItem(THEME));
  // The switch in the editor sets the attribute.
  new MutationObserver(() => {
    const { theme } = editor;
    if (theme) stored((storage) => storage.setItem(THEME, theme));
  }).observe(editor, { attributeFilter: [THEME] });
  // Keys work at once, before the first click.
  editor.addEventListener('ready', () => editor.focus({ preventScroll: true }), { once: true });
}

/** What the browser's storage has to say; nothing where the browser grants none. */
function stored<T>(ask: (storage: Storage) => T): T | null {
  try {
    return ask(localStorage);
  } catch {
    return null;
  }
}
