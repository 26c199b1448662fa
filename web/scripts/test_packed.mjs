/** `npm run test:packed`: builds, packs and checks the npm package. `npm test` runs it too. */
import { npmPackage } from './packing.mjs';
import { main, ROOT } from './steps.mjs';

await main(async () => {
  const { warnings } = await npmPackage(`${ROOT}tests/output/packages`);
  for (const warning of warnings) console.log(`! ${warning}`);
});
