/** The element opened, bent, exported and closed repeatedly: memory does not grow. */
import { type CDPSession, expect, test } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { times } from './attacks';

const ROUNDS = times(500, 18);
/** After these, everything that is created once exists. */
const FIRST = times(50, 12);
/** The part of the first figure by which a later one may be larger. */
const GROWTH = 0.05;
/** Workers that a page keeps for its next picture: one decodes, one encodes. */
const KEPT = 2;
const SAMPLE = '/samples/gingerbread.png';
const PROJECT = '/samples/gingerbread.c2warp.json';

/**
 * Bytes of objects and buffers, and the nodes of the document, after the collection of all garbage. The browser's own
 * records of the page, such as timings of its requests, are elsewhere.
 */
async function memory(devtools: CDPSession) {
  await devtools.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize } = await devtools.send('Runtime.getHeapUsage');
  const { nodes } = await devtools.send('Memory.getDOMCounters');
  return { heap: usedSize, buffers: backingStorageSize, nodes };
}

test('opening, bending, exporting and closing again and again takes no more memory', async ({ page }) => {
  test.setTimeout(ROUNDS * 10_000 + 120_000);
  await page.goto('/plain/');
  const devtools = await page.context().newCDPSession(page);
  await page.locator('c2-warp').evaluate((element) => element.remove());
  // Each call of a function in the page compiles it again, and that code stays.
  const rounds = (count: number) =>
    page.evaluate(
      async ({ count, sample, project }) => {
        const sizes: number[] = [];
        while (sizes.length < count) {
          const warp = document.createElement('c2-warp') as C2Warp;
          document.body.append(warp);
          await warp.load(sample, project);
          const [handle] = warp.project.handles;
          if (handle?.kind !== 'point') throw new Error('The sample begins with a point.');
          warp.pose([{ id: handle.id, posed: [handle.posed[0] + 20, handle.posed[1] - 20] }]);
          const { size } = await warp.toBlob();
          sizes.push(size);
          warp.destroy();
          warp.remove();
        }
        return Math.min(...sizes);
      },
      { count, sample: SAMPLE, project: PROJECT },
    );
  expect(await rounds(FIRST)).toBeGreaterThan(10_000);
  const first = await memory(devtools);
  expect(await rounds(ROUNDS - FIRST)).toBeGreaterThan(10_000);
  const last = await memory(devtools);
  for (const kind of ['heap', 'buffers', 'nodes'] as const) {
    expect(last[kind], kind).toBeLessThanOrEqual(first[kind] * (1 + GROWTH));
  }
  await expect.poll(() => page.workers().length).toBe(KEPT);
});
