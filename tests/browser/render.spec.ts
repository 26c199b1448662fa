/** The WebGL renderer alone, on meshes with known results. */
import { expect, test } from './fixtures';
import { posedByFormula } from './formula';

test.beforeEach(async ({ page }) => {
  await page.goto('/harness/');
});

test('a large picture is drawn from its preview until its last part is uploaded', async ({ page }) => {
  const colours = await page.evaluate(async () => {
    const filled = async (width: number, height: number, colour: string) => {
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext('2d');
      if (!context) throw new Error('no 2D canvas');
      context.fillStyle = colour;
      context.fillRect(0, 0, width, height);
      return createImageBitmap(canvas);
    };
    const renderer = new harness.Renderer(document.createElement('canvas'));
    const [bitmap, preview] = [await filled(2500, 2000, '#0f0'), await filled(50, 40, '#f00')];
    renderer.setPicture({ width: 5000, height: 4000, bitmap, preview });
    const view = { scale: 0.01, x: 0, y: 0, width: 50, height: 40 };
    const shown = () => [...renderer.readPixels(view).slice(4 * 1025, 4 * 1025 + 4)];
    const colours = [shown()];
    let parts = 0;
    while (renderer.isLoading) {
      renderer.load();
      parts += 1;
    }
    return [...colours, [parts], shown()];
  });
  expect(colours).toEqual([[255, 0, 0, 255], [3], [0, 255, 0, 255]]);
});

test('a large picture that moves is drawn from the level that fits', async ({ page }) => {
  const { softened, lightened, left } = await page.evaluate(async () => {
    // Squares of 8 pixels: a quarter of the size shows them, with soft edges from a coarser level.
    const size = 2048;
    const canvas = new OffscreenCanvas(size, size);
    const context = canvas.getContext('2d');
    if (!context) throw new Error('no 2D canvas');
    context.fillRect(0, 0, size, size);
    context.fillStyle = '#fff';
    for (let y = 0; y < size; y += 8)
      for (let x = (y / 8) % 2 ? 8 : 0; x < size; x += 16) context.fillRect(x, y, 8, 8);
    const renderer = new harness.Renderer(document.createElement('canvas'));
    const bitmap = await createImageBitmap(canvas);
    renderer.setPicture({ width: size, height: size, bitmap, preview: null });
    // Not a power of 2, so that rest blends two levels.
    const view = { scale: 0.18, x: 0, y: 0, width: 368, height: 368 };
    const drawn = (moving: boolean) => renderer.readPixels({ ...view, moving });
    const mean = (values: Uint8Array) => values.reduce((sum, value) => sum + value, 0) / values.length;
    const apart = (a: Uint8Array, b: Uint8Array) =>
      mean(a.map((value, at) => Math.abs(value - (b[at] ?? 0))));
    const [resting, moving, again] = [drawn(false), drawn(true), drawn(false)];
    return {
      softened: apart(moving, resting),
      lightened: mean(moving) - mean(resting),
      left: apart(again, resting),
    };
  });
  expect(softened).toBeGreaterThan(0);
  // Only the sharpness changes, not how light the picture is.
  expect(Math.abs(lightened)).toBeLessThan(1);
  expect(left).toBe(0);
});

test('draws the unwarped picture without a solution', async ({ page }) => {
  const differing = await page.evaluate(async () => {
    const picture = await harness.decodePicture(await harness.drawnPicture(64));
    const { rgba } = picture;
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    const drawn = renderer.readPixels({ scale: 1, x: 0, y: 0, width: 64, height: 64 });
    return drawn.filter((value, i) => {
      const alpha = (rgba[i | 3] ?? 0) / 255;
      return Math.abs(value - (rgba[i] ?? 0) * (i % 4 === 3 ? 1 : alpha)) > 1;
    }).length;
  });
  expect(differing).toBe(0);
});

