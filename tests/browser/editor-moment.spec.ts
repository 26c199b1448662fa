/** One time of a clip has one picture, whatever was done before. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Locator } from '@playwright/test';
import type { Clip, Project } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { builtCommand } from './command';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { difference } from './images';

const PICTURE = fileURLToPath(new URL('../../web/public/samples/gingerbread.png', import.meta.url));
const PROJECT = fileURLToPath(new URL('../../web/public/samples/gingerbread.c2warp.json', import.meta.url));
const CLIP = 'cross';
const MOMENT = 1;
/** The most that ways to a moment may differ, in pixels of the picture. */
const ALIKE = 0.25;

/**
 * A hand crosses the figure, so that several poses fit the handles. The other hand has a key that no other handle
 * has.
 */
const CROSS: Clip = {
  name: CLIP,
  duration: 2,
  loop: 'none',
  tracks: [
    {
      handle: 'right-hand',
      keys: [
        { time: 0, posed: [900, 516], ease: 'linear' },
        { time: MOMENT, posed: [250, 620], ease: 'linear' },
        { time: 2, posed: [700, 300], ease: 'linear' },
      ],
    },
    {
      handle: 'left-hand',
      keys: [
        { time: 0, posed: [124, 516], ease: 'linear' },
        { time: 0.5, posed: [200, 300], ease: 'linear' },
        { time: 2, posed: [124, 700], ease: 'linear' },
      ],
    },
  ],
};
const MOVING: Project = { ...JSON.parse(readFileSync(PROJECT, 'utf8')), clips: [CROSS] };

const timeline = ({ page }: Editor): Locator => page.getByRole('region', { name: 'Timeline' });
const ruler = (editor: Editor): Locator => timeline(editor).getByRole('slider', { name: 'Playhead' });

/** Places all over the picture. */
const places = (): number[] => {
  const { width, height } = MOVING.image;
  const columns = Array.from({ length: 32 }, (_, column) => ((column + 0.5) * width) / 32);
  return columns.flatMap((x) => columns.flatMap((column) => [x, (column * height) / width]));
};

const posed = ({ page }: Editor, at = places()): Promise<number[]> =>
  page
    .locator('c2-warp')
    .evaluate((element, places) => [...(element as C2Warp).mapPoints(Float64Array.from(places))], at);

/** The farthest that a place is from where it was, of those inside the figure. */
function apart(before: readonly number[], after: readonly number[]): number {
  const far = before.flatMap((x, at) =>
    at % 2 === 0 ? [Math.hypot(Number(after[at]) - x, Number(after[at + 1]) - Number(before[at + 1]))] : [],
  );
  const inside = far.filter((distance) => !Number.isNaN(distance));
  expect(inside.length).toBeGreaterThan(300);
  return Math.max(...inside);
}

/** Moves the playhead by a press on the ruler. */
async function goTo(editor: Editor, seconds: number): Promise<void> {
  const lane = await ruler(editor).locator('.time').boundingBox();
  if (!lane) throw new Error('the ruler is not visible');
  await editor.page.mouse.click(lane.x + (lane.width * seconds) / CROSS.duration, lane.y + 8);
  await expect
    .poll(async () => Number(await ruler(editor).getAttribute('aria-valuenow')))
    .toBeCloseTo(seconds, 1);
}

/** Moves the playhead frame by frame from where it is. */
async function scrubTo(editor: Editor, seconds: number): Promise<void> {
  await ruler(editor).focus();
  const now = async () => Math.round(30 * Number(await ruler(editor).getAttribute('aria-valuenow')));
  const by = Math.round(30 * seconds) - (await now());
  for (let frame = 0; frame < Math.abs(by); frame++) {
    await editor.page.keyboard.press(by > 0 ? 'ArrowRight' : 'ArrowLeft');
  }
  await expect.poll(now).toBe(Math.round(30 * seconds));
}

/** Drags the key at half a second to a later time. */
async function dragKey(editor: Editor): Promise<void> {
  const key = await editor.centre(timeline(editor).getByRole('button', { name: /^left hand, key at 0\.5/ }));
  await editor.page.mouse.move(key.x, key.y);
  await editor.page.mouse.down();
  await editor.page.mouse.move(key.x + 60, key.y, { steps: 3 });
  await editor.page.mouse.up();
  await expect(editor.button(/^Undo: /)).toBeEnabled();
}

