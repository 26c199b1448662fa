/** HTML of Markdown as the site needs it: without inline styles, and with wide parts that scroll by keys. */
import type { MarkdownRenderer } from 'vitepress';

export function siteMarkup(markdown: MarkdownRenderer): void {
  const { rules } = markdown.renderer;
  // Indented code looks like fenced code.
  rules.code_block = (tokens, index, options, env, renderer) => {
    const token = tokens[index];
    if (token) token.info = 'text';
    return rules.fence?.(tokens, index, options, env, renderer) ?? '';
  };
  markdown.core.ruler.push('site-markup', ({ tokens }) => {
    for (const token of tokens) {
      if (token.type === 'table_open') token.attrSet('tabindex', '0');
      const [, side] = /^text-align:(\w+)$/.exec(token.attrGet('style') ?? '') ?? [];
      if (!side) continue;
      token.attrs = (token.attrs ?? []).filter(([name]) => name !== 'style');
      token.attrJoin('class', `align-${side}`);
    }
  });
}
