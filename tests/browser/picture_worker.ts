/** Lets the page decode pictures itself, as if its policy denied the worker for them. */
import type { Page } from '@playwright/test';

/** Must be called before the page is opened. */
export const denyPictureWorker = (page: Page) =>
  page.addInitScript(() => {
    globalThis.Worker = class extends Worker {
      constructor(url: string | URL, options?: WorkerOptions) {
        if (/picture[^/]*$/.test(String(url))) throw new DOMException('denied', 'SecurityError');
        super(url, options);
      }
    };
  });
