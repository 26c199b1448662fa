/** Opening and writing pictures: exact bytes, and clear errors for invalid files. */
import { expect, test } from './fixtures';

test.beforeEach(async ({ page }) => {
  await page.goto('/harness/');
});

for (const [title, rounds] of [
  ['a PNG', false],
  ['with bitmaps that round colours, a PNG', true],
] as const)
  test(`${title} keeps its bytes when read and written`, async ({ page }) => {
    const differing = await page.evaluate(async (rounds) => {
      // As in WebKit: bitmaps requested without premultiplying were premultiplied before.
      const create = globalThis.createImageBitmap.bind(globalThis);
      const premultiplied = (source: ImageBitmapSource) =>
        create(source, { premultiplyAlpha: 'premultiply' });
      if (rounds) Object.assign(globalThis, { createImageBitmap: premultiplied });
      // Wider than one tile of the reader, with every value of every channel.
      const [width, height] = [2100, 3];
      const rgba = Uint8Array.from({ length: width * height * 4 }, (_, i) => (i * 7919) >> 3);
      const given = rgba.slice();
      const file = await harness.encodePng(width, height, given);
      // Hundreds of megabytes must be transferred, not copied.
      if (given.length > 0) return -2;
      const picture = await harness.decodePicture(file);
      return picture.width === width && picture.height === height
        ? picture.rgba.reduce((count, value, i) => count + (value === rgba[i] ? 0 : 1), 0)
        : -1;
    }, rounds);
    expect(differing).toBe(0);
  });

for (const browser of ['a photograph', 'a photograph that the browser makes no bitmap of'])
  test(`${browser} is opened upright`, async ({ page }) => {
    const [width, height, decoded] = await page.evaluate(async (makes) => {
      let decoded = 0;
      // As in Firefox with some EXIF data.
      const create = globalThis.createImageBitmap.bind(globalThis);
      const made = (source: ImageBitmapSource, options: ImageBitmapOptions) => {
        if (source instanceof Blob && !makes) return Promise.reject(new DOMException('not decoded'));
        decoded++;
        return create(source, options);
      };
      Object.assign(globalThis, { createImageBitmap: made });
      const canvas = new OffscreenCanvas(40, 20);
      canvas.getContext('2d')?.fillRect(0, 0, 20, 20);
      const jpeg = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/jpeg' })).arrayBuffer());
      // An EXIF segment with the orientation: turned by 90°.
      const tiff = [
        0x4d, 0x4d, 0, 42, 0, 0, 0, 8, 0, 1, 0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0,
      ];
      const exif = [0x45, 0x78, 0x69, 0x66, 0, 0, ...tiff];
      const segment = Uint8Array.from([0xff, 0xe1, 0, exif.length + 2, ...exif]);
      const picture = await harness.decodePicture(new Blob([jpeg.slice(0, 2), segment, jpeg.slice(2)]));
      return [picture.width, picture.height, decoded];
    }, browser === 'a photograph');
    expect([width, height]).toEqual([20, 40]);
    // A JPEG has no alpha, so one bitmap is both shown and read.
    expect(decoded).toBe(1);
  });

test('the editor decodes pictures in a worker, with the same result as the page', async ({ page }) => {
  const { differing, inPage, inWorker } = await page.evaluate(async () => {
    const file = await harness.drawnPicture(300);
    const { bitmap: _, preview: __, rgba: expected, ...decoded } = await harness.decodePicture(file);
    const stop = () => Promise.reject(new Error('the page decoded it'));
    Object.assign(globalThis, { createImageBitmap: stop });
    const { rgba, ...opened } = await harness.openedPicture(file);
    return {
      differing: rgba.reduce((count, value, i) => count + (value === expected[i] ? 0 : 1), 0),
      inPage: decoded,
      inWorker: opened,
    };
  });
  expect(differing).toBe(0);
  expect(inWorker).toMatchObject({
    width: inPage.width,
    height: inPage.height,
    shown: [300, 300],
    previewed: null,
  });
});

test('without a worker the page decodes pictures', async ({ page }) => {
  const size = await page.evaluate(async () => {
    const denied = class {
      constructor() {
        throw new DOMException('denied', 'SecurityError');
      }
    };
    Object.assign(globalThis, { Worker: denied });
    const { width, rgba } = await harness.openedPicture(await harness.drawnPicture(64));
    return [width, rgba.length];
  });
  expect(size).toEqual([64, 64 * 64 * 4]);
});

test('a picture beyond the largest texture is shown smaller, and keeps its pixels', async ({ page }) => {
  const { width, length, shown, previewed, last } = await page.evaluate(async () => {
    const [width, height] = [12_000, 500];
    const pixels = new Uint8Array(width * height * 4).fill(255);
    pixels.set([1, 2, 3, 255], pixels.length - 4);
    const file = await harness.encodePng(width, height, pixels);
    const { rgba, shown, previewed } = await harness.openedPicture(file);
    return { width, length: rgba.length, shown, previewed, last: [...rgba.slice(-4)] };
  });
  expect(length).toBe(width * 500 * 4);
  expect(last).toEqual([1, 2, 3, 255]);
  // The software renderer of the tests has textures of 8,192 px.
  expect(shown?.[0]).toBe(8192);
  expect(previewed).toBeNull();
});

