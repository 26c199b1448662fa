/** The editor as a person meets it: what the browser tests do on the page, through pointers, keys and labels alone. */

import { type Download, expect, type Locator, type Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { Handle } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';

export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A handle as its label tells it, image pixels and degrees. */
export interface Told extends Place {
  readonly rotation: number;
}

/** What the browser keeps of what is open, as a reload would bring it back. */
export interface KeptWork {
  /** Its name. */
  readonly picture: string;
  /** What undo would take back. */
  readonly step: string | null;
  readonly handles: readonly Handle[];
  readonly selection: readonly string[];
  /** Whether the guard against folds is on. */
  readonly guarded: boolean;
  /** Whether it is drawn as pixel art. */
  readonly pixelated: boolean;
  /** Bars and polygons that are not finished. */
  readonly drawings: readonly { readonly kind: string; readonly corners: readonly unknown[] }[];
}

export class Editor {
  readonly page: Page;
  readonly status: Locator;
  /** What the status line tells of the solution, or of the solve under way. */
  readonly solved: Locator;
  readonly notice: Locator;

  constructor(page: Page) {
    this.page = page;
    this.status = page.getByRole('group', { name: 'Status' });
    this.solved = page.locator('c2-warp .solved');
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
    await expect(this.solved).toContainText('sample');
  }

  /** Carries out what asks for another solve, and waits for that one: with another handle or density it tells of other numbers. */
  async solves(step: () => Promise<void>): Promise<void> {
    const before = await this.solved.textContent();
    await step();
    const anew = async () => {
      const told = await this.solved.textContent();
      return told !== before && /sample/.test(told ?? '');
    };
    await expect.poll(anew, 'another solution').toBe(true);
  }

  handle(name: string): Locator {
    return this.page.getByRole('button', { name: `Handle ${name}, ` });
  }

  get handles(): Locator {
    return this.page.getByRole('group', { name: 'Handles' }).getByRole('button');
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name });
  }

  field(name: 'x' | 'y' | 'rotation' | 'scale' | 'depth'): Locator {
    return this.page.getByRole('spinbutton', { name: `${name === 'rotation' ? 'turn' : name} (` });
  }

  async told(name: string): Promise<Told> {
    const label = (await this.handle(name).getAttribute('aria-label')) ?? '';
    const number = (word: string) => Number(label.match(new RegExp(`${word} (-?[\\d.]+)`))?.[1]);
    return { x: number('x'), y: number('y'), rotation: number('rotation') };
  }

  /** A corner of a bar or polygon, counted from 1. */
  corner(number: number, name: string): Locator {
    return this.page.getByRole('button', { name: `Corner ${number} of ${name}, ` });
  }

  switch(name: string): Locator {
    return this.page.getByRole('switch', { name });
  }

  /** Where a handle is on the page, CSS pixels. */
  place(name: string): Promise<Place> {
    return this.middle(this.handle(name));
  }

  /** The middle of what is shown, CSS pixels of the page. */
  async middle(shown: Locator): Promise<Place> {
    const box = await shown.boundingBox();
    if (!box) throw new Error(`${shown} is not shown`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** Where the picture's places are on the page, seen from a handle that rests at a known one. */
  async fromImage(name: string, rest: readonly [number, number]): Promise<(x: number, y: number) => Place> {
    const [at, scale] = [await this.place(name), await this.scale()];
    return (x, y) => ({ x: at.x + (x - rest[0]) * scale, y: at.y + (y - rest[1]) * scale });
  }

  /** CSS pixels per image pixel, exactly: from two handles of the sample, which has nothing moved yet. */
  async scale(): Promise<number> {
    const [left, right] = [await this.place('left hand'), await this.place('right hand')];
    return (right.x - left.x) / (900 - 124);
  }

  /** Where a point of the original goes. */
  mapped(x: number, y: number): Promise<readonly [number, number] | null> {
    return this.page
      .locator('c2-warp')
      .evaluate((element, point) => (element as C2Warp).mapPoint(point), [x, y] as const);
  }

  /** How far a point of the original is from a place of the bent picture, image pixels. */
  async away(from: readonly [number, number], to: readonly [number, number]): Promise<number> {
    const [x, y] = (await this.mapped(...from)) ?? [Number.POSITIVE_INFINITY, 0];
    return Math.hypot(x - to[0], y - to[1]);
  }

  /** One handle of the project as the page has it. */
  inProject(id: string): Promise<Handle | undefined> {
    return this.page
      .locator('c2-warp')
      .evaluate((element, id) => (element as C2Warp).project.handles.find((handle) => handle.id === id), id);
  }

  /** What is kept under this key now; empty where nothing is. Nothing on the page tells when something has been written. */
  kept(key = 'editor'): Promise<Partial<KeptWork>> {
    return this.page.evaluate(async (key): Promise<Partial<KeptWork>> => {
      const opening = indexedDB.open('c2warp');
      // The database is the editor's to make: an empty one that is made here would be in its way.
      opening.onupgradeneeded = () => opening.transaction?.abort();
      const answer = <T>(request: IDBRequest<T>) =>
        new Promise<T | null>((done) => {
          request.onsuccess = () => done(request.result);
          request.onerror = () => done(null);
        });
      const database = await answer(opening);
      if (!database) return {};
      const store = database.transaction('kept').objectStore('kept');
      const [picture, document] = await Promise.all(
        ['picture', 'document'].map((part) => answer(store.get(`${key}/${part}`))),
      );
      database.close();
      if (!picture || picture.mark !== document?.mark) return {};
      const { past, present } = document.record;
      const { project, selection } = present;
      const step = past.at(-1)?.label ?? null;
      const { guarded, pixelated, drawings } = document;
      return {
        picture: picture.name,
        step,
        handles: project.handles,
        selection,
        guarded,
        pixelated,
        drawings,
      };
    }, key);
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
    // Adopted, as the policy that the page is served under refuses a style element.
    await this.page.evaluate(() => {
      const bare = new CSSStyleSheet();
      bare.replaceSync('c2-warp::part(handle) { opacity: 0 }');
      document.adoptedStyleSheets = [bare];
    });
    const picture = await this.page.screenshot({ clip, caret: 'initial' });
    await this.page.evaluate(() => {
      document.adoptedStyleSheets = [];
    });
    return picture;
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
