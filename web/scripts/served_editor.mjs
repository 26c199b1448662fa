/** Serves the editor for a Chromium that scripts control. */
import { join } from 'node:path';
import { launchChromium } from './chromium.mjs';
import { ROOT } from './steps.mjs';

/**
 * Serves the editor, starts Chromium, and ends both after `run`.
 * @template T
 * @param {(browser: import('@playwright/test').Browser, address: string) => Promise<T>} run
 */
export async function withServedEditor(run) {
  // Imported only here: it may have just been installed.
  const { createServer } = await import('vite');
  // Libraries as people get them, not those that check their use.
  process.env.NODE_ENV ??= 'production';
  const server = await createServer({ configFile: join(ROOT, 'web/vite.config.ts'), logLevel: 'warn' });
  await server.listen();
  const browser = await launchChromium();
  try {
    return await run(browser, server.resolvedUrls?.local[0] ?? '');
  } finally {
    await browser.close();
    await server.close();
  }
}
