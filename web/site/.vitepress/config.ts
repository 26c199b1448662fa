/**
 * The site: pages of `web/docs` and `web/site`, as static files. `npm run docs` builds it.
 *
 * The pages work under a strict policy: see `policy.ts`. Each page is a folder with an `index.html`, so that any server
 * of files will do.
 */
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type UserConfig } from 'vitepress';
import { licences } from '../../scripts/licences.mjs';
import { HIGHLIGHTING, tokensByClass } from './highlighting';
import { repositoryLinks } from './links';
import { writeTexts } from './llms';
import { siteMarkup } from './markup';
import { NAVIGATION, SIDEBAR } from './navigation';
import { withoutInline } from './policy';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));

/** `docs/element.md` becomes `docs/element/index.md`, and `site/start/vite.md` becomes `start/vite/index.md`. */
function address(page: string): string {
  const path = page.replace(/^site\//, '');
  return /(?:^|\/)(?:index|404)\.md$/.test(path) ? path : path.replace(/\.md$/, '/index.md');
}

/** The licences of the packages in the pages. The plugins are for the Vite of the editor, and VitePress has its own. */
const LICENCES = licences([]).plugins as unknown as Plugins;

type Plugins = NonNullable<NonNullable<UserConfig['vite']>['plugins']>;

export default defineConfig({
  lang: 'en',
  title: 'c2warp',
  description: 'Bend pictures by handles, in the browser.',
  srcDir: '..',
  srcExclude: ['!(docs|site)/**', '*.md'],
  cacheDir: '../../node_modules/.cache/vitepress',
  rewrites: address,
  metaChunk: true,
  // Otherwise a change of colours adds an inline style.
  appearance: { disableTransition: false },
  // The fetched pages would be those of every link in view.
  router: { prefetchLinks: false },
  // The default is an inline style.
  contentProps: { class: 'site-content' },
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag.startsWith('c2-warp') } } },
  markdown: {
    theme: HIGHLIGHTING,
    codeTransformers: [tokensByClass],
    config: (markdown) => {
      repositoryLinks(markdown, { pages: path('../..'), address });
      siteMarkup(markdown);
    },
  },
  vite: {
    // Otherwise that of the editor, in `srcDir`.
    configFile: false,
    plugins: LICENCES,
    build: { assetsInlineLimit: 0, chunkSizeWarningLimit: 2000 },
  },
  themeConfig: {
    logo: { src: '/favicon.svg', alt: '' },
    nav: NAVIGATION,
    sidebar: SIDEBAR,
    outline: [2, 3],
    search: { provider: 'local' },
    docFooter: { prev: false, next: false },
  },
  transformHead: ({ siteData }) => [['link', { rel: 'icon', href: `${siteData.base}favicon.svg` }]],
  transformHtml: (html, _, { siteConfig, siteData }) => withoutInline(html, siteConfig.outDir, siteData.base),
  buildEnd: ({ pages, srcDir, outDir, rewrites }) =>
    writeTexts(
      pages.map((page) => ({ file: join(srcDir, page), address: rewrites.map[page] ?? page })),
      srcDir,
      outDir,
    ),
});
