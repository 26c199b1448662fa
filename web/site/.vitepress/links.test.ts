import { fileURLToPath } from 'node:url';
import { createMarkdownRenderer } from 'vitepress';
import { beforeAll, describe, expect, it } from 'vitest';
import { repositoryLinks } from './links';

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url));
const address = (page: string) => page.replace(/^site\//, '').replace(/\.md$/, '/index.md');

describe('links of a page', () => {
  let html: (markdown: string) => string;

  beforeAll(async () => {
    const markdown = await createMarkdownRenderer(path('../..'), {
      config: (markdown) => repositoryLinks(markdown, { pages: path('../..'), address }),
    });
    html = (text) => markdown.render(text, { path: path('../limits.md'), relativePath: 'limits/index.md' });
  });

  it('lead to pages by their addresses', () => {
    expect(html('[a](../docs/method.md#cost)')).toContain('href="/docs/method/#cost"');
    expect(html('[a](start/vite.md)')).toContain('href="/start/vite/"');
    expect(html('[a](#colour)')).toContain('href="#colour"');
  });

  it('are text if they lead to other files', () => {
    expect(html('[the licence](../../LICENSE) holds')).toBe('<p><span>the licence</span> holds</p>\n');
  });

  it('lead to files that exist', () => {
    expect(() => html('[a](missing.md)')).toThrow('missing.md');
  });
});
