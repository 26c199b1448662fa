/** The editor's page: one element that fills it, opened on the sample or on what was left here last time. */
import './element';

const editor = document.querySelector('c2-warp');
const THEME = 'theme';

if (editor) {
  editor.theme = localStorage.getItem(THEME);
  // The switch in the editor sets the attribute.
  new MutationObserver(() => {
    if (editor.theme) localStorage.setItem(THEME, editor.theme);
  }).observe(editor, { attributeFilter: [THEME] });
  // Keys work at once, before the first click.
  editor.addEventListener('ready', () => editor.focus({ preventScroll: true }), { once: true });
}
