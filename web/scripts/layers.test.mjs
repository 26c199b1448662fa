import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ROOT, toolPath } from './steps.mjs';

/** What the outermost layers may import. */
const ALL = [
  'texts',
  'geometry',
  'document',
  'tools',
  'editor',
  'ui',
  'input',
  'render',
  'compute',
  'io',
  'error',
  'a shader',
];

/** The layers that each layer may import. */
const MAY = {
  texts: [],
  geometry: [],
  document: ['texts', 'geometry'],
  tools: ['texts', 'geometry', 'document'],
  editor: ['texts', 'geometry', 'document', 'tools', 'error'],
  ui: ['texts', 'geometry', 'document', 'tools', 'editor'],
  input: ['texts', 'geometry', 'editor', 'ui'],
  render: ['texts', 'geometry', 'error'],
  player: ['a shader', 'error'],
  compute: ['texts', 'document', 'geometry', 'error'],
  io: ['texts', 'error'],
  core: ['texts', 'document', 'geometry', 'compute', 'io', 'error'],
  runtime: ALL,
  app: ['texts'],
  element: [...ALL, 'runtime', 'element.ts'],
};

/** One import from each, by the name that `MAY` has for it. */
const IMPORTS = {
  ...Object.fromEntries(Object.keys(MAY).map((layer) => [layer, `../${layer}/file`])),
  error: '../error',
  'a shader': '../render/file.glsl?raw',
  'element.ts': '../element',
  'the glue': '../compute/generated/c2warp',
};

describe('the lints', () => {
  const folder = mkdtempSync(join(tmpdir(), 'layers-'));
  const fileOf = (/** @type {string} */ layer) => join(folder, 'web/src', layer, 'probe.ts');
  /** @type {{ location: { path: string, start: { line: number } } }[]} */
  let refused = [];

  beforeAll(() => {
    copyFileSync(join(ROOT, '.biome.json'), join(folder, '.biome.json'));
    for (const layer of Object.keys(MAY)) {
      mkdirSync(join(folder, 'web/src', layer), { recursive: true });
      writeFileSync(
        fileOf(layer),
        Object.values(IMPORTS)
          .map((path) => `import '${path}';\n`)
          .join(''),
      );
    }
    const { stdout } = spawnSync(
      process.execPath,
      [
        toolPath('biome'),
        'lint',
        '--vcs-enabled=false',
        '--only=style/noRestrictedImports',
        '--max-diagnostics=none',
        '--reporter=json',
      ],
      { cwd: folder, encoding: 'utf8' },
    );
    refused = JSON.parse(stdout).diagnostics;
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  it.each(Object.entries(MAY))('let %s import %j alone', (layer, may) => {
    const lines = refused
      .filter(({ location }) => location.path.includes(`/${layer}/`))
      .map(({ location }) => location.start.line);
    const allowed = Object.keys(IMPORTS).filter((name, k) => name !== layer && !lines.includes(k + 1));
    expect(allowed).toEqual(expect.arrayContaining(may));
    expect(allowed).toHaveLength(may.length);
  });
});
