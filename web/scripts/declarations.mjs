/** The type declarations of a built entry: the files of the compiler's output that the entry reaches. */
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT, step, toolPath } from './steps.mjs';

const WRITTEN = 'node_modules/.cache/tsc/element';
const RELATIVE = /(from '|import\(")(\.[^'"]*)/g;

/**
 * @param {string} folder The output folder, relative to the root of the repository.
 * @param {'element' | 'player' | 'core'} entry
 */
export async function writeDeclarations(folder, entry) {
  await step(
    `Types of the ${entry}`,
    process.execPath,
    [toolPath('tsc'), '--project', 'web/tsconfig.element.json'],
    'The types do not compile. The reason is above.',
  );
  rmSync(join(ROOT, folder), { recursive: true, force: true });
  for (const name of reachable(entry)) {
    // Every kind of module resolution accepts paths with file endings.
    const text = readFileSync(join(ROOT, WRITTEN, `${name}.d.ts`), 'utf8').replace(RELATIVE, '$1$2.js');
    const file = join(ROOT, folder, `${name}.d.ts`);
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, text);
  }
}

/**
 * A module, and all modules of this project that its declarations import, directly or not.
 * @param {string} first
 * @param {Set<string>} [known]
 */
function reachable(first, known = new Set()) {
  known.add(first);
  const text = readFileSync(join(ROOT, WRITTEN, `${first}.d.ts`), 'utf8');
  for (const [, , path] of text.matchAll(RELATIVE)) {
    const name = join(dirname(first), path ?? '');
    if (!known.has(name)) reachable(name, known);
  }
  return known;
}
