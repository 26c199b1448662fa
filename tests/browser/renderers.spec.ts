/** The WebGL canvas and the solver's rasteriser must draw the same picture. */
import { decode } from 'fast-png';
import type { Project } from '../../web/src/document/project';
import { expect, test } from './fixtures';
import { type Difference, difference } from './images';

test.beforeEach(async ({ page }) => {
  await page.goto('/harness/');
});

function expectAgreement({ mean, close, opaque }: Difference): void {
  expect(opaque).toBeGreaterThan(1000);
  expect(mean).toBeLessThanOrEqual(2);
  expect(close).toBeGreaterThanOrEqual(0.99);
}

test('the posed sample picture, at half its size', async ({ page }, info) => {
  const { webgl, cpu } = await page.evaluate(async () => {
    const project: Project = await (await fetch('/samples/gingerbread.c2warp.json')).json();
    const file = await (await fetch('/samples/gingerbread.png')).blob();
    const offsets = [30, -20, 12, -35, 18];
    const handles = project.handles.map((handle, i) =>
      handle.kind === 'point'
        ? {
            ...handle,
            posed: [handle.rest[0] + (offsets[i] ?? 0), handle.rest[1] + 20] as const,
            rotation: i * 6,
          }
        : handle,
    );
    return harness.drawnTwice({ ...project, handles }, file, 0.5);
  });
  expectAgreement(await difference(webgl, cpu, info));
});

for (const scale of [1, 0.4, 1.7]) {
  test(`a picture with holes and islands, at ${scale} times its size`, async ({ page }, info) => {
    const { webgl, cpu } = await page.evaluate(async (scale) => {
      const file = await harness.drawnPicture();
      return harness.drawnTwice(
        {
          format: 'c2warp/1',
          image: { src: 'drawn.png', width: 256, height: 256 },
          handles: [
            { id: 'top', kind: 'point', rest: [40, 50], posed: [52, 44], rotation: 12 },
            { id: 'middle', kind: 'point', rest: [150, 130], posed: [138, 136] },
            { id: 'foot', kind: 'point', rest: [50, 200], posed: [58, 196], scale: 1.1 },
            { id: 'island', kind: 'point', rest: [208, 128], posed: [214, 150], rotation: 30 },
          ],
        },
        file,
        scale,
      );
    }, scale);
    expectAgreement(await difference(webgl, cpu, info));
  });
}

test('the rigid blend, with very different turns and a stretch', async ({ page }, info) => {
  const { webgl, cpu } = await page.evaluate(async () => {
    const file = await harness.drawnPicture();
    return harness.drawnTwice(
      {
        format: 'c2warp/1',
        image: { src: 'drawn.png', width: 256, height: 256 },
        pose: { blend: 'rigid', density: 12 },
        handles: [
          { id: 'top', kind: 'point', rest: [40, 50], posed: [60, 70], rotation: 60 },
          { id: 'middle', kind: 'point', rest: [150, 130], posed: [138, 136], rotation: -60 },
          { id: 'foot', kind: 'point', rest: [50, 200], posed: [70, 185], rotation: 150, scale: 0.8 },
          { id: 'island', kind: 'point', rest: [208, 128], posed: [214, 150], rotation: 30 },
        ],
      },
      file,
      1.5,
    );
  });
  expectAgreement(await difference(webgl, cpu, info));
});

/** Two legs that cross, with the depths of hip, left and right leg. */
const crossing = ([hip, left, right]: readonly [number, number, number], edges: boolean): Project => ({
  format: 'c2warp/1',
  image: { src: 'legs.png', width: 256, height: 256 },
  pose: { density: 20 },
  weighting: { support: 'smooth' },
  edges,
  handles: [
    { id: 'hip', kind: 'point', rest: [128, 50], posed: [128, 50], depth: hip },
    { id: 'left', kind: 'point', rest: [75, 215], posed: [180, 205], rotation: -35, depth: left },
    { id: 'right', kind: 'point', rest: [181, 215], posed: [76, 205], rotation: 35, depth: right },
  ],
});

