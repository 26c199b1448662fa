import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { describe, expect, it } from 'vitest';
import { anchors, blocksOf, codeOf, localLinks } from './documents.mjs';
import { filesUnder } from './prose.mjs';
import { ROOT } from './steps.mjs';

const DOCUMENTS = filesUnder(ROOT)
  .filter((file) => file.endsWith('.md'))
  .map((file) => relative(ROOT, file));

const read = (/** @type {string} */ file) => readFileSync(join(ROOT, file), 'utf8');

const CRATES = ['wasm', 'tests']
  .flatMap((folder) =>
    ['', ...readdirSync(join(ROOT, folder))].map((name) => join(folder, name, 'Cargo.toml')),
  )
  .filter((manifest) => existsSync(join(ROOT, manifest)))
  .map((manifest) => /^name = "(.*)"/m.exec(read(manifest))?.[1]);

/** A path from the root of the repository, up to a wildcard. */
const PATH = /(?<![\w@./-])(?:\.cargo|wasm|web|tests)\/(?:[\w.-]*[\w-](?:\/|\b))+/g;
/** A script of the page or a module of the core, as the pages about them shorten it. */
const SHORT = /^[a-z_]+\/[\w/]+\.ts$|^[a-z_]+\.rs$/;
const SOURCES = ['web/src', 'wasm/core/src'];

/** All words of the code. */
const WORDS = new Set(
  SOURCES.flatMap((folder) => filesUnder(join(ROOT, folder)))
    .filter((file) => /\.(?:rs|ts)$/.test(file))
    .flatMap((file) => readFileSync(file, 'utf8').match(/\w+/g) ?? []),
);
/** A type, or a path of Rust. */
const ITEM = /^[A-Z]\w*[a-z]\w*$|^\w+(?:::\w+)+$/;

/** Files that commands write. */
const WRITTEN = /^(?:web\/dist|tests\/output|web\/src\/compute\/generated)/;

describe.each(DOCUMENTS)('%s', (file) => {
  const markdown = read(file);

  it('has no dead links', () => {
    const dead = localLinks(markdown).filter((link) => {
      const [path = '', anchor] = link.split('#');
      const target = path === '' ? file : join(dirname(file), path);
      if (!existsSync(join(ROOT, target))) return true;
      return anchor !== undefined && !anchors(read(target)).includes(anchor);
    });
    expect(dead).toEqual([]);
  });

  it('names existing files', () => {
    const code = codeOf(markdown);
    const paths = code.flatMap((text) => text.match(PATH) ?? []);
    const missing = paths.filter((path) => !WRITTEN.test(path) && !existsSync(join(ROOT, path)));
    const short = code.filter((path) => SHORT.test(path) && !path.startsWith('web/'));
    const unknown = short.filter((path) => !SOURCES.some((folder) => existsSync(join(ROOT, folder, path))));
    expect([...missing, ...unknown]).toEqual([]);
  });

  it('names existing types and items', () => {
    const items = codeOf(markdown).filter((code) => ITEM.test(code));
    expect(items.filter((item) => !item.split('::').every((name) => WORDS.has(name)))).toEqual([]);
  });

  it('names existing npm scripts and packages of cargo', () => {
    const code = codeOf(markdown).join('\n');
    const scripts = Object.keys(JSON.parse(read('package.json')).scripts);
    const named = [...code.matchAll(/\bnpm (?:run )?([\w:]+)/g)].map(([, name]) => name);
    const packages = [...code.matchAll(/cargo .*?(?:-p|--package) ([\w-]+)/g)].map(([, name]) => name);
    expect(named.filter((name) => !['pack', 'install', ...scripts].includes(name ?? ''))).toEqual([]);
    expect(packages.filter((name) => !CRATES.includes(name))).toEqual([]);
  });
});

describe('the documents', () => {
  it('begin with a README of at most 150 lines', () => {
    expect(read('README.md').trimEnd().split('\n').length).toBeLessThanOrEqual(150);
  });

  it('have a glossary of names in the code', () => {
    const [, glossary = ''] = read('web/docs/architecture.md').split('## Glossary');
    const columns = [...glossary.matchAll(/^\|[^|]*\|([^|]*)\|/gm)].map(([, column = '']) => column);
    const names = columns.flatMap((column) => codeOf(column)).flatMap((code) => code.split('::'));
    expect(names.length).toBeGreaterThan(20);
    expect(names.filter((name) => !WORDS.has(name))).toEqual([]);
  });

  it('contain each page of the manual in the README', () => {
    const pages = DOCUMENTS.filter((file) => file.startsWith(join('web', 'docs')));
    const linked = localLinks(read('README.md')).map((link) => join(link.split('#')[0] ?? ''));
    expect(pages.filter((page) => !linked.includes(page))).toEqual([]);
  });
});

describe('reading Markdown', () => {
  const markdown = `# One & two: *three*
See [a](b.md#c) and [d](https://e), not \`[f](g)\`.
<img src="h.png" />

    npm run i

\`\`\`sh
[j](k)
\`\`\`
`;

  it('finds links outside of code', () => expect(localLinks(markdown)).toEqual(['b.md#c', 'h.png']));

  it('finds anchors', () => expect(anchors(markdown)).toEqual(['one--two-three']));

  it('finds code', () => {
    expect(codeOf(markdown)).toEqual(['[f](g)', '```sh\n[j](k)\n```', '    npm run i']);
    expect(blocksOf(markdown, 'sh')).toEqual(['[j](k)']);
  });
});
