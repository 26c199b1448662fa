/**
 * Links of the pages are those of the repository: to files, relative to the file of the page. In the site, a link to
 * a page becomes the address of the page. A link to another file of the repository becomes plain text: no server of
 * the repository is known.
 */
import { existsSync } from 'node:fs';
import { dirname, relative, resolve, sep } from 'node:path';
import type { MarkdownRenderer } from 'vitepress';

interface Site {
  /** The folder of all pages. */
  pages: string;
  /** The Markdown file of the site's page, for a file in the folder of pages. */
  address: (page: string) => string;
}

export function repositoryLinks(markdown: MarkdownRenderer, { pages, address }: Site): void {
  markdown.core.ruler.push('repository-links', ({ tokens, env }) => {
    // Titles are rendered without a file.
    const file = env.realPath ?? env.path;
    if (!file) return;
    const folder = dirname(file);
    for (const { children } of tokens) {
      let text = false;
      for (const token of children ?? []) {
        if (token.type === 'link_open') {
          const href = token.attrGet('href') ?? '';
          if (/^(?:[a-z]+:|#)/.test(href)) continue;
          const target = siteAddress(href, folder);
          text = target === undefined;
          if (target !== undefined) token.attrSet('href', target);
        }
        if (text && (token.type === 'link_open' || token.type === 'link_close')) {
          text = token.type === 'link_open';
          token.type = `repository_${token.type}`;
          token.tag = 'span';
          token.attrs = null;
        }
      }
    }
  });

  /** The address of a linked page, or undefined if the file is no page. A file that is missing is an error. */
  function siteAddress(href: string, folder: string): string | undefined {
    const [path = '', anchor] = href.split('#');
    const file = resolve(folder, path);
    if (!existsSync(file)) throw new Error(`a page links to ${href}, which is not in the repository`);
    const page = relative(pages, file).split(sep).join('/');
    if (!/^(?:docs|site)\/.*\.md$/.test(page)) return undefined;
    const address_ = `/${address(page).replace(/index\.md$/, '')}`;
    return anchor === undefined ? address_ : `${address_}#${anchor}`;
  }
}
