/** The pages as text, for programs that read: `llms.txt` lists them, and `llms-full.txt` holds them all. */
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';

interface Page {
  file: string;
  /** The Markdown file of the site's page, from the root of the site. */
  address: string;
}

const FRONT_MATTER = /^---\n.*?\n---\n/s;
/** A file shown as code. */
const SNIPPET = /^<<< @\/(\S+)$/gm;
/** Lines of another Markdown file. */
const INCLUDE = /^<!--@include: (\S+)\{(\d+),(\d+)\}-->$/gm;

/** @param root The folder that `@` stands for. */
export function writeTexts(pages: Page[], root: string, folder: string): void {
  const texts = pages
    .map((page) => ({ ...page, text: textOf(page.file, root) }))
    .filter(({ address }) => address !== '404.md');
  const lines = texts.map(({ text, address }) => {
    const [, title = ''] = /^# (.*)$/m.exec(text) ?? [];
    return `- [${title}](./${address.replace(/index\.md$/, '')})`;
  });
  const head = '# c2warp\n\n> Bend pictures by handles: a custom element, a solver and a command.\n';
  writeFileSync(join(folder, 'llms.txt'), `${head}\n## Pages\n\n${lines.join('\n')}\n`);
  writeFileSync(join(folder, 'llms-full.txt'), texts.map(({ text }) => text.trim()).join('\n\n---\n\n'));
}

/** The Markdown of a page, with the code of its snippets. */
const textOf = (file: string, root: string): string =>
  readFileSync(file, 'utf8')
    .replace(FRONT_MATTER, '')
    .replaceAll(SNIPPET, (_, path: string) => {
      const code = readFileSync(join(root, path), 'utf8');
      return `\`\`\`${path.split('.').pop()}\n${code.trim()}\n\`\`\``;
    })
    .replaceAll(INCLUDE, (_, path: string, from: string, to: string) => {
      const lines = readFileSync(resolve(dirname(file), path), 'utf8').split('\n');
      return lines.slice(Number(from) - 1, Number(to)).join('\n');
    });
