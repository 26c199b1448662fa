/** The editor as its users see it: browser tests act through pointers, keys and labels. */

import { type Download, expect, type Locator, type Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { Handle } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { en } from '../../web/src/texts/en';
import { type Wording, worded } from '../../web/src/texts/wording';

export interface Position {
  readonly x: number;
  readonly y: number;
}

/** The pose in the label of a handle: image pixels and degrees. */
export interface ShownPose extends Position {
  readonly rotation: number;
}

/** The work that the browser has stored, and a reload restores. */
export interface StoredWork {
  /** The name of the picture. */
  readonly picture: string;
  /** The label of the step that undo reverts. */
  readonly step: string | null;
  readonly handles: readonly Handle[];
  readonly selection: readonly string[];
  /** Whether the fold guard is on. */
  readonly guarded: boolean;
  /** Whether handles snap to guides. */
  readonly snapping: boolean;
  /** Whether the picture is drawn as pixel art. */
  readonly pixelated: boolean;
  /** Whether a file holds the present project. */
  readonly saved: boolean;
  /** The choices for exports. */
  readonly exports: object;
  /** Unfinished drafts. */
  readonly drawings: readonly { readonly kind: string; readonly corners: readonly unknown[] }[];
}

export class Editor {
  readonly page: Page;
  readonly status: Locator;
  /** The part of the status line about the solution or the running solve. */
  readonly solved: Locator;
  readonly notice: Locator;

  constructor(page: Page) {
    this.page = page;
    this.status = page.getByRole('group', { name: 'Status' });
    this.solved = page.locator('c2-warp .solved');
    this.notice = page.getByRole('alert');
  }

  /** Opens the sample, and waits until it is solved. */
  static async open(page: Page): Promise<Editor> {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.goto('/');
    const editor = new Editor(page);
    await editor.ready();
    return editor;
  }

  /** Opens the editor, and its bent sample in a second tab too. */
  static async openTwice(page: Page): Promise<readonly [first: Editor, second: Editor]> {
    const first = await Editor.open(page);
    await first.dragHandle('left hand', { x: 20, y: -40 });
    await expect.poll(() => first.storedWork()).toMatchObject({ step: 'Move left hand' });
    const second = await Editor.open(await page.context().newPage());
    await expect(second.button('Undo: move left hand')).toBeEnabled();
    return [first, second];
  }

  async ready(): Promise<void> {
    await expect(this.handle('left hand')).toBeVisible();
    await expect(this.solved).toContainText('mesh point');
  }

  /** Runs a step that needs another solve, and waits until the status line shows other numbers. */
  async waitForSolve(step: () => Promise<void>): Promise<void> {
    const before = await this.solved.textContent();
    await step();
    const isOther = async () => {
      const text = await this.solved.textContent();
      return text !== before && /mesh point/.test(text ?? '');
    };
    await expect.poll(isOther, 'another solution').toBe(true);
  }

  handle(name: string): Locator {
    // A name that says the kind of the handle needs no other word.
    const label = /^(handle|point|bar|polygon) /.test(name) ? name : `Handle ${name}`;
    // From the start: the labels of corners end with the name of their handle.
    return this.page.getByRole('button', { name: new RegExp(`^${label}, `, 'i') });
  }

  get handles(): Locator {
    return this.page.getByRole('group', { name: 'Handles' }).getByRole('button');
  }

  button(name: string | RegExp): Locator {
    return this.page.getByRole('button', { name });
  }

  field(name: 'x' | 'y' | 'rotation' | 'scale' | 'depth'): Locator {
    return this.page.getByRole('spinbutton', { name: `${name} (` });
  }

  async shownPose(name: string): Promise<ShownPose> {
    const label = (await this.handle(name).getAttribute('aria-label')) ?? '';
    const number = (word: string) => Number(label.match(new RegExp(`${word} (-?[\\d.]+)`))?.[1]);
    return { x: number('x'), y: number('y'), rotation: number('rotation') };
  }

  /** A corner of a bar or polygon. Numbers start at 1. */
  corner(number: number, name: string): Locator {
    return this.page.getByRole('button', { name: `Corner ${number} of ${name}, ` });
  }

  switch(name: string): Locator {
    return this.page.getByRole('switch', { name });
  }

  /** Returns the position of a handle on the page, CSS pixels. */
  position(name: string): Promise<Position> {
    return this.centre(this.handle(name));
  }

  /** Returns the centre of a visible element, CSS pixels of the page. */
  async centre(shown: Locator): Promise<Position> {
    const box = await shown.boundingBox();
    if (!box) throw new Error(`${shown} is not visible`);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** Returns the map from image to page, by a handle at a known rest position. */
  async fromImage(
    name: string,
    rest: readonly [number, number],
  ): Promise<(x: number, y: number) => Position> {
    const [at, scale] = [await this.position(name), await this.scale()];
    return (x, y) => ({ x: at.x + (x - rest[0]) * scale, y: at.y + (y - rest[1]) * scale });
  }

  /** Returns the exact CSS pixels per image pixel, by two unmoved handles of the sample. */
  async scale(): Promise<number> {
    const [left, right] = [await this.position('left hand'), await this.position('right hand')];
    return (right.x - left.x) / (900 - 124);
  }

  /** Returns the posed position of a point of the original. */
  mapped(x: number, y: number): Promise<readonly [number, number] | null> {
    return this.page
      .locator('c2-warp')
      .evaluate((element, point) => (element as C2Warp).mapPoint(point), [x, y] as const);
  }

  /** Returns the distance of a point's posed position from a goal, image pixels. */
  async mappedDistance(from: readonly [number, number], to: readonly [number, number]): Promise<number> {
    const [x, y] = (await this.mapped(...from)) ?? [Number.POSITIVE_INFINITY, 0];
    return Math.hypot(x - to[0], y - to[1]);
  }

  /** Returns a handle of the project. */
  projectHandle(id: string): Promise<Handle | undefined> {
    return this.page
      .locator('c2-warp')
      .evaluate((element, id) => (element as C2Warp).project.handles.find((handle) => handle.id === id), id);
  }

  /** Returns the work stored under a key, or `{}`. The page does not signal writes, so tests must poll. */
  async storedWork(key = 'editor'): Promise<Partial<StoredWork>> {
    const stored = await this.page.evaluate(async (key) => {
      const opening = indexedDB.open('c2warp');
      // The editor must create the database: an empty one would lack its store.
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
      const step: Wording | null = past.at(-1)?.label ?? null;
      const { guarded, snapping, pixelated, exports, drawings } = document;
      return {
        picture: picture.name,
        step,
        handles: project.handles,
        selection,
        guarded,
        snapping,
        pixelated,
        saved: document.saved === project,
        exports,
        drawings,
      };
    }, key);
    return 'step' in stored ? { ...stored, step: stored.step && worded(en, stored.step) } : {};
  }

  /** Returns the displayed zoom: CSS pixels per image pixel. */
  async zoom(): Promise<number> {
    return (
      Number.parseFloat((await this.page.getByRole('status', { name: 'Zoom' }).textContent()) ?? '') / 100
    );
  }

  /** Asks until two consecutive answers, two frames apart, are equal. Returns the answer. */
  async settled<T>(ask: () => Promise<T>): Promise<T> {
    let before = await ask();
    await expect
      .poll(async () => {
        await this.waitFrames();
        const [last, now] = [before, await ask()];
        before = now;
        return JSON.stringify(now) === JSON.stringify(last);
      })
      .toBe(true);
    return before;
  }

  /** Waits two frames: one to pose, one to show. */
  async waitFrames(): Promise<void> {
    await this.page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
  }

  async drag(from: Position, by: Position): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(from.x + by.x / 2, from.y + by.y / 2);
    await mouse.move(from.x + by.x, from.y + by.y);
    await mouse.up();
  }

  /** Drags along places of the picture, image pixels. */
  async dragAlong(places: readonly (readonly [number, number])[]): Promise<void> {
    const shown = await this.page
      .locator('c2-warp')
      .evaluate(
        (element, places) => places.map((place) => (element as C2Warp).imageToClient(place) ?? [0, 0]),
        places,
      );
    for (const [k, [x, y]] of shown.entries()) {
      await this.page.mouse.move(x, y);
      if (k === 0) await this.page.mouse.down();
    }
    await this.page.mouse.up();
  }

  async dragHandle(name: string, by: Position): Promise<void> {
    await this.drag(await this.position(name), by);
  }

  /** Takes a screenshot around a position, without the handles. */
  async screenshot(at: Position, radius = 24): Promise<Buffer> {
    await this.waitFrames();
    const clip = { x: at.x - radius, y: at.y - radius, width: 2 * radius, height: 2 * radius };
    // Adopted, since the policy of the page forbids style elements.
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

  /** Presses the button to open files, and chooses these. */
  async chooseFile(files: string | { name: string; mimeType: string; buffer: Buffer }): Promise<void> {
    const chooser = this.page.waitForEvent('filechooser');
    const open = this.button('Open a picture or project');
    // On phones it is in the menu.
    if (!(await open.isVisible())) await this.button('Open recent work').click();
    await open.click();
    await (await chooser).setFiles(files);
  }

  /** Reopens recent work by its menu. */
  async openRecent(name: string): Promise<void> {
    await this.button('Open recent work').click();
    await this.page
      .getByRole('dialog', { name: 'Open recent work' })
      .getByRole('button', { name })
      .first()
      .click();
  }

  /** Opens the export panel and presses its button. */
  async pressExport(): Promise<void> {
    await this.button('Export as …').click();
    await this.button(/^Export (PNG|JPEG|WebP)$/).click();
  }

  /** Exports by the present choices. */
  async exported(): Promise<Download> {
    const started = this.page.waitForEvent('download');
    await this.pressExport();
    return started;
  }

  async download(name: string): Promise<Download> {
    const started = this.page.waitForEvent('download');
    await this.button(name).click();
    return started;
  }
}

/** Returns the bytes of a download. */
export async function bytes(download: Download): Promise<Buffer> {
  const chunks: Buffer[] = [];
  for await (const chunk of await download.createReadStream()) chunks.push(Buffer.from(chunk));
  return Buffer.concat(chunks);
}

/** Returns the mean difference of two screenshots over all channels, in 255ths. */
export function meanDifference(a: Buffer, b: Buffer): number {
  const [left, right] = [decode(a).data, decode(b).data];
  let sum = 0;
  for (let at = 0; at < left.length; at++) sum += Math.abs((left[at] ?? 0) - (right[at] ?? 0));
  return sum / left.length;
}

/** Screenshots closer than this are equal: compositing can round differently. */
export const SAME = 0.5;