test('blends motions by weight, and keeps vertices without weights (eq. 1)', async ({ page }) => {
  const corners = await page.evaluate(async () => {
    const white = await harness.encodePng(8, 8, new Uint8Array(256).fill(255));
    const picture = await harness.decodePicture(white);
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    // Two separate triangles. The first blends a shift by (16, 0) at 1/4 with one by (0, 16) at 3/4; the second rests.
    renderer.setSolution({
      positions: new Float32Array([0, 0, 8, 0, 0, 8, 24, 24, 32, 24, 24, 32]),
      triangles: new Uint32Array([0, 1, 2, 3, 4, 5]),
      offsets: new Uint32Array([0, 2, 4, 6, 6, 6, 6]),
      sites: new Uint32Array([0, 1, 0, 1, 0, 1]),
      weights: new Float32Array([0.25, 0.75, 0.25, 0.75, 0.25, 0.75]),
      siteRest: [0, 0, 3, 3],
    });
    renderer.setMotions(
      new Float32Array([1, 0, 0, 1, 0, 0, 16, 0, 0, 0, 0, 0, 1, 0, 0, 1, 3, 3, 3, 19, 0, 0, 0, 0]),
    );
    const pixels = renderer.readPixels({ scale: 1, x: 0, y: 0, width: 40, height: 40 });
    const alphaAt = (x: number, y: number) => pixels[(y * 40 + x) * 4 + 3];
    return [alphaAt(1, 1), alphaAt(5, 13), alphaAt(3, 13), alphaAt(5, 11), alphaAt(25, 25), alphaAt(23, 25)];
  });
  expect(corners).toEqual([0, 255, 0, 0, 255, 0]);
});

test('turns clockwise for positive angles, about the site’s rest position', async ({ page }) => {
  const drawn = await page.evaluate(async () => {
    const rgba = new Uint8Array(16 * 16 * 4);
    // A red mark right of the centre.
    for (let y = 7; y < 9; y++) for (let x = 12; x < 14; x++) rgba.set([255, 0, 0, 255], (y * 16 + x) * 4);
    const picture = await harness.decodePicture(await harness.encodePng(16, 16, rgba));
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    renderer.setSolution({
      positions: new Float32Array([0, 0, 16, 0, 0, 16, 16, 16]),
      triangles: new Uint32Array([0, 1, 2, 2, 1, 3]),
      offsets: new Uint32Array([0, 1, 2, 3, 4]),
      sites: new Uint32Array(4),
      weights: new Float32Array(4).fill(1),
      siteRest: [8, 8],
    });
    renderer.setMotions(new Float32Array([0, 1, -1, 0, 8, 8, 8, 8, 0, 0, 0, 0]));
    const pixels = renderer.readPixels({ scale: 1, x: 0, y: 0, width: 16, height: 16 });
    return [pixels[(12 * 16 + 8) * 4], pixels[(8 * 16 + 12) * 4]];
  });
  expect(drawn).toEqual([255, 0]);
});

test('leaves no seam between triangles', async ({ page }) => {
  const holes = await page.evaluate(async () => {
    const white = await harness.encodePng(8, 8, new Uint8Array(256).fill(255));
    const picture = await harness.decodePicture(white);
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    const [positions, triangles]: number[][] = [[], []];
    const n = 20;
    for (let j = 0; j <= n; j++) {
      for (let i = 0; i <= n; i++) {
        positions?.push((8 * (i + 0.3 * Math.sin(j))) / n, (8 * (j + 0.3 * Math.sin(2 * i))) / n);
        const v = j * (n + 1) + i;
        if (i < n && j < n) triangles?.push(v, v + 1, v + n + 1, v + n + 1, v + 1, v + n + 2);
      }
    }
    renderer.setSolution({
      positions: new Float32Array(positions ?? []),
      triangles: new Uint32Array(triangles ?? []),
      offsets: new Uint32Array((n + 1) ** 2 + 1),
      sites: new Uint32Array(),
      weights: new Float32Array(),
      siteRest: [],
    });
    const pixels = renderer.readPixels({ scale: 20.3, x: -20, y: -20, width: 120, height: 120 });
    return pixels.filter((value) => value !== 255).length;
  });
  expect(holes).toBe(0);
});

