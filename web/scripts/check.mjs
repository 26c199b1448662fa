/** `npm run check`: runs all checks that do not run the program. */
import { runChecks } from './checks.mjs';
import { prepare, prepareRustLints } from './prepare.mjs';
import { main, StepError } from './steps.mjs';

await main(async () => {
  await prepare();
  await prepareRustLints();
  const { failed } = await runChecks();
  if (failed.length > 0) throw new StepError(`Failed: ${failed.join(', ')}. The reasons are above.`);
});
