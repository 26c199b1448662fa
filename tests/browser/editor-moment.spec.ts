/** One time of a clip has one picture, whatever was done before. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { decode } from 'fast-png';
import type { Clip, Project } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { apart, drawnByCommand, type Pixels } from './films';
import { expect, test } from './fixtures';
import { drawn, goTo, openTimeline, ruler, timeline } from './timeline';

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
function farthest(before: readonly number[], after: readonly number[]): number {
  const far = before.flatMap((x, at) =>
    at % 2 === 0 ? [Math.hypot(Number(after[at]) - x, Number(after[at + 1]) - Number(before[at + 1]))] : [],
  );
  const inside = far.filter((distance) => !Number.isNaN(distance));
  expect(inside.length).toBeGreaterThan(300);
  return Math.max(...inside);
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

test('a moment of a clip has one picture, however one comes to it', async ({ page, baseURL }, info) => {
  await page.route('**/samples/gingerbread.c2warp.json', (route) => route.fulfill({ json: MOVING }));
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await scrubTo(editor, MOMENT);
  const first = await posed(editor);
  const table: Record<string, number> = {};
  const compare = async (way: string) => {
    table[way] = farthest(first, await posed(editor));
  };

  await goTo(editor, 1.9);
  expect(farthest(first, await posed(editor))).toBeGreaterThan(50);
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
  expect(farthest(first, await posed(editor))).toBeGreaterThan(1);
  const moved = await posed(editor);
  await page.keyboard.press('Control+z');
  await expect(editor.button(/^Redo: /)).toBeEnabled();
  await compare('after the undo of a dragged key');

  await page.keyboard.press('Control+Shift+z');
  await expect(editor.button(/^Undo: /)).toBeEnabled();
  expect(farthest(moved, await posed(editor))).toBeLessThan(ALIKE);
  await page.keyboard.press('Control+z');
  await expect(editor.button(/^Redo: /)).toBeEnabled();
  await compare('after redo and undo');

  await page.reload();
  await editor.ready();
  await openTimeline(editor);
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
  table['by the solver for scripts'] = farthest(vertices.posed, await posed(editor, vertices.rest));

  info.annotations.push({ type: 'pixels apart', description: JSON.stringify(table) });
  for (const [way, pixels] of Object.entries(table)) expect(pixels, way).toBeLessThan(ALIKE);

  const shown = decode(Buffer.from(await drawn(editor), 'base64')) as Pixels;
  expect(apart(shown, drawnByCommand(JSON.stringify(MOVING), PICTURE, CLIP, MOMENT, 0.5))).toBeLessThan(0.01);
});
