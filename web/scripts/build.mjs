/** `npm run build`: the editor as static files in web/dist. */
import { prepare } from './prepare.mjs';
import { main, step, toolPath } from './steps.mjs';

await main(async () => {
  await prepare();
  await step(
    'Editor',
    process.execPath,
    [toolPath('vite'), 'build', '--config', 'web/vite.config.ts'],
    'The editor does not build; the reason stands above.',
  );
});
