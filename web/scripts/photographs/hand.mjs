/// <reference lib="dom" />
/**
 * A hand on the editor: it opens photographs and edits them by the pointer and the keyboard, as people do. Places are
 * pixels of the picture. The element only says where they lie on the screen.
 */
import { readFileSync } from 'node:fs';

/** @typedef {readonly [x: number, y: number]} Place Pixels of the picture. */

/** Pixels on screen between the middle of a selection and its ring. */
const RING = 40;
/** A drag is this many moves of the pointer. */
const MOVES = 12;
const VIEWPORT = { width: 1400, height: 1000 };

export class Hand {
  /** @param {import('@playwright/test').Page} page */
  constructor(page) {
    this.page = page;
  }

  /**
   * Opens a picture in a fresh editor.
   * @param {import('@playwright/test').Browser} browser
   * @param {string} address
   * @param {string | { name: string, mimeType: string, buffer: Buffer }} file
   */
  static async open(browser, address, file) {
    const context = await browser.newContext({ viewport: VIEWPORT, reducedMotion: 'reduce' });
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    // Playwright can watch uploads and downloads, but not the pickers of files.
    await page.addInitScript(() => {
      Reflect.deleteProperty(globalThis, 'showOpenFilePicker');
      Reflect.deleteProperty(globalThis, 'showSaveFilePicker');
    });
    const hand = new Hand(page);
    await page.goto(address);
    await page.getByText(/[0-9] samples/).waitFor();
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('button', { name: 'Open a picture or project' }).click();
    const bytes = typeof file === 'string' ? readFileSync(file) : file.buffer;
    const { width, height } = await hand.sizeOf(bytes);
    await (await chooser).setFiles(typeof file === 'string' ? file : { ...file });
    await page.locator('c2-warp .solved', { hasText: `${width} × ${height} px` }).waitFor();
    await hand.idle();
    // The bar of a drawing would cover the bottom of a picture that fits.
    await hand.key('-');
    await hand.frames(2);
    return hand;
  }

  close() {
    return this.page.context().close();
  }

  /**
   * The size of a picture.
   * @param {Buffer} bytes
   */
  sizeOf(bytes) {
    return this.page.evaluate(async (base64) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:;base64,${base64}`)).blob());
      return { width: bitmap.width, height: bitmap.height };
    }, bytes.toString('base64'));
  }

  /** Waits until nothing is solved or filled any more. */
  async idle() {
    for (let calm = 0; calm < 3; ) {
      const text = (await this.page.locator('c2-warp .solved').textContent()) ?? '';
      calm = /[0-9] sample/.test(text) ? calm + 1 : 0;
      await this.frames(2);
    }
  }

  /** @param {number} count */
  async frames(count) {
    await this.page.evaluate(async (count) => {
      for (let k = 0; k < count; k++) await new Promise((done) => requestAnimationFrame(done));
    }, count);
  }

  /** @param {Place} place @returns {Promise<{ x: number, y: number }>} */
  async screen(place) {
    const [x, y] = await this.page.evaluate(
      (place) => /** @type {any} */ (document.querySelector('c2-warp')).imageToClient(place),
      place,
    );
    return { x, y };
  }

  /** @param {Place} place */
  async click(place) {
    const { x, y } = await this.screen(place);
    await this.page.mouse.move(x, y, { steps: 3 });
    await this.frames(1);
    await this.page.mouse.click(x, y);
  }

  /** @param {string} key */
  key(key) {
    return this.page.keyboard.press(key);
  }

  /** @param {string | RegExp} name */
  async press(name) {
    await this.page.getByRole('button', { name }).first().click();
    await this.idle();
  }

  /**
   * Draws a lasso by a click for each corner.
   * @param {readonly Place[]} corners
   * @param {{ snap?: boolean, close?: boolean }} [options] Whether the line between corners follows edges, and
   * whether the outline is closed at the end.
   */
  async lasso(corners, { snap = true, close = true } = {}) {
    await this.key('l');
    const edges = this.page.getByRole('switch', { name: 'Snap to edges' }).first();
    await edges.waitFor();
    if ((await edges.getAttribute('aria-checked')) !== String(snap)) await edges.click();
    if (snap) await this.page.locator('c2-warp [role=switch][aria-busy=false]').first().waitFor();
    for (const corner of corners) await this.click(corner);
    if (!close) return;
    await this.key('Enter');
    await this.idle();
  }

  /** @param {string} name @param {boolean} on */
  async setSwitch(name, on) {
    await this.key('Escape');
    const control = this.page.getByRole('switch', { name });
    if ((await control.getAttribute('aria-checked')) !== String(on)) await control.click();
    await this.idle();
  }

  /** Places point handles. @param {...Place} places */
  async points(...places) {
    await this.key('p');
    for (const place of places) {
      await this.click(place);
      await this.idle();
    }
    await this.key('v');
  }

  /** Draws a bar. @param {...Place} corners */
  async bar(...corners) {
    await this.key('b');
    for (const corner of corners) await this.click(corner);
    await this.key('Enter');
    await this.idle();
    await this.key('v');
  }

  /** Drags from a place to another. @param {Place} from @param {Place} to */
  async drag(from, to) {
    const [a, b] = [await this.screen(from), await this.screen(to)];
    const { mouse } = this.page;
    await mouse.move(a.x, a.y);
    await mouse.down();
    await mouse.move(b.x, b.y, { steps: MOVES });
    await this.frames(2);
    await mouse.up();
    await this.idle();
  }

  /** The middle of a handle, in the picture. @param {string} name @returns {Promise<Place>} */
  async middle(name) {
    const box = await this.page.getByRole('button', { name: new RegExp(`^${name}, `, 'i') }).boundingBox();
    if (!box) throw new Error(`${name} is not on screen`);
    const place = [box.x + box.width / 2, box.y + box.height / 2];
    const [zero, one] = [await this.screen([0, 0]), await this.screen([1, 0])];
    const scale = one.x - zero.x;
    return [((place[0] ?? 0) - zero.x) / scale, ((place[1] ?? 0) - zero.y) / scale];
  }

  /** Selects the handle in the middle, and turns it by its ring. @param {Place} middle @param {number} degrees */
  async turn(middle, degrees) {
    await this.click(middle);
    const { x, y } = await this.screen(middle);
    const { mouse } = this.page;
    const at = (/** @type {number} */ turn) =>
      /** @type {const} */ ([x + RING * Math.sin(turn), y - RING * Math.cos(turn)]);
    await mouse.move(...at(0));
    await mouse.down();
    for (let k = 1; k <= MOVES; k++) await mouse.move(...at((degrees * Math.PI * k) / (180 * MOVES)));
    await this.frames(2);
    await mouse.up();
    await this.idle();
  }

  /** Exports a PNG at full size, and returns its bytes. */
  async export() {
    await this.key('Escape');
    const started = this.page.waitForEvent('download');
    await this.page.getByRole('button', { name: 'Export as …' }).click();
    await this.page.getByRole('button', { name: /^Export (PNG|JPEG|WebP)$/ }).click();
    const chunks = [];
    for await (const chunk of await (await started).createReadStream()) chunks.push(Buffer.from(chunk));
    return Buffer.concat(chunks);
  }
}
