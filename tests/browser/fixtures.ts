/** What every browser test starts from. */
import { test as base, expect } from '@playwright/test';

export { expect };

export const test = base.extend<{ strict: undefined }>({
  /** A test fails on any error that the page reports, and files go through up- and download, which it can watch. */
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