test('draws pixels as squares above 400 %, or on request', async ({ page }) => {
  const { row, soft, pixelated } = await page.evaluate(async () => {
    const rgba = Uint8Array.from({ length: 64 }, (_, i) => (i % 4 === 3 || (i >> 2) % 2 ? 255 : 0));
    const picture = await harness.decodePicture(await harness.encodePng(4, 4, rgba));
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    const drawn = (scale: number, pixelated?: boolean) => {
      const size = 4 * scale;
      const view = { scale, x: 0, y: 0, width: size, height: size, ...(pixelated && { pixelated }) };
      const pixels = renderer.readPixels(view);
      return Array.from({ length: size }, (_, x) => pixels[x * 4]);
    };
    return { row: drawn(5), soft: drawn(3), pixelated: drawn(3, true) };
  });
  const squares = (side: number) =>
    [0, 255, 0, 255].flatMap((value) => Array.from({ length: side }, () => value));
  expect(row).toEqual(squares(5));
  expect(pixelated).toEqual(squares(3));
  expect(soft).not.toEqual(pixelated);
});

test('draws the same after a context loss', async ({ page }) => {
  const result = await page.evaluate(async () => {
    const picture = await harness.decodePicture(await harness.drawnPicture(64));
    const canvas = document.createElement('canvas');
    const renderer = new harness.Renderer(canvas);
    renderer.setPicture(picture);
    renderer.setSolution({
      positions: new Float32Array([0, 0, 64, 0, 0, 64, 64, 64]),
      triangles: new Uint32Array([0, 1, 2, 2, 1, 3]),
      offsets: new Uint32Array([0, 1, 2, 3, 3]),
      sites: new Uint32Array(3),
      weights: new Float32Array(3).fill(1),
      siteRest: [32, 32],
    });
    renderer.setMotions(new Float32Array([0.9, 0.2, -0.3, 1.1, 32, 32, 35, 30, 0, 0, 0, 0]));
    renderer.setHeat({ values: Float32Array.of(0, 1, 0, 1), lines: true });
    const view = { scale: 1, x: 0, y: 0, width: 64, height: 64, overlays: { mesh: true } };
    const before = renderer.readPixels(view);
    const control = canvas.getContext('webgl2')?.getExtension('WEBGL_lose_context');
    const lost = new Promise((resolve) => canvas.addEventListener('webglcontextlost', resolve));
    control?.loseContext();
    await lost;
    // The browser allows a restore only after the event.
    await new Promise((resolve) => setTimeout(resolve, 50));
    const whileLost = renderer.lost;
    renderer.draw(view);
    const restored = new Promise<void>((resolve) => {
      renderer.onrestore = resolve;
    });
    control?.restoreContext();
    await restored;
    const after = renderer.readPixels(view);
    return {
      whileLost,
      afterwards: renderer.lost,
      blank: before.every((value) => value === 0),
      differing: after.filter((value, i) => value !== before[i]).length,
    };
  });
  expect(result).toEqual({ whileLost: true, afterwards: false, blank: false, differing: 0 });
});

