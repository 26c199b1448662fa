/** The command as WebAssembly, by the script of the package: it behaves like the native one. */
import { spawnSync } from 'node:child_process';
import {
  copyFileSync,
  linkSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { builtCommand, builtWasmCommand } from './command';
import { expect, test } from './fixtures';

const sample = (name: string) => new URL(`../../web/public/samples/${name}`, import.meta.url);

interface Outcome {
  readonly status: number | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** Every way to name files, and every kind of output. Each runs in a folder of its own. */
const RUNS: readonly (readonly [args: readonly string[], outputs: readonly string[]])[] = [
  [
    ['warp', 'cat.c2warp.json', '--scale', '0.5', '-o', 'warped.png', '--stmap', 'map.exr'],
    ['warped.png', 'map.exr'],
  ],
  [
    ['warp', './cat.c2warp.json', '--image', '../shared/cat.png', '--grow', '-o', 'sub/../grown.png'],
    ['grown.png'],
  ],
  [['weights', 'cat.c2warp.json', '--at', 'points.csv', '-o', '-'], []],
  [['map', 'cat.c2warp.json', '--at', '-', '-o', 'map.csv'], ['map.csv']],
  [['map', 'cat.c2warp.json', '--at', 'points.csv', '--inverse', '-o', '-'], []],
  [
    ['animate', 'cat.c2warp.json', '--clip', 'tail', '--fps', '4', '--scale', '0.2', '-o', 'cat.gif'],
    ['cat.gif'],
  ],
  [
    ['export', 'cat.c2warp.json', '-o', 'cat.spine.json'],
    ['cat.spine.json', 'cat.png'],
  ],
  [['warp', 'cat.c2warp.json', '-o', 'missing/out.png'], []],
  [['warp', 'points.csv', '-o', 'out.png'], []],
  // An input is not replaced, by any name.
  [['warp', 'cat.c2warp.json', '-o', 'sub/../cat.png'], ['cat.png']],
  [['bake', 'cat.c2warp.json', '-o', 'link'], ['cat.png']],
  [['warp', 'cat.c2warp.json', '-o', 'hard.png'], ['cat.png']],
  [
    ['warp', 'cat.c2warp.json', '--image', 'cat.png', '../shared/cat.png', '--scale', '0.1', '-o', 'sub'],
    ['sub/cat.png'],
  ],
  [['map', 'cat.c2warp.json'], []],
];

test('as WebAssembly the command does what the native one does', async ({ request }) => {
  // Cargo may have to build the command first.
  test.setTimeout(900_000);
  const root = mkdtempSync(join(tmpdir(), 'c2warp-command-'));
  try {
    const script = join(root, 'command.mjs');
    writeFileSync(script, await (await request.get('/core/command.js')).body());
    copyFileSync(builtWasmCommand(), join(root, 'command.wasm'));
    mkdirSync(join(root, 'shared'));
    copyFileSync(sample('cat.png'), join(root, 'shared/cat.png'));
    const run = (name: string, program: string, first: readonly string[]): readonly unknown[] =>
      RUNS.map(([args, outputs], index) => {
        const folder = join(root, `${name}-${index}`);
        mkdirSync(join(folder, 'sub'), { recursive: true });
        for (const file of ['cat.png', 'cat.c2warp.json']) copyFileSync(sample(file), join(folder, file));
        writeFileSync(join(folder, 'points.csv'), 'x,y\n300,300\n420.5,700\n2,2\n');
        symlinkSync('cat.png', join(folder, 'link'));
        linkSync(join(folder, 'cat.png'), join(folder, 'hard.png'));
        const { status, stdout, stderr }: Outcome = spawnSync(program, [...first, ...args], {
          cwd: folder,
          encoding: 'utf8',
          input: 'x,y\n300,300\n',
        });
        const files = outputs.map((output) => readFileSync(join(folder, output)).toString('base64'));
        const names = readdirSync(folder);
        // Systems number their errors differently.
        return {
          args,
          status,
          stdout,
          stderr: stderr.replace(/\(os error \d+\)/, '(os error)'),
          files,
          names,
        };
      });
    expect(run('wasm', process.execPath, [script])).toEqual(run('native', builtCommand(), []));
    const report = (program: string, ...args: readonly string[]) => {
      const project = join(root, 'native-0/cat.c2warp.json');
      const { stdout } = spawnSync(program, [...args, 'inspect', project, '--json'], { encoding: 'utf8' });
      const { ms: _, ...figures } = JSON.parse(stdout);
      return figures;
    };
    expect(report(process.execPath, script)).toEqual(report(builtCommand()));
  } finally {
    rmSync(root, { recursive: true });
  }
});
