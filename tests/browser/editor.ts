/** The editor as a person meets it: what the browser tests do on the page, through pointers, keys and labels alone. */

import { type Download, expect, type Locator, type Page } from '@playwright/test';
import { decode } from 'fast-png';

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A handle as its label tells it, image pixels and degrees. */
export interface Told extends Place {
  readonly rotation: number;
}

export class Editor {
  readonly page: Page;
  readonly status: Locator;
  readonly notice: Locator;

  constructor(page: Page) {
    this.page = page;
    this.status = page.getByRole('group', { name: 'Status' });
    this.notice = page.getByRole('alert');
  }

  /** The sample, solved and ready to drag. */
  static async open(page: Page): Promise<Editor> {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto('/');
    const editor = new Editor(page);
    await editor.ready();
    return editor;
  }

  async ready(): Promise<void> {
    await expect(this.handle('left hand')).toBeVisible();
    await expect(this.page.locator('c2-warp .solved')).toContainText('sample');
  }

  handle(name: string): Locator {
    return this.page.getByRole('button', { name: `Handle ${name}, ` });
  }

  get handles(): Locator {
    return this.page.getByRole('application', { name: 'Handles' }).getByRole('button');
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name });
  }

  field(name: 'x' | 'y' | 'rotation' | 'scale'): Locator {
    return this.page.getByRole('spinbutton', { name: `${name} (` });
  }

  async told(name: string): Promise<Told> {
    const label = (await this.handle(name).getAttribute('aria-label')) ?? '';
    const number = (word: string) => Number(label.match(new RegExp(`${word} (-?[\\d.]+)`))?.[1]);
    return { x: number('x'), y: number('y'), rotation: number('rotation') };
  }

  /** Where a handle is on the page, CSS pixels. */
  async place(name: string): Promise<Place> {
    const box = await this.handle(name).boundingBox();
    if (!box) throw new Error(`${name} is not shown`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** CSS pixels per image pixel. */
  async zoom(): Promise<number> {
    return (
      Number.parseFloat((await this.page.getByRole('status', { name: 'Zoom' }).textContent()) ?? '') / 100
    );
  }

  /** What a question is answered once the page answers it alike for two frames: for what later answers are compared with. */
  async still<T>(ask: () => Promise<T>): Promise<T> {
    let before = await ask();
    await expect
      .poll(async () => {
        await this.drawn();
        const [last, now] = [before, await ask()];
        before = now;
        return JSON.stringify(now) === JSON.stringify(last);
      })
      .toBe(true);
    return before;
  }

  /** Two frames: one to pose, one to be shown. */
  async drawn(): Promise<void> {
    await this.page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
  }

  async drag(from: Place, by: Place): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(from.x + by.x / 2, from.y + by.y / 2);
    await mouse.move(from.x + by.x, from.y + by.y);
    await mouse.up();
  }

  async dragHandle(name: string, by: Place): Promise<void> {
    await this.drag(await this.place(name), by);
  }

  /** A piece of what is drawn around a place, without anything that floats over the picture. */
  async look(at: Place, radius = 24): Promise<Buffer> {
    await this.drawn();
    const clip = { x: at.x - radius, y: at.y - radius, width: 2 * radius, height: 2 * radius };
    const style = 'c2-warp::part(handle) { opacity: 0 }';
    return this.page.screenshot({ clip, style });
  }

  /** Chooses files for the next question that `ask` leads to. */
  async choose(files: string | { name: string; mimeType: string; buffer: Buffer }): Promise<void> {
    const asked = this.page.waitForEvent('filechooser');
    await this.button('Open a picture or a project').click();
    await (await asked).setFiles(files);
  }

  async download(name: string): Promise<Download> {
    const started = this.page.waitForEvent('download');
    await this.button(name).click();
    return started;
  }
}

/** The bytes of a download. */
export async function bytes(download: Download): Promise<Buffer> {
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(Buffer.from(chunk));
  return Buffer.concat(chunks);
}

/** How far two pieces of what is drawn are apart: the mean over all channels, in 255ths. */
export function apart(a: Buffer, b: Buffer): number {
  const [left, right] = [decode(a).data, decode(b).data];
  let sum = 0;
  for (let at = 0; at < left.length; at++) sum += Math.abs((left[at] ?? 0) - (right[at] ?? 0));
  return sum / left.length;
}

/** Pieces closer than this show the same: compositing may round differently. */
export const SAME = 0.5;
