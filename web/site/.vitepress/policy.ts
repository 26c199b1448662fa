/**
 * Pages without inline scripts and inline styles, so that a strict Content Security Policy can refuse both.
 * `web/docs/hosting.md` has the policy.
 */
import { createHash } from 'node:crypto';
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const INLINE_SCRIPT = /<script([^>]*)>([^<]+)<\/script>/g;
/** Scripts set them by the CSSOM again, once the page has loaded. */
const INLINE_STYLE = /(<[a-z][^<>]*?) style="[^"]*"/g;

/**
 * Moves inline scripts of a page into files of the site, and removes inline styles.
 * @param base The path of the site on its server.
 */
export function withoutInline(html: string, folder: string, base: string): string {
  return html
    .replaceAll(INLINE_SCRIPT, (_, attributes: string, code: string) => {
      const hash = createHash('sha256').update(code).digest('hex').slice(0, 8);
      const name = `assets/inline.${hash}.js`;
      mkdirSync(dirname(join(folder, name)), { recursive: true });
      writeFileSync(join(folder, name), code);
      return `<script${attributes} src="${base}${name}"></script>`;
    })
    .replaceAll(INLINE_STYLE, '$1');
}
