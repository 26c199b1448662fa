/**
 * `npm run manifest`: writes the tables of the reference from the manifest of the elements. `--check` compares them,
 * and fails if a member has no comment.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { elements } from './manifest/manifest.mjs';
import { withTables } from './manifest/tables.mjs';
import { main, ROOT, StepError } from './steps.mjs';

const DOCUMENTS = ['web/docs/element.md', 'web/docs/player.md'];

await main(async () => {
  const checks = process.argv.includes('--check');
  const all = elements();
  const errors = readFileSync(join(ROOT, 'web/src/error.ts'), 'utf8');
  for (const name of DOCUMENTS) {
    const file = join(ROOT, name);
    const before = readFileSync(file, 'utf8');
    const after = withTables(before, all, errors);
    if (before === after) continue;
    if (checks) throw new StepError(`${name} is out of date: run \`npm run manifest\` and commit it.`);
    writeFileSync(file, after);
  }
});
