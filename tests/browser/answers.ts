/**
 * What the solver's worker answers, in the hands of a test: while it is held back a solve lasts, on a fast machine as on a
 * slow one, and also over a reload.
 */
import type { Page } from '@playwright/test';

export class Answers {
  readonly #page: Page;

  private constructor(page: Page) {
    this.#page = page;
  }

  /** To be called before the page is opened. */
  static async of(page: Page): Promise<Answers> {
    await page.addInitScript(() => {
      const held = () => sessionStorage.getItem('answers') === 'held';
      globalThis.Worker = class extends Worker {
        constructor(url: string | URL, options?: WorkerOptions) {
          super(url, options);
          // Heard before the page hears it. Progress goes through.
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
    return new Answers(page);
  }

  async hold(): Promise<void> {
    await this.#page.evaluate(() => sessionStorage.setItem('answers', 'held'));
  }

  /** What has come meanwhile, and what comes. */
  async pass(): Promise<void> {
    await this.#page.evaluate(() => {
      sessionStorage.removeItem('answers');
      dispatchEvent(new Event('answers-pass'));
    });
  }
}
