/** The base of all browser tests. */
import { test as base, expect } from '@playwright/test';

export { expect };

export const test = base.extend<{ strict: undefined }>({
  /** Fails the test on any error of the page. Disables file pickers, so that tests can watch uploads and downloads. */
  strict: [
    async ({ page }, use) => {
      const errors: string[] = [];
      page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
      page.on('console', (message) => {
        if (message.type() === 'error') errors.push(message.text());
      });
      await page.addInitScript(() => {
        Reflect.deleteProperty(globalThis, 'showOpenFilePicker');
        Reflect.deleteProperty(globalThis, 'showSaveFilePicker');
      });
      await use(undefined);
      expect(errors).toEqual([]);
    },
    { auto: true },
  ],
});