test('many renderers share few contexts, and survive sleep and context loss', async ({ page }) => {
  const { contexts, drawn, asleep, woken, restored } = await page.evaluate(async () => {
    const contexts: WebGL2RenderingContext[] = [];
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, ...given: Parameters<typeof getContext>) {
        const context = getContext.apply(this, given);
        if (context instanceof WebGL2RenderingContext) contexts.push(context);
        return context;
      },
    });
    const view = { scale: 1, x: 0, y: 0, width: 8, height: 8 };
    const made = Array.from({ length: 20 }, async (_, shade) => {
      const rgba = Uint8Array.from({ length: 256 }, (_, i) => (i % 4 === 3 ? 255 : 10 * shade));
      const picture = await harness.decodePicture(await harness.encodePng(8, 8, rgba));
      const canvas = document.createElement('canvas');
      const renderer = new harness.Renderer(canvas);
      renderer.setPicture(picture);
      return { canvas, renderer };
    });
    const all = await Promise.all(made);
    const shades = () =>
      all.map(({ canvas }) => {
        const copy = new OffscreenCanvas(8, 8).getContext('2d');
        copy?.drawImage(canvas, 0, 0);
        return (copy?.getImageData(4, 4, 1, 1).data[0] ?? 0) / 10;
      });
    const draw = () => {
      for (const { renderer } of all) renderer.draw(view);
    };
    draw();
    const drawn = shades();
    for (const { renderer } of all) renderer.sleep();
    const asleep = shades();
    for (const { renderer } of all) renderer.wake();
    draw();
    const woken = shades();
    const control = contexts.map((gl) => gl.getExtension('WEBGL_lose_context'));
    for (const one of control) one?.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 50));
    const restoring = all.map(
      ({ renderer }) =>
        new Promise<void>((resolve) => {
          renderer.onrestore = resolve;
        }),
    );
    for (const one of control) one?.restoreContext();
    await Promise.all(restoring);
    draw();
    return { contexts: contexts.length, drawn, asleep, woken, restored: shades() };
  });
  const each = Array.from({ length: 20 }, (_, shade) => shade);
  // One of the contexts reads pictures.
  expect(contexts).toBeLessThanOrEqual(6);
  for (const shown of [drawn, asleep, woken, restored]) expect(shown).toEqual(each);
});

test('draws a heat map with isolines at tenths and a bold one at one half', async ({ page }) => {
  const { row, beside, off, refused } = await page.evaluate(async () => {
    // Grey on the left four fifths, transparent on the rest.
    const rgba = Uint8Array.from(
      { length: 10 * 2 * 4 },
      (_, at) => ((at >> 2) % 10 < 8 ? [128, 128, 128, 255] : [0, 0, 0, 0])[at % 4] ?? 0,
    );
    const picture = await harness.decodePicture(await harness.encodePng(10, 2, rgba));
    const renderer = new harness.Renderer(document.createElement('canvas'));
    renderer.setPicture(picture);
    renderer.setSolution({
      positions: new Float32Array([0, 0, 10, 0, 0, 2, 10, 2]),
      triangles: new Uint32Array([0, 1, 2, 2, 1, 3]),
      offsets: new Uint32Array(5),
      sites: new Uint32Array(),
      weights: new Float32Array(),
      siteRest: [],
    });
    const view = { scale: 40, x: 0, y: 0, width: 400, height: 80 };
    const before = renderer.readPixels(view);
    renderer.setHeat({ values: Float32Array.of(0, 1.25, 0, 1.25), lines: true });
    const pixels = renderer.readPixels(view);
    const at = (x: number) => Array.from(pixels.subarray((40 * 400 + x) * 4, (40 * 400 + x) * 4 + 4));
    renderer.setHeat(null);
    const after = renderer.readPixels(view);
    let refused = '';
    try {
      renderer.setHeat({ values: new Float32Array(3), lines: true });
    } catch (error) {
      refused = String(error);
    }
    return {
      row: Array.from({ length: 320 }, (_, x) => at(x)),
      beside: at(380),
      off: after.every((value, i) => value === before[i]),
      refused,
    };
  });
  // A tenth is 32 px: at x the heat is x / 320.
  const light = (x: number) => (row[x] ?? []).slice(0, 3).reduce((sum, value) => sum + value, 0);
  expect(Math.abs(light(0) - 3 * 128)).toBeLessThan(12);
  const [red = 0, green = 0, blue = 0, alpha] = row[318] ?? [];
  expect(red).toBeGreaterThan(200);
  expect(green).toBeGreaterThan(200);
  expect(blue).toBeLessThan(120);
  expect(alpha).toBe(255);
  /** Returns the range of lightness around a position: a line is dark between pale edges. */
  const contrast = (tenth: number) => {
    const lights = [-4, -3, -2, -1, 0, 1, 2, 3].map((by) => light(32 * tenth + by));
    return Math.max(...lights) - Math.min(...lights);
  };
  for (let tenth = 1; tenth <= 9; tenth++) {
    expect(contrast(tenth), `line ${tenth}`).toBeGreaterThan(contrast(tenth + 0.5) + 60);
  }
  expect(contrast(5)).toBeGreaterThan(1.5 * Math.max(contrast(4), contrast(6)));
  expect(beside).toEqual([0, 0, 0, 0]);
  expect(off).toBe(true);
  expect(refused).toContain('Expected 4 heat values, one per vertex, found 3');
});