async function openClip(editor: Editor): Promise<void> {
  await editor.page.keyboard.press('t');
  await expect(timeline(editor)).toBeVisible();
}

test('a moment of a clip has one picture, however one comes to it', async ({ page, baseURL }, info) => {
  await page.route('**/samples/gingerbread.c2warp.json', (route) => route.fulfill({ json: MOVING }));
  const editor = await Editor.open(page);
  await openClip(editor);
  await scrubTo(editor, MOMENT);
  const first = await posed(editor);
  const table: Record<string, number> = {};
  const compare = async (way: string) => {
    table[way] = apart(first, await posed(editor));
  };

  await goTo(editor, 1.9);
  expect(apart(first, await posed(editor))).toBeGreaterThan(50);
  await scrubTo(editor, MOMENT);
  await compare('backwards, frame by frame');

  await goTo(editor, 0.1);
  await goTo(editor, 1.8);
  await goTo(editor, MOMENT);
  await scrubTo(editor, MOMENT);
  await compare('by presses on the ruler');

  await page.keyboard.press('k');
  await expect(timeline(editor).getByRole('button', { name: 'Play', exact: true })).toBeVisible();
  await scrubTo(editor, MOMENT);
  await compare('after the clip was played');

  await dragKey(editor);
  expect(apart(first, await posed(editor))).toBeGreaterThan(1);
  const moved = await posed(editor);
  await page.keyboard.press('Control+z');
  await expect(editor.button(/^Redo: /)).toBeEnabled();
  await compare('after the undo of a dragged key');

  await page.keyboard.press('Control+Shift+z');
  await expect(editor.button(/^Undo: /)).toBeEnabled();
  expect(apart(moved, await posed(editor))).toBeLessThan(ALIKE);
  await page.keyboard.press('Control+z');
  await expect(editor.button(/^Redo: /)).toBeEnabled();
  await compare('after redo and undo');

  await page.reload();
  await editor.ready();
  await openClip(editor);
  await scrubTo(editor, MOMENT);
  await compare('after a reload');

  // Between vertices, the editor interpolates the mesh. Scripts compute the exact map there.
  const vertices = await page.evaluate(
    async ({ module, picture, project, clip, moment }) => {
      const { createWarper } = await import(module);
      const warper = await createWarper(await (await fetch(picture)).arrayBuffer());
      try {
        const solution = await warper.solve(project);
        const [rest, posed] = [await solution.pose().mesh(), await solution.clip(clip, moment).mesh()];
        return { rest: [...rest.positions] as number[], posed: [...posed.positions] as number[] };
      } finally {
        warper.dispose();
      }
    },
    {
      module: `${baseURL}/core/core.js`,
      picture: `${baseURL}/samples/gingerbread.png`,
      project: MOVING,
      clip: CLIP,
      moment: MOMENT,
    },
  );
  table['by the solver for scripts'] = apart(vertices.posed, await posed(editor, vertices.rest));

  info.annotations.push({ type: 'pixels apart', description: JSON.stringify(table) });
  for (const [way, pixels] of Object.entries(table)) expect(pixels, way).toBeLessThan(ALIKE);

  const shown = await page.locator('c2-warp').evaluate(async (element) => {
    const file = await (element as C2Warp).toBlob({ scale: 0.5 });
    let text = '';
    for (const byte of new Uint8Array(await file.arrayBuffer())) text += String.fromCharCode(byte);
    return btoa(text);
  });
  const drawn = await difference(shown, byCommand().toString('base64'), info);
  expect(drawn.mean).toBeLessThan(2);
});

/** The moment as the command draws it. */
function byCommand(): Buffer {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-'));
  try {
    writeFileSync(join(folder, 'cross.c2warp.json'), JSON.stringify(MOVING));
    const moment = ['--clip', CLIP, '--at', String(MOMENT), '--scale', '0.5', '-o', 'out.png'];
    const args = ['warp', 'cross.c2warp.json', '--image', PICTURE, ...moment];
    const { stderr, status } = spawnSync(builtCommand(), args, { cwd: folder, encoding: 'utf8' });
    expect([status, stderr]).toEqual([0, '']);
    return readFileSync(join(folder, 'out.png'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}
