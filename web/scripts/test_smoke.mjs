/**
 * `npm run test:smoke`: opens, bends, exports and reloads in Firefox and WebKit of the distribution. Skips browsers
 * that are not installed, and names their packages.
 */
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { prepare } from './prepare.mjs';
import * as firefox from './smoke/firefox.mjs';
import { freePort, until } from './smoke/ports.mjs';
import { openScreen } from './smoke/screen.mjs';
import { visit } from './smoke/visit.mjs';
import * as webkit from './smoke/webkit.mjs';
import { heading, main, ROOT } from './steps.mjs';

await main(async () => {
  await prepare();
  const screen = await openScreen();
  if (screen === null) {
    console.log('Skipped: browsers need a screen. Install xvfb, or set DISPLAY.');
    return;
  }
  const port = await freePort();
  const server = spawn(process.execPath, [join(ROOT, 'tests/browser/serve.mjs')], {
    stdio: 'ignore',
    env: { ...process.env, PORT: String(port) },
  });
  try {
    const origin = `http://localhost:${port}/`;
    await until(origin);
    for (const browser of [firefox, webkit]) await run(browser, screen.display, origin);
  } finally {
    server.kill();
    screen.close();
  }
});

/**
 * @param {typeof firefox | typeof webkit} browser
 * @param {string} display
 * @param {string} origin
 */
async function run({ NAME, PACKAGES, start }, display, origin) {
  heading(NAME);
  const visitor = await start(display);
  if (visitor === null) {
    console.log(`Skipped: ${NAME} is not installed. Its packages are ${PACKAGES}.`);
    return;
  }
  try {
    await visit(visitor, origin, (step) => console.log(`✓ ${step}`));
  } finally {
    await visitor.close();
  }
}
