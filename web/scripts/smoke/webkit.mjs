/** The distribution's WebKit, in WebKitGTK's MiniBrowser, driven by its WebDriver. */
import { spawn } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { Builder, Capabilities, Origin } from 'selenium-webdriver';
import { executable } from './executable.mjs';
import { freePort, until } from './ports.mjs';

export const NAME = 'WebKit';
/** The packages of Debian and its derivatives. */
export const PACKAGES = 'webkit2gtk-driver xvfb';

/** Folders of libraries, each with a folder for every architecture. */
const LIBRARIES = ['/usr/lib', '/usr/libexec'];

/** The browser that comes with the driver, or null. */
function miniBrowser() {
  const folders = LIBRARIES.filter(existsSync).flatMap((folder) => [
    folder,
    ...readdirSync(folder).map((name) => join(folder, name)),
  ]);
  const versions = ['webkitgtk-6.0', 'webkit2gtk-4.1', 'webkit2gtk-4.0'];
  const paths = versions.flatMap((version) => folders.map((folder) => join(folder, version, 'MiniBrowser')));
  return paths.find(existsSync) ?? null;
}

/**
 * @param {string} display
 * @returns {Promise<import('./visit.mjs').Visitor | null>} Null if it is not installed.
 */
export async function start(display) {
  const [driverPath, binary] = [executable('WebKitWebDriver'), miniBrowser()];
  if (driverPath === null || binary === null) return null;
  const port = await freePort();
  const server = spawn(driverPath, [`--port=${port}`], {
    stdio: 'ignore',
    // Its sandbox does not work as root, for example in containers.
    env: { ...process.env, DISPLAY: display, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1' },
  });
  const address = `http://127.0.0.1:${port}`;
  await until(`${address}/status`);
  const options = { binary, args: ['--automation'] };
  const capabilities = new Capabilities({ browserName: 'MiniBrowser', 'webkitgtk:browserOptions': options });
  const driver = await new Builder().usingServer(address).withCapabilities(capabilities).build();
  await driver.manage().window().setRect({ width: 1200, height: 850 });
  return {
    open: (url) => driver.get(url),
    ask: (script) => driver.executeScript(`return ${script}`),
    async drag(from, to) {
      const at = (/** @type {import('./visit.mjs').Place} */ { x, y }) => ({
        x: Math.round(x),
        y: Math.round(y),
        origin: Origin.VIEWPORT,
      });
      const pressed = driver.actions().move(at(from)).press();
      if (to === from) await pressed.release().perform();
      else
        await pressed
          .move({ ...at(to), duration: 200 })
          .release()
          .perform();
    },
    async close() {
      await driver.quit();
      server.kill();
    },
  };
}
