/**
 * The code on the pages of the site. Each block is run or checked here, or by a test that `ELSEWHERE` names. A new
 * block that belongs to neither fails the first test.
 */
import { spawnSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { frameworkTypes, reactComponent } from '../../web/scripts/manifest/frameworks.mjs';
import { elements } from '../../web/scripts/manifest/manifest.mjs';
import { ROOT, toolPath } from '../../web/scripts/steps.mjs';
import type { C2WarpPlayer } from '../../web/src/player';
import { builtCommand } from './command';
import { expect, test } from './fixtures';
import { BUILD_MS } from './site';
import { type Block, blocksOfSite, commandsOf } from './site_code';

test.describe.configure({ mode: 'default', timeout: BUILD_MS + 120_000 });

const read = (path: string): string => readFileSync(join(ROOT, path), 'utf8');

let blocks: readonly Block[];

test.beforeAll(async ({ request }) => {
  test.setTimeout(BUILD_MS);
  blocks = await blocksOfSite(request);
});

const of = (...languages: readonly string[]): readonly Block[] =>
  blocks.filter(({ language }) => languages.includes(language));

/** The texts of the files of an example. */
const filesOf = (name: string): readonly string[] =>
  readdirSync(join(ROOT, 'web/examples', name), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => readFileSync(join(parentPath, name), 'utf8'));

/** Starts that show an example: `npm run test:packages` installs and builds it, and drags in its page. */
const EXAMPLES = ['plain', 'vite', 'react', 'vue', 'svelte', 'next'];

/** Other tests, the part of the manual that they read, and the blocks that they run. */
const ELSEWHERE: readonly (readonly [test: string, page: string, covers: (block: Block) => boolean])[] = [
  ['tests/browser/manual.spec.ts', 'docs/element', ({ language }) => language === 'html'],
  ['tests/browser/core.spec.ts', 'docs/core', ({ language }) => language === 'html'],
  ['tests/browser/core.spec.ts', 'docs/core', ({ language, index }) => language === 'js' && index < 4],
  ['tests/browser/app.spec.ts', 'docs/hosting', ({ language }) => language === 'js'],
  ['tests/browser/languages.spec.ts', 'docs/languages', () => true],
  [
    'web/scripts/declarations.test.mjs',
    'docs/element',
    ({ language, index }) => language === 'ts' && index === 0,
  ],
  ['tests/native/cli/manual.rs', 'docs/cli', ({ language }) => language === 'console'],
];

/** Blocks that no program reads: formulas, a tree of files, and the nodes of a program that is no part of this. */
const NOT_CODE: readonly (readonly [page: string, start: string])[] = [
  ['docs/maps', 'u = (i + 0.5) / W'],
  ['docs/maps', 'Read {'],
  ['docs/method', 'F(h) = '],
  ['docs/rig-format', 'y = r + t'],
  ['docs/rig-format', 'exp(E) = '],
  ['docs/rig-format', 'L + g(|P|²)'],
  ['start/plain', 'site/\n'],
];

const isShell = ({ language, code }: Block): boolean =>
  language === 'sh' || (language === 'text' && /^(?:npm|cargo|node|c2warp) /.test(code));
const isPolicy = ({ language, code }: Block): boolean =>
  language === 'text' && code.startsWith('default-src');
const isJson = ({ language, code }: Block): boolean =>
  language === 'json' || (language === 'text' && code.startsWith('"'));
const isPlayerPage = ({ language, code }: Block): boolean => language === 'html' && code.includes('player/');
const isPlayerScript = ({ language, page }: Block): boolean => language === 'js' && page === 'docs/player';
const isEmbedding = ({ page, language }: Block): boolean => language === 'html' && page === '';
const isExample = ({ page, language }: Block): boolean =>
  EXAMPLES.some((name) => page === `start/${name}`) && !['sh', 'text'].includes(language);
const isElsewhere = (block: Block): boolean =>
  ELSEWHERE.some(([, page, covers]) => page === block.page && covers(block));

/** A program that is compiled here, unless another test runs it. */
const isProgram = ({ language, page, index }: Block): boolean =>
  ['tsx', 'ts'].includes(language) || (language === 'js' && page === 'docs/core' && index === 4);

const HERE: readonly ((block: Block) => boolean)[] = [
  isShell,
  isPolicy,
  isJson,
  isPlayerPage,
  isPlayerScript,
  isEmbedding,
  isProgram,
  ({ language }) => ['toml', 'rust', 'css', 'python'].includes(language),
  isExample,
  ({ page, code }) => NOT_CODE.some(([other, start]) => page === other && code.startsWith(start)),
];

test('every block of code is run or checked by a test', () => {
  expect(blocks.length).toBeGreaterThan(100);
  const uncovered = blocks.filter((block) => !isElsewhere(block) && !HERE.some((covers) => covers(block)));
  expect(uncovered.map(({ page, language, code }) => `${page}, ${language}: ${code.slice(0, 80)}`)).toEqual(
    [],
  );
  for (const [file, page, covers] of ELSEWHERE) {
    expect(read(file), file).toContain(`web/${page}.md`);
    expect(blocks.filter((block) => block.page === page && covers(block)).length, file).toBeGreaterThan(0);
  }
  const unused = NOT_CODE.filter(
    ([page, start]) => !blocks.some((block) => block.page === page && block.code.startsWith(start)),
  );
  expect(unused).toEqual([]);
});

test('the starts show files of the examples', () => {
  for (const name of EXAMPLES) {
    const shown = blocks.filter((block) => block.page === `start/${name}` && isExample(block));
    expect(shown.length, name).toBeGreaterThan(0);
    for (const { code } of shown) expect(filesOf(name), name).toContain(code);
  }
});

test('the landing page embeds as the manual does', () => {
  const lines = blocks.filter(isEmbedding).flatMap(({ code }) => code.trim().split('\n'));
  const manual = of('html').filter(({ page }) => page === 'docs/element');
  expect(lines).toHaveLength(2);
  for (const line of lines)
    expect(
      manual.some(({ code }) => code.includes(line)),
      line,
    ).toBe(true);
});

/** Programs that are no part of c2warp. `npm` and `cargo` have tests in `web/scripts/documents.test.mjs`. */
const OTHER_PROGRAMS = ['npm', 'npx', 'cargo', 'node', 'cat', 'cd', 'sed', 'printf', 'ffmpeg'];

test('commands name subcommands and options that exist', () => {
  test.setTimeout(900_000);
  const command = builtCommand();
  const helps = new Map<string, string>();
  const helpOf = (name: string): string => {
    const known = helps.get(name);
    if (known !== undefined) return known;
    const { stdout, status } = spawnSync(command, [name, '--help'], { encoding: 'utf8' });
    expect(status, name).toBe(0);
    helps.set(name, stdout);
    return stdout;
  };
  for (const block of [...blocks.filter(isShell), ...of('console')]) {
    for (const line of commandsOf(block)) {
      const words = line.replace(/^npx c2warp/, 'c2warp').split(/\s+/);
      if (words[0] !== 'c2warp') {
        expect(OTHER_PROGRAMS, `${block.page}: ${line}`).toContain(words[0]);
        continue;
      }
      const help = helpOf(words[1] ?? '');
      const options = words.slice(2).flatMap((word) => word.match(/^-(?:-[\w-]+|[a-z])$/) ?? []);
      for (const option of options)
        expect(help, `${block.page}: ${line}`).toMatch(new RegExp(`(?<!\\S)${option}\\b`));
    }
  }
  expect(helps.size).toBeGreaterThan(10);
});

test('the starts install and run packages of their examples', () => {
  for (const block of blocks.filter(({ page, language }) => page.startsWith('start/') && language === 'sh')) {
    const manifest = `web/examples/${block.page.replace('start/', '')}/package.json`;
    const own = existsSync(join(ROOT, manifest)) ? JSON.parse(read(manifest)).dependencies : {};
    const known = [
      'c2warp',
      ...Object.keys(own),
      ...Object.keys(JSON.parse(read('package.json')).devDependencies),
    ];
    for (const line of commandsOf(block)) {
      const [program, ...words] = line.split(' ');
      if (program === 'npx') expect(known, line).toContain(words[0]);
      if (program !== 'npm' || words[0] !== 'install') continue;
      const named = words.slice(1).filter((word) => !word.endsWith('.tgz'));
      for (const name of named) expect(Object.keys(own), line).toContain(name);
      expect(words.at(-1)).toBe(`../c2warp/c2warp-${JSON.parse(read('package.json')).version}.tgz`);
    }
  }
});

/** A folder with files of the sample. */
function folderWith(...files: readonly string[]): string {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-site-'));
  for (const file of files) copyFileSync(join(ROOT, 'web/public/samples', file), join(folder, file));
  return folder;
}

/** Runs a command of a page in a folder, and expects its output file. */
function runIn(folder: string, line: string): void {
  const words = line.split(' ').slice(1);
  const { status, stderr } = spawnSync(builtCommand(), words, { cwd: folder, encoding: 'utf8' });
  expect(`${stderr}${status}`, line).toMatch(/0$/);
  const output = words.at(words.indexOf('-o') + 1);
  if (words.includes('-o')) expect(existsSync(join(folder, output ?? '')), line).toBe(true);
}

test('the start of the command line makes a project, a picture and a film', () => {
  test.setTimeout(900_000);
  const folder = folderWith('cat.png');
  try {
    const own = blocks.filter(({ page, language }) => page === 'start/command-line' && language === 'sh');
    const lines = own.flatMap(commandsOf).filter((line) => line.startsWith('c2warp '));
    expect(lines).toHaveLength(3);
    for (const line of lines) {
      if (line.includes('animate'))
        copyFileSync(join(ROOT, 'web/public/samples/cat.c2warp.json'), join(folder, 'cat.c2warp.json'));
      runIn(folder, line);
      expect(existsSync(join(folder, 'cat.c2warp.json'))).toBe(true);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

/** Opens a page with HTML of the manual, without a policy. */
async function openExample(page: Page, html: string, rig: Buffer): Promise<void> {
  await page.route('**/example.html', (route) =>
    route.fulfill({ contentType: 'text/html', body: `<link rel="icon" href="favicon.svg" />${html}` }),
  );
  await page.route('**/cat.c2rig', (route) => route.fulfill({ body: rig }));
  await page.goto('/example.html');
}

test('the start of the player bakes a rig, and its page plays it', async ({ page }) => {
  test.setTimeout(900_000);
  const folder = folderWith('cat.png', 'cat.c2warp.json', 'gingerbread.png', 'gingerbread.c2warp.json');
  try {
    const own = blocks.filter(({ page, language }) => page === 'start/player' && language === 'sh');
    const [line = ''] = own.flatMap(commandsOf).filter((line) => line.startsWith('c2warp '));
    runIn(folder, line);
    const [html = '', ...others] = [...new Set(blocks.filter(isPlayerPage).map(({ code }) => code))];
    expect(others).toEqual([]);
    await openExample(page, html, readFileSync(join(folder, 'cat.c2rig')));
    const player = page.locator('c2-warp-player');
    const time = () => player.evaluate((element) => (element as C2WarpPlayer).currentTime);
    await expect.poll(time).toBeGreaterThan(0);

    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.reload();
    await expect
      .poll(() => player.evaluate((element) => (element as C2WarpPlayer).duration))
      .toBeGreaterThan(0);
    await page.evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
    expect(await time()).toBe(0);

    // Only the paper's mode poses without a solver, and only without automatic rotations.
    const project = JSON.parse(readFileSync(join(folder, 'gingerbread.c2warp.json'), 'utf8'));
    const handles = project.handles.map((handle: object) => ({ ...handle, rotation: 0 }));
    writeFileSync(
      join(folder, 'gingerbread.c2warp.json'),
      JSON.stringify({ ...project, handles, pose: {}, clips: [] }),
    );
    runIn(folder, line.replaceAll('cat', 'gingerbread'));
    const posing = blocks.filter(isPlayerScript).map(({ code }) => `<script type="module">${code}</script>`);
    expect(posing).toHaveLength(1);
    // A playing clip would replace the pose.
    const still = html.replace(' autoplay loop', '');
    await openExample(page, still + posing.join(''), readFileSync(join(folder, 'gingerbread.c2rig')));
    const hand = () =>
      player.evaluate(
        (element) => (element as C2WarpPlayer).handles?.find(({ id }) => id === 'left-hand')?.posed,
      );
    await expect.poll(hand).toEqual([124, 420]);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('policies of the manual suffice', async ({ page }) => {
  const folded = (text: string) => text.replaceAll(/["+\s]+/g, ' ').trim();
  const known = ['tests/browser/app_server.ts', 'tests/browser/serve.mjs'].map(read).map(folded).join(' ');
  for (const { page: at, code } of blocks.filter(isPolicy)) {
    if (known.includes(folded(code))) continue;
    expect(at).toBe('docs/element');
    await page.route('**/example.html', (route) =>
      route.fulfill({
        headers: { 'content-type': 'text/html', 'content-security-policy': folded(code) },
        body: `<script type="module" src="element/c2warp.js"></script>
          <c2-warp src="samples/cat.png" project="samples/cat.c2warp.json"></c2-warp>`,
      }),
    );
    // The policy allows no icon.
    await page.route('**/favicon.ico', (route) => route.fulfill({ status: 204 }));
    await page.goto('/example.html');
    await expect(page.getByRole('button', { name: /^Handle / }).first()).toBeVisible();
  }
});

test('JSON is valid, and fits the schema of projects', () => {
  const validate = new Ajv2020({ strict: false }).compile(
    JSON.parse(read('web/src/document/generated/project.schema.json')),
  );
  const sample = JSON.parse(read('web/public/samples/gingerbread.c2warp.json'));
  for (const { page, code } of blocks.filter(isJson)) {
    const value = JSON.parse(code.startsWith('"') ? `{${code}}` : code);
    if ('html.customData' in value) {
      const files = Object.values<string[]>(value).flat();
      for (const file of files)
        expect(read('web/scripts/manifest/files.mjs')).toContain(file.split('/').at(-1));
      continue;
    }
    const project = value.format ? value : { ...sample, ...value };
    expect({ page, valid: validate(project), errors: validate.errors }).toEqual({
      page,
      valid: true,
      errors: null,
    });
  }
});

test('TOML names features of the crate, and lines of its README', () => {
  const features = /^\[features\]\n(.*?)^\[/ms.exec(read('wasm/core/Cargo.toml'))?.[1] ?? '';
  for (const { code } of of('toml')) {
    if (read('wasm/core/README.md').includes(code)) continue;
    const [, path = '', listed = ''] = /path = "\.\.\/c2warp\/(.*?)", features = \[(.*?)\]/.exec(code) ?? [];
    expect(existsSync(join(ROOT, path, 'Cargo.toml')), code).toBe(true);
    const named = listed.match(/\w[\w-]*/g) ?? [];
    expect(named.length, code).toBeGreaterThan(0);
    for (const name of named) expect(features).toMatch(new RegExp(`^${name} = `, 'm'));
  }
});

test('Rust is the doc test of the crate', () => {
  expect(of('rust').length).toBeGreaterThan(0);
  for (const { code } of of('rust'))
    expect(read('wasm/core/README.md')).toContain(`\`\`\`rust\n${code}\`\`\``);
});

test('CSS names parts and properties of the element', () => {
  const manual = read('web/docs/element.md');
  for (const { code } of of('css')) {
    const names = [...code.matchAll(/(--c2-[\w-]+):|::part\((\w+)\)/g)].map(
      ([, property, part]) => property ?? part,
    );
    expect(names.length).toBeGreaterThan(0);
    for (const name of names) expect(manual).toMatch(new RegExp(`^\\| \`${name}\` \\|`, 'm'));
  }
});

test('Python is valid, where there is one', () => {
  const scripts = of('python').map(({ code }) => code);
  expect(scripts.length).toBeGreaterThan(0);
  test.skip(spawnSync('python3', ['--version']).status !== 0, 'There is no Python.');
  for (const input of scripts) {
    const { status, stderr } = spawnSync('python3', ['-c', 'import ast, sys; ast.parse(sys.stdin.read())'], {
      input,
    });
    expect(`${stderr}${status}`).toBe('0');
  }
});

/** The lines around examples that are a part of a program. */
const BEFORE: Readonly<Record<string, string>> = {
  'docs/element ts 1': `import 'c2warp';\nconst warp = document.createElement('c2-warp');\n`,
  'docs/core js 4': `import { readFile } from 'node:fs/promises';\nimport { createWarper } from 'c2warp/core';
const sharp = /** @type {any} */ (null);\n`,
};

test('TypeScript and JavaScript compile', () => {
  mkdirSync(join(ROOT, 'tests/output'), { recursive: true });
  const folder = mkdtempSync(join(ROOT, 'tests/output/site-code-'));
  try {
    const files = blocks
      .filter((block) => isProgram(block) && !isElsewhere(block))
      .map(({ page, language, index, code }) => {
        const file = join(folder, `${page.replace('/', '_')}_${index}.${language}`);
        writeFileSync(file, `${BEFORE[`${page} ${language} ${index}`] ?? ''}${code}\nexport {};\n`);
        return file;
      });
    expect(files).toHaveLength(3);
    // The built package has them beside each other.
    const all = elements();
    const [warp] = all;
    const declarations = {
      'react/c2warp-react.d.ts': warp ? reactComponent(warp) : '',
      'element/frameworks/props.d.ts': frameworkTypes(all)['props.d.ts'] ?? '',
      'element/types/element.d.ts': `export * from '${join(ROOT, 'web/src/element')}';\n`,
    };
    for (const [name, text] of Object.entries(declarations)) {
      mkdirSync(join(folder, name, '..'), { recursive: true });
      writeFileSync(join(folder, name), text);
    }
    const source = (path: string) => [join(ROOT, 'web/src', path)];
    const config = {
      extends: join(ROOT, 'web/tsconfig.page.json'),
      compilerOptions: {
        ...{ composite: false, emitDeclarationOnly: false, noEmit: true, allowJs: true, checkJs: true },
        ...{
          jsx: 'react-jsx',
          rootDir: ROOT,
          types: ['vite/client', 'node', 'react'],
          noUnusedLocals: false,
          noImplicitAny: false,
        },
        paths: {
          c2warp: source('element.ts'),
          'c2warp/core': source('core.ts'),
          'c2warp/react': [join(folder, 'react/c2warp-react.d.ts')],
        },
      },
      files,
      include: [],
      references: [],
    };
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify(config));
    const { stdout, status } = spawnSync(process.execPath, [toolPath('tsc'), '--project', folder], {
      encoding: 'utf8',
    });
    expect(`${stdout}${status}`).toBe('0');
  } finally {
    rmSync(folder, { recursive: true });
  }
});
