/**
 * Holds back the replies of the solver's worker, so that a test controls how long a solve takes. The state survives a
 * reload of the page.
 */
import type { Page } from '@playwright/test';

export class WorkerReplies {
  readonly #page: Page;

  private constructor(page: Page) {
    this.#page = page;
  }

  /** Must be called before the page is opened. */
  static async intercept(page: Page): Promise<WorkerReplies> {
    await page.addInitScript(() => {
      const held = () => sessionStorage.getItem('answers') === 'held';
      globalThis.Worker = class extends Worker {
        constructor(url: string | URL, options?: WorkerOptions) {
          super(url, options);
          // This listener runs before those of the page. Progress messages pass.
          this.addEventListener('message', (event) => {
            const { data } = event;
            if (!held() || data.kind === 'progress') return;
            event.stopImmediatePropagation();
            const pass = () => this.dispatchEvent(new MessageEvent('message', { data }));
            addEventListener('answers-pass', pass, { once: true });
          });
        }
      };
    });
    return new WorkerReplies(page);
  }

  async hold(): Promise<void> {
    await this.#page.evaluate(() => sessionStorage.setItem('answers', 'held'));
  }

  /** Delivers the held replies, and all later ones at once. */
  async release(): Promise<void> {
    await this.#page.evaluate(() => {
      sessionStorage.removeItem('answers');
      dispatchEvent(new Event('answers-pass'));
    });
  }
}
