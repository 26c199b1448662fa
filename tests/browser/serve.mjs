/**
 * Serves the pages of the browser tests, built in memory so that concurrent runs do not disturb each other.
 *
 * The editor is at /, the harness at /harness/, the element at /element/, the player of rigs at /player/ and the core
 * at /core/. Pages that embed the element are at /plain/, /strict/ and /article/. All have the strictest Content
 * Security Policy that the program supports. Pages with the component for React 19 and 18 are at /react/ and
 * /react-18/.
 *
 * The site is at /site/. It is built at its first request, since most runs of a few tests do not need it.
 */
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { builtFiles } from '../../web/scripts/built_files.mjs';
import { contentType } from '../../web/scripts/content_types.mjs';
import { reactTables } from '../../web/scripts/manifest/react_tables.mjs';
import { builtPages } from '../../web/scripts/site.mjs';

const path = (/** @type {string} */ relative) => fileURLToPath(new URL(relative, import.meta.url));

const POLICY = "script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; object-src 'none'";

/** The policy of the site in web/docs/hosting.md. */
const SITE_POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; " +
  "connect-src 'self'; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; " +
  "require-trusted-types-for 'script'; trusted-types vue c2warp-html c2warp c2warp-core";

/** @type {Promise<Map<string, Uint8Array>> | undefined} */
let pages;

/** @type {Map<string, string | Uint8Array>} */
const files = new Map();
await add('', 'vite.config.ts', {});
await add('harness/', 'vite.config.ts', { root: path('harness'), publicDir: false });
await add('element/', 'vite.element.config.ts', {});
await add('player/', 'vite.player.config.ts', {});
await add('core/', 'vite.core.config.ts', {});
await addReact('react/', {});
await addReact('react-18/', {
  'react-dom': 'react-dom-18',
  react: 'react-18',
});
for (const page of ['plain', 'strict', 'article'])
  files.set(`${page}/index.html`, await readFile(path(`${page}.html`)));

createServer(async (request, response) => {
  const { pathname } = new URL(request.url ?? '/', 'http://localhost');
  const name = decodeURIComponent(pathname.slice(1)).replace(/(^|\/)$/, '$1index.html');
  const content = await (name.startsWith('site/') ? siteFile(name.slice('site/'.length)) : pageFile(name));
  if (content === undefined) {
    response.writeHead(404).end();
    return;
  }
  const headers = {
    'Content-Type': contentType(name),
    'Content-Security-Policy': name.startsWith('site/') ? SITE_POLICY : POLICY,
    // Pages of other origins can load the element from here.
    'Access-Control-Allow-Origin': '*',
  };
  response.writeHead(200, headers).end(content);
}).listen(Number(process.env.PORT), 'localhost');

/**
 * @param {string} prefix
 * @param {string} config
 * @param {import('vite').UserConfig} overrides
 */
function add(prefix, config, overrides) {
  return addBuilt(prefix, { ...overrides, configFile: path(`../../web/${config}`) });
}

/**
 * With the warnings of React's development build.
 * @param {string} prefix
 * @param {Record<string, string>} alias
 */
function addReact(prefix, alias) {
  return addBuilt(prefix, {
    configFile: false,
    root: path('react'),
    base: './',
    publicDir: false,
    mode: 'development',
    define: { 'process.env.NODE_ENV': '"development"' },
    resolve: { alias },
    plugins: [reactTables()],
  });
}

/**
 * @param {string} prefix
 * @param {import('vite').InlineConfig} config
 */
async function addBuilt(prefix, config) {
  const built = await builtFiles({ ...config, logLevel: 'warn' });
  for (const [name, content] of built) files.set(prefix + name, content);
}

/** @param {string} name */
const pageFile = async (name) => files.get(name) ?? (await publicFile(name));

/** @param {string} name */
async function siteFile(name) {
  pages ??= builtPages('/site/');
  // `npm run docs` puts the element and its like beside the pages.
  return (await pages).get(name) ?? (/^(?:element|player|core)\//.test(name) ? files.get(name) : undefined);
}

/** @param {string} name */
function publicFile(name) {
  const root = path('../../web/public/');
  const file = normalize(join(root, name));
  return file.startsWith(root) ? readFile(file).catch(() => undefined) : undefined;
}
