/**
 * Finds a Chromium for the browser tests: the one named by the variable CHROMIUM, or one in PATH. On Debian and its
 * derivatives, apt installs one if permitted.
 */
import { accessSync, constants, existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { printed, StepError, step } from './steps.mjs';

/** A Chromium that cannot open windows takes a third less time. */
const SHELL = 'chromium-headless-shell';
const NAMES = [SHELL, 'chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
/** Where Chrome is installed on macOS and Windows, outside of PATH. */
const PLACES = [
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
];

/**
 * WebGL2 on the CPU: machines without a GPU can test, and every machine draws alike. The sandbox is off because it does
 * not work as root, for example in containers.
 */
export const CHROMIUM_ARGS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** @returns {string | undefined} Path of the Chromium to use. */
export function findChromium() {
  const named = process.env.CHROMIUM;
  if (named) return named;
  for (const directory of (process.env.PATH ?? '').split(delimiter)) {
    for (const name of NAMES) {
      const candidate = join(directory, name);
      if (isExecutable(candidate)) return candidate;
    }
  }
  return PLACES.find((place) => existsSync(place));
}

/** Starts the Chromium of {@link findChromium}. @param {readonly string[]} args More arguments. */
export async function launchChromium(args = []) {
  // Imported only here: it may have just been installed.
  const { chromium } = await import('@playwright/test');
  const executablePath = findChromium();
  return chromium.launch({
    args: [...CHROMIUM_ARGS, ...args],
    ...(executablePath ? { executablePath } : {}),
  });
}

/** Installs a Chromium if none is found. */
export async function prepareChromium() {
  const found = findChromium();
  if (found !== undefined) {
    if (isExecutable(found)) return;
    throw new StepError(`CHROMIUM names ${found}, but it cannot be run.`);
  }
  const missing = 'No Chromium for the browser tests: install one, or name it in the variable CHROMIUM.';
  const root = process.getuid?.() === 0;
  const sudo = !root && printed('sudo', ['-n', 'true']) !== undefined;
  if (printed('apt-get', ['--version']) === undefined || !(root || sudo)) throw new StepError(missing);
  const [program, ...before] = [...(root ? [] : ['sudo', '-n']), 'apt-get'];
  await step('Package lists', program, [...before, 'update', '--quiet=2'], missing);
  const name = printed('apt-cache', ['show', SHELL]) ? SHELL : 'chromium';
  await step(
    'Chromium',
    program,
    [...before, 'install', '--quiet=2', '--yes', '--no-install-recommends', name, 'fonts-dejavu-core'],
    missing,
  );
  if (findChromium() === undefined) throw new StepError(missing);
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}
