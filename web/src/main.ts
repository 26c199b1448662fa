/** The editor's page: one element fills it, and opens the work of the last visit or else the sample. */
import { isShare, receiveFiles } from './app/given_files';
import { markLanguage } from './app/page_language';
import { startNewest, storeVersions } from './app/versions';
import { nameIn } from './editor/address';
import { C2Warp, type Sample, type Texts } from './element';
import { languageFor } from './element/languages';
import { trusted } from './start_worker';
import { en } from './texts/en';

const editor = document.querySelector('c2-warp');
const THEME = 'theme';
/** Beside index.html, see `web/scripts/service_worker.mjs`. */
const WORKER = './service-worker.js';
/** Of the toolbar, which an installed editor's title bar adjoins. */
const THEME_COLOURS = { light: '#ffffff', dark: '#232427' };

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
] as const;

/** The samples by their names in a language. */
const samplesIn = ({ page }: Texts): readonly Sample[] =>
  SAMPLES.map((file) => ({
    name: page.samples[file],
    src: `./samples/${file}.png`,
    project: `./samples/${file}.c2warp.json`,
  }));

const tag = markLanguage(C2Warp.languages);

if (editor) {
  editor.samples = samplesIn(en);
  // A picture that opens closes the notices before it.
  const ready = new Promise((resolve) => editor.addEventListener('ready', resolve, { once: true }));
  // A link to the page can name a picture. Anybody can make one: stored work stays until the person agrees.
  const asked = new URLSearchParams(location.search);
  const [src, project] = [asked.get('src'), asked.get('project')];
  if (src || isShare()) {
    editor.removeAttribute('src');
    editor.removeAttribute('project');
  }
  if (src) ready.then(() => editor.offer({ name: nameIn(src), src, ...(project && { project }) }));
  // The editor's theme switch sets the attribute.
  new MutationObserver(() => {
    const { theme } = editor;
    if (theme !== 'light' && theme !== 'dark') return;
    stored((storage) => storage.setItem(THEME, theme));
    for (const meta of document.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]'))
      meta.content = THEME_COLOURS[theme];
  }).observe(editor, { attributeFilter: [THEME] });
  const chosen = stored((storage) => storage.getItem(THEME));
  if (chosen) editor.setAttribute(THEME, chosen);
  editor.addEventListener('titlechange', ({ detail: { name, unsaved } }) => {
    // The hint is about the first sample.
    if (name !== `${SAMPLES[0]}.png`) editor.removeAttribute('hint');
    document.title = name === null ? 'c2warp' : `${unsaved ? '• ' : ''}${name} – c2warp`;
  });
  // Keys then work before the first click, and before the picture is open.
  editor.updateComplete.then(() => editor.focus({ preventScroll: true }));
  // The element reports languages that do not load.
  languageFor(tag, () => {}).then(({ texts }) => {
    editor.samples = samplesIn(texts);
    if (editor.hasAttribute('hint')) editor.setAttribute('hint', texts.page.hint);
    runAsApp(editor, ready, texts);
  });
}

/** Opens files that the system gives, and keeps the editor for use without a network. */
async function runAsApp(editor: C2Warp, ready: Promise<unknown>, texts: Texts): Promise<void> {
  const waits = await startNewest();
  const inform = (text: string) => ready.then(() => editor.inform(text));
  const open = (files: readonly File[]) => editor.openFiles(files);
  const offer = (files: readonly File[]) => ready.then(() => editor.offer(files));
  receiveFiles({ open, offer, inform }, texts);
  // The development server has no worker: its files change.
  if (import.meta.hot) return;
  // The downloads would slow the first picture down.
  await ready;
  await storeVersions(trusted(WORKER, 'c2warp'), waits, inform, texts);
}

/** Returns the result of `ask` on the browser's storage, or `null` if the browser refuses storage. */
function stored<T>(ask: (storage: Storage) => T): T | null {
  try {
    return ask(localStorage);
  } catch {
    return null;
  }
}
