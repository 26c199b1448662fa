/** The editor's page: one element fills it, and opens the work of the last visit or else the sample. */
import './element';

const editor = document.querySelector('c2-warp');
const THEME = 'theme';

/** Drawn for c2warp: see `web/scripts/draw-samples.mjs`. */
const SAMPLES = [
  'gingerbread',
  'octopus',
  'cactus',
  'cat',
  'giraffe',
  'snake',
  'robot',
  'salamander',
  'portrait',
].map((name) => ({
  name,
  src: `./samples/${name}.png`,
  project: `./samples/${name}.c2warp.json`,
}));

if (editor) {
  editor.samples = SAMPLES;
  // A link to the page can name a picture. Stored work then waits among the recent work.
  const asked = new URLSearchParams(location.search);
  const [src, project] = [asked.get('src'), asked.get('project')];
  if (src) {
    editor.removeAttribute('src');
    editor.removeAttribute('project');
    // The editor tells the person of a failure.
    editor.load(src, project, { notice: true }).catch(() => {});
  }
  const chosen = stored((storage) => storage.getItem(THEME));
  if (chosen) editor.setAttribute(THEME, chosen);
  // The editor's theme switch sets the attribute.
  new MutationObserver(() => {
    const { theme } = editor;
    if (theme) stored((storage) => storage.setItem(THEME, theme));
  }).observe(editor, { attributeFilter: [THEME] });
  editor.addEventListener('titlechange', ({ detail: { name, unsaved } }) => {
    // The hint is about the first sample.
    if (name !== `${SAMPLES[0]?.name}.png`) editor.removeAttribute('hint');
    document.title = name === null ? 'c2warp' : `${unsaved ? '• ' : ''}${name} – c2warp`;
  });
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