for (const [nearer, depths] of [
  ['left', [0, 1, -1]],
  ['right', [0, -1, 1]],
  ['neither', [0, 0, 0]],
] as const) {
  test(`two legs that cross, ${nearer} in front`, async ({ page }, info) => {
    const { webgl, cpu } = await page.evaluate(
      async (project) => harness.drawnTwice(project, await harness.drawnLegs(), 1.5),
      crossing(depths, false),
    );
    expectAgreement(await difference(webgl, cpu, info));
    // At the crossing, the left leg is red and the right leg blue.
    const { data, width } = decode(Buffer.from(webgl, 'base64'));
    const at = 4 * (Math.round(155 * 1.5) * width + Math.round(128 * 1.5));
    const found = (data[at] ?? 0) > (data[at + 2] ?? 0) ? 'left' : 'right';
    if (nearer !== 'neither') expect(found).toBe(nearer);
  });
}

for (const scale of [1, 2]) {
  test(`the edge of a leg in front of another, at ${scale} times its size`, async ({ page }, info) => {
    const [edged, plain] = await page.evaluate(
      async ({ edged, plain, scale }) => {
        const file = await harness.drawnLegs();
        return [await harness.drawnTwice(edged, file, scale), await harness.drawnTwice(plain, file, scale)];
      },
      { edged: crossing([0, 1, -1], true), plain: crossing([0, 1, -1], false), scale },
    );
    if (!edged || !plain) throw new Error('two pictures');
    expectAgreement(await difference(edged.webgl, edged.cpu, info));
    for (const renderer of ['webgl', 'cpu'] as const) {
      const [before, after] = [plain, edged].map(
        (drawn) => decode(Buffer.from(drawn[renderer], 'base64')).data,
      );
      if (!before || !after) throw new Error('two pictures');
      let [darker, other] = [0, 0];
      for (let at = 0; at < after.length; at += 4) {
        const change = [0, 1, 2, 3].map(
          (channel) => (after[at + channel] ?? 0) - (before[at + channel] ?? 0),
        );
        if (change.every((by, channel) => (channel < 3 ? by <= 1 : by === 0))) {
          if (Math.min(...change) < -12) darker++;
        } else other++;
      }
      expect(other).toBe(0);
      expect(darker).toBeGreaterThan(100);
      expect(darker).toBeLessThan(0.03 * (after.length / 4));
    }
  });
}

for (const held of [false, true]) {
  test(`a lassoed part, ${held ? 'held at its boundary' : 'with a gap around it'}`, async ({
    page,
  }, info) => {
    const { webgl, cpu } = await page.evaluate(async (held) => {
      const file = await harness.drawnPicture();
      const ring = Array.from({ length: 30 }, (_, k) => {
        const turn = (2 * Math.PI * k) / 30;
        return [110 + 70 * Math.cos(turn), 120 + 80 * Math.sin(turn)] as const;
      });
      return harness.drawnTwice(
        {
          format: 'c2warp/1',
          image: { src: 'drawn.png', width: 256, height: 256 },
          domain: { kind: 'polygon', rings: [ring] },
          fix_boundary: held,
          handles: [{ id: 'middle', kind: 'point', rest: [130, 130], posed: [118, 146], rotation: 20 }],
        },
        file,
        1.5,
      );
    }, held);
    expectAgreement(await difference(webgl, cpu, info));
  });
}

test('a glow with an unmoved handle is the picture itself', async ({ page }) => {
  const { webgl, cpu, picture } = await page.evaluate(async () => {
    const file = await harness.drawnGlow();
    const drawn = await harness.drawnTwice(
      {
        format: 'c2warp/1',
        image: { src: 'glow.png', width: 256, height: 256 },
        domain: { kind: 'alpha', threshold: 0.9 },
        handles: [{ id: 'left', kind: 'point', rest: [90, 128], posed: [90, 128] }],
      },
      file,
      1,
    );
    return { ...drawn, picture: [...new Uint8Array(await file.arrayBuffer())] };
  });
  const expected = decode(new Uint8Array(picture)).data;
  for (const [renderer, drawn] of Object.entries({ webgl, cpu })) {
    const found = decode(Buffer.from(drawn, 'base64')).data;
    let most = 0;
    for (let at = 0; at < expected.length; at++) {
      const [alpha, other] = [found[at | 3] ?? 0, expected[at | 3] ?? 0];
      const isAlpha = at % 4 === 3;
      const [a, b] = isAlpha
        ? [alpha, other]
        : [((found[at] ?? 0) * alpha) / 255, ((expected[at] ?? 0) * other) / 255];
      most = Math.max(most, Math.abs(a - b));
    }
    // A graphics card snaps vertices to 1/256 of a pixel, so hard edges bleed by some levels.
    expect(most, renderer).toBeLessThanOrEqual(renderer === 'cpu' ? 1.01 : 12);
  }
});
