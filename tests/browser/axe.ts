/** The rules of WCAG that axe-core checks. */
import { AxeBuilder } from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect } from './fixtures';

/** Expects that axe finds nothing in the editor, in the light theme and in the dark one. */
export async function expectAccessible(page: Page): Promise<void> {
  for (const theme of ['light', 'dark']) {
    await page.locator('c2-warp').evaluate((element, theme) => element.setAttribute('theme', theme), theme);
    const { violations } = await new AxeBuilder({ page }).include('c2-warp').analyze();
    expect(violations).toEqual([]);
  }
}
