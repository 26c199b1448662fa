/** The blocks of code on the pages of the site, as visitors copy them. */
import type { APIRequestContext } from '@playwright/test';
import { htmlOf, PAGES } from './site';

export interface Block {
  /** The address below the site, such as `docs/element`. */
  readonly page: string;
  readonly language: string;
  readonly code: string;
  /** How many blocks of the language come before it on the page. */
  readonly index: number;
}

const BLOCK = /<div class="language-(\w*)[^"]*">.*?<pre[^>]*><code[^>]*>(.*?)<\/code><\/pre>/gs;

const ENTITIES: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', '#39': "'" };

/** The text of HTML without comments. */
const textOf = (html: string): string =>
  html.replaceAll(/<[^>]+>/g, '').replaceAll(/&(#39|\w+);/g, (whole, name) => ENTITIES[name] ?? whole);

export async function blocksOfSite(request: APIRequestContext): Promise<readonly Block[]> {
  const blocks: Block[] = [];
  for (const address of PAGES) {
    const page = address.replace(/^\/site\/|\/$/g, '');
    const counts = new Map<string, number>();
    for (const [, language = '', html = ''] of (await htmlOf(request, address)).matchAll(BLOCK)) {
      const index = counts.get(language) ?? 0;
      counts.set(language, index + 1);
      blocks.push({ page, language, index, code: `${textOf(html).trimEnd()}\n` });
    }
  }
  return blocks;
}

/** The commands of a block for a shell, without comments, prompts and output. */
export function commandsOf({ language, code }: Block): readonly string[] {
  const lines = code.replaceAll('\\\n', ' ').split('\n');
  const typed = language === 'console' ? lines.filter((line) => line.startsWith('$ ')) : lines;
  return typed
    .map((line) =>
      line
        .replace(/^\$ /, '')
        .replace(/(?:^|\s)#.*$/, '')
        .trim(),
    )
    .filter((line) => line !== '');
}