test('reading a picture can be stopped', async ({ page }) => {
  const name = await page.evaluate(async () => {
    const reading = new AbortController();
    const opened = harness.openedPicture(await harness.drawnPicture(2000), reading.signal);
    reading.abort();
    return opened.then(
      () => 'opened',
      (error: Error) => error.name,
    );
  });
  expect(name).toBe('AbortError');
});

test('a PNG worker that fails is replaced', async ({ page }) => {
  const [message, ended, size] = await page.evaluate(async () => {
    let ended = 0;
    const { terminate } = Worker.prototype;
    Worker.prototype.terminate = function () {
      ended += 1;
      terminate.call(this);
    };
    const refused = await harness.encodePng(4, 4, new Uint8Array(3)).catch((error: Error) => error.message);
    const file = await harness.encodePng(4, 4, new Uint8Array(64));
    return [refused, ended, file.size] as const;
  });
  expect(message).toMatch(/^Could not write the PNG/);
  expect(ended).toBe(1);
  expect(size).toBeGreaterThan(50);
});

test('a picture with unreadable pixels is rejected, and its bitmaps closed', async ({ page }) => {
  const { message, open } = await page.evaluate(async () => {
    const opened: ImageBitmap[] = [];
    const create = globalThis.createImageBitmap.bind(globalThis) as (blob: Blob) => Promise<ImageBitmap>;
    Object.assign(globalThis, {
      createImageBitmap: async (...given: Parameters<typeof create>) => {
        const bitmap = await create(...given);
        opened.push(bitmap);
        return bitmap;
      },
    });
    // As in browsers with too many contexts or a failing graphics driver.
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, kind: 'webgl2') {
        const gl = getContext.call(this, kind) as WebGL2RenderingContext | null;
        if (kind === 'webgl2') gl?.getExtension('WEBGL_lose_context')?.loseContext();
        return gl;
      },
    });
    const file = await harness.drawnPicture(64);
    const message = await harness.decodePicture(file).then(
      () => 'it was opened',
      (error: Error) => error.message,
    );
    return { message, open: opened.filter(({ width }) => width > 0).length };
  });
  expect(message).toMatch(/graphics/);
  expect(open).toBe(0);
});

const REFUSED: [title: string, make: () => Promise<Blob> | Blob, message: RegExp][] = [
  ['an empty file', () => new Blob([]), /^The file is empty\.$/],
  [
    'a text file',
    () => new Blob(['hello, I am no picture']),
    /^This browser cannot read the file as a picture/,
  ],
  [
    'a TIFF picture',
    () => new Blob(['II*\0\b\0\0\0']),
    /^This is a TIFF picture\. Save it as PNG, JPEG or WebP\.$/,
  ],
  [
    'an SVG drawing',
    () => new Blob(['<svg xmlns="http://www.w3.org/2000/svg"/>']),
    /^This is an SVG drawing\. Save it as PNG, JPEG or WebP\.$/,
  ],
  [
    'a PNG cut short',
    async () => (await harness.drawnPicture()).slice(0, 2000),
    /^The picture is incomplete/,
  ],
  [
    'a JPEG cut short',
    async () => {
      const canvas = new OffscreenCanvas(300, 300);
      canvas.getContext('2d')?.fillRect(0, 0, 90, 200);
      return (await canvas.convertToBlob({ type: 'image/jpeg' })).slice(0, -200);
    },
    /^The picture is incomplete/,
  ],
  [
    'a damaged PNG',
    async () => {
      const bytes = new Uint8Array(await (await harness.drawnPicture()).arrayBuffer());
      return new Blob([bytes.fill(0, 200, 1200)]);
    },
    /^The picture is damaged/,
  ],
  ['one pixel', () => harness.encodePng(1, 1, new Uint8Array(4)), /1 × 1 px\. It must be at least 2 × 2/],
  [
    'a strip of 20,000 × 20 px',
    () => harness.encodePng(20_000, 20, new Uint8Array(20_000 * 20 * 4)),
    /20000 × 20 px\. Each side can be at most 16,384 px/,
  ],
];

for (const [title, make, message] of REFUSED) {
  test(`${title} is rejected with a clear message`, async ({ page }) => {
    const file = await page.evaluateHandle(make);
    const error = await file.evaluate((blob) =>
      harness.decodePicture(blob).then(
        () => ({ code: 'none', message: 'it was opened' }),
        (reason: Error & { code?: string }) => ({ code: reason.code, message: reason.message }),
      ),
    );
    expect(error.message).toMatch(message);
    expect(error.code).toBe('picture');
  });
}