for (const blend of ['linear', 'rigid'] as const) {
  test(`the ${blend} blend is exact to 0.02 px at 6,000 px`, async ({ page }) => {
    // A large picture, turned and stretched from all corners. Each pixel of the 64 px view is a hundredth of a pixel.
    const motion = (x: number, y: number, angle: number) => {
      const [cos, sin, half] = [Math.cos(angle), Math.sin(angle), angle / 2];
      const linear = [1.1 * cos, 1.1 * sin, -0.9 * sin, 0.9 * cos];
      return [...linear, x, y, x + 31.7, y - 18.3, 0, angle, Math.cos(half), Math.sin(half)];
    };
    const corners = [motion(0, 0, 0.4), motion(6000, 0, -0.7), motion(0, 6000, 1.1), motion(6000, 6000, 0.2)];
    const mesh = {
      positions: Float32Array.of(5731.3, 5877.7, 4000, 5900, 5500, 4100),
      triangles: Uint32Array.of(0, 1, 2),
      offsets: Uint32Array.of(0, 4, 8, 12),
      sites: Uint32Array.of(0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3),
      weights: Float32Array.of(0.4, 0.3, 0.2, 0.1, 0.4, 0.3, 0.2, 0.1, 0.4, 0.3, 0.2, 0.1),
    };
    const motions = Float32Array.from(corners.flat());
    const posed = posedByFormula(mesh, motions, blend);
    const [px = 0, py = 0] = posed;
    const alphas = await page.evaluate(
      async ({ mesh, motions, blend, px, py }) => {
        const white = await harness.encodePng(8, 8, new Uint8Array(256).fill(255));
        const picture = await harness.decodePicture(white);
        const renderer = new harness.Renderer(document.createElement('canvas'));
        renderer.setPicture(picture);
        renderer.setSolution({
          positions: Float32Array.from(mesh.positions),
          triangles: Uint32Array.from(mesh.triangles),
          offsets: Uint32Array.from(mesh.offsets),
          sites: Uint32Array.from(mesh.sites),
          weights: Float32Array.from(mesh.weights),
          siteRest: new Float32Array(8),
        });
        renderer.setMotions(Float32Array.from(motions), blend);
        const view = { scale: 100, x: 32 - 100 * px, y: 32 - 100 * py, width: 64, height: 64 };
        return Array.from(renderer.readPixels(view).filter((_, i) => i % 4 === 3));
      },
      {
        mesh: {
          positions: [...mesh.positions],
          triangles: [...mesh.triangles],
          offsets: [...mesh.offsets],
          sites: [...mesh.sites],
          weights: [...mesh.weights],
        },
        motions: [...motions],
        blend,
        px,
        py,
      },
    );
    // Pixels farther than two hundredths from both sides at the first corner must be exact.
    const side = (to: number, x: number, y: number) => {
      const [dx, dy] = [(posed[2 * to] ?? 0) - px, (posed[2 * to + 1] ?? 0) - py];
      return ((x - px) * dy - (y - py) * dx) / Math.hypot(dx, dy);
    };
    const [inside, outside] = [[] as number[], [] as number[]];
    const turn = Math.sign(side(1, posed[4] ?? 0, posed[5] ?? 0));
    alphas.forEach((alpha, at) => {
      const [x, y] = [px + ((at % 64) - 31.5) / 100, py + (Math.floor(at / 64) - 31.5) / 100];
      const within = Math.min(turn * side(1, x, y), -turn * side(2, x, y));
      if (within > 0.02) inside.push(alpha);
      if (within < -0.02) outside.push(alpha);
    });
    expect(inside.length).toBeGreaterThan(200);
    expect(outside.length).toBeGreaterThan(200);
    expect([...new Set(inside), ...new Set(outside)]).toEqual([255, 0]);
  });
}
