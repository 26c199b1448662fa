/** The checks of `npm run check`: format, lints, types, imports and prose of both languages, and generated files. */
import { OF_CRATES } from './packing.mjs';
import { heading, run, toolPath } from './steps.mjs';

/** The tables of quality are linted and tested by `npm run test:long`: their solver takes minutes to compile. */
export const NOT_OF_QUALITY = ['--exclude', 'c2warp-quality'];

/** The library as its users compile it: without features, and with each feature separately. */
const FEATURES = ['', 'serde', 'schema', 'raster', 'cloud', 'rig', 'poser-bytes'];

/** @type {[title: string, program: string, args: string[]][]} */
const CHECKS = [
  ['Format of the Rust', 'cargo', ['fmt', '--all', '--check']],
  [
    'Lints of the Rust (clippy)',
    'cargo',
    ['clippy', '--workspace', ...NOT_OF_QUALITY, '--all-targets', '--', '--deny', 'warnings'],
  ],
  ...FEATURES.map((feature) => {
    const args = [
      'clippy',
      '--package',
      'c2warp',
      '--lib',
      '--features',
      feature,
      '--',
      '--deny',
      'warnings',
    ];
    return /** @type {[string, string, string[]]} */ ([
      `Core, features: ${feature || 'none'}`,
      'cargo',
      args,
    ]);
  }),
  // The lints have built everything that it needs.
  [
    'Packing of the crates',
    'cargo',
    ['package', '--offline', '--no-verify', '--allow-dirty', '--quiet', ...OF_CRATES],
  ],
  ['Types generated from Rust', 'cargo', ['run', '--package', 'xtask', '--', 'schema', '--check']],
  ['Types (tsc)', process.execPath, [toolPath('tsc'), '--build', 'web/tsconfig.json']],
  ['Manifest of the elements', process.execPath, ['web/scripts/manifest.mjs', '--check']],
  ['Format and lints (biome)', process.execPath, [toolPath('biome'), 'check', '--error-on-warnings']],
  ['Cycles of imports', process.execPath, ['web/scripts/cycles.mjs']],
  ['Prose', process.execPath, ['web/scripts/prose.mjs', '--limits']],
];

/**
 * Runs every check, even after one has failed.
 * @returns {Promise<{ passed: number, failed: string[] }>} The number of checks that passed, and titles of the failed.
 */
export async function runChecks() {
  const failed = [];
  for (const [title, program, args] of CHECKS) {
    heading(title);
    const { code } = await run(program, args);
    if (code !== 0) failed.push(title);
  }
  return { passed: CHECKS.length - failed.length, failed };
}
