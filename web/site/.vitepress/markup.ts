/**
 * HTML of Markdown as the site needs it: without inline styles, with tables that scroll by keys, and without empty
 * headers.
 */
import { existsSync } from 'node:fs';
import { dirname, relative } from 'node:path';
import type { MarkdownRenderer } from 'vitepress';
import { arrowsOf, drawingOf, THEMES } from '../../scripts/diagrams.mjs';

export function siteMarkup(markdown: MarkdownRenderer): void {
  const { rules } = markdown.renderer;
  // Indented code looks like fenced code.
  rules.code_block = (tokens, index, options, env, renderer) => {
    const token = tokens[index];
    if (token) token.info = 'text';
    return rules.fence?.(tokens, index, options, env, renderer) ?? '';
  };
  const { fence } = rules;
  rules.fence = (tokens, index, options, env, renderer) => {
    const { info = '', content = '' } = tokens[index] ?? {};
    if (info === 'mermaid') return diagram(content, dirname(env.realPath ?? env.path), markdown);
    return fence?.(tokens, index, options, env, renderer) ?? '';
  };
  markdown.core.ruler.push('site-markup', ({ tokens }) => {
    for (const [index, token] of tokens.entries()) {
      if (token.type === 'table_open') token.attrSet('tabindex', '0');
      // A column of names has no title, and no header without one.
      const [content, end] = [tokens[index + 1], tokens[index + 2]];
      if (token.type === 'th_open' && content?.content === '' && end) token.tag = end.tag = 'td';
      const [, side] = /^text-align:(\w+)$/.exec(token.attrGet('style') ?? '') ?? [];
      if (!side) continue;
      token.attrs = (token.attrs ?? []).filter(([name]) => name !== 'style');
      token.attrJoin('class', `align-${side}`);
    }
  });
}

/** The drawings of a diagram, of which the theme shows one. */
function diagram(source: string, folder: string, markdown: MarkdownRenderer): string {
  const alt = markdown.utils.escapeHtml(`Diagram: ${arrowsOf(source)}`);
  const images = THEMES.map((theme) => {
    const file = drawingOf(source, theme);
    if (!existsSync(file)) throw new Error('a diagram has no drawing: see web/scripts/draw-diagrams.mjs');
    const address = relative(folder, file).replaceAll('\\', '/');
    return `<img class="only-${theme}" src="${address}" alt="${alt}">`;
  });
  return `<p class="diagram" tabindex="0">${images.join('')}</p>`;
}
