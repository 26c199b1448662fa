/** Elements, pictures and drags, repeatedly: memory does not grow. */
import { readFileSync } from 'node:fs';
import { type CDPSession, expect, type Page, test } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { times } from './attacks';

const ROUNDS = times(500, 18);
/** After these, everything that is created once exists. */
const FIRST = times(50, 12);
/** Pictures that one editor opens, and those after which memory is compared: by then all code is optimized. */
const OPENS = times(200, 100);
const FIRST_OPENS = 80;
/** Drags of a handle by script. A history has no more than 500 steps. */
const DRAGS = times(3000, 600);
const FIRST_DRAGS = 500;
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

/** Compares memory after the first rounds with that after all rounds. `rounds` runs a number of them. */
async function expectNoGrowth(
  page: Page,
  first: number,
  all: number,
  rounds: (count: number) => Promise<void>,
) {
  const devtools = await page.context().newCDPSession(page);
  const kinds = ['heap', 'buffers', 'nodes'] as const;
  await rounds(first);
  const before = await memory(devtools);
  await rounds(all - first);
  // Some objects need several collections.
  const growths = async () => {
    const after = await memory(devtools);
    return kinds.filter((kind) => after[kind] > before[kind] * (1 + GROWTH));
  };
  await expect.poll(growths, 'what has grown').toEqual([]);
}

test('opening, bending, exporting and closing again and again takes no more memory', async ({ page }) => {
  test.setTimeout(ROUNDS * 10_000 + 120_000);
  await page.goto('/plain/');
  await page.locator('c2-warp').evaluate((element) => element.remove());
  await expectNoGrowth(page, FIRST, ROUNDS, async (count) => {
    // Each call of a function in the page compiles it anew, and that code stays.
    const least = await page.evaluate(
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
    expect(least).toBeGreaterThan(10_000);
  });
  await expect.poll(() => page.workers().length).toBe(KEPT);
});

test('one editor that opens picture after picture takes no more memory', async ({ page }) => {
  test.setTimeout(OPENS * 10_000 + 120_000);
  await page.goto('/plain/');
  await expectNoGrowth(page, FIRST_OPENS, OPENS, (count) =>
    page.locator('c2-warp').evaluate(
      async (element, { count, sample, project }) => {
        for (let opened = 0; opened < count; opened++) await (element as C2Warp).load(sample, project);
      },
      { count, sample: SAMPLE, project: PROJECT },
    ),
  );
});

test('drag after drag takes no more memory once the history is full', async ({ page }) => {
  test.setTimeout(DRAGS * 500 + 120_000);
  await page.goto('/plain/');
  const warp = page.locator('c2-warp');
  // Memory grows by drags, whatever the detail of the picture.
  const json = JSON.parse(readFileSync(new URL(`../../web/public${PROJECT}`, import.meta.url), 'utf8'));
  const project = { ...json, samples: 1500, pose: { ...json.pose, density: 30 } };
  await warp.evaluate((element, [sample, project]) => (element as C2Warp).load(sample, project), [
    SAMPLE,
    project,
  ] as const);
  await expectNoGrowth(page, FIRST_DRAGS, DRAGS, (count) =>
    warp.evaluate(async (element, count) => {
      const warp = element as C2Warp;
      const frame = () => new Promise((shown) => requestAnimationFrame(shown));
      for (let dragged = 0; dragged < count; dragged++) {
        const [handle] = warp.project.handles;
        if (handle?.kind !== 'point') throw new Error('The sample begins with a point.');
        const by = dragged % 2 ? -8 : 8;
        warp.updateHandle(handle.id, { posed: [handle.posed[0] + by, handle.posed[1] - by] });
        await frame();
      }
    }, count),
  );
});
