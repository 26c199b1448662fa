/** The distribution's Firefox, driven by WebDriver BiDi. */
import puppeteer from 'puppeteer-core';
import { executable } from './executable.mjs';

export const NAME = 'Firefox';
/** The packages of Debian and its derivatives. */
export const PACKAGES = 'firefox-esr libpci3 xvfb';

/**
 * @param {string} display
 * @returns {Promise<import('./visit.mjs').Visitor | null>} Null if it is not installed.
 */
export async function start(display) {
  const executablePath = executable('firefox-esr', 'firefox');
  if (executablePath === null) return null;
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath,
    // Without a screen it has no WebGL.
    headless: false,
    env: { ...process.env, DISPLAY: display },
    defaultViewport: null,
    args: ['--width=1200', '--height=850'],
  });
  const page = await browser.newPage();
  return {
    async open(url) {
      await page.goto(url, { waitUntil: 'domcontentloaded' });
    },
    ask: (script) => page.evaluate(script),
    async drag(from, to) {
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      if (to !== from) await page.mouse.move(to.x, to.y, { steps: 4 });
      await page.mouse.up();
    },
    close: () => browser.close(),
  };
}
