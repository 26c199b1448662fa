/** The timeline: motions made by pointer, keys, touch and recording; played, stored, and drawn by the command. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { AxeBuilder } from '@axe-core/playwright';
import type { Locator, TestInfo } from '@playwright/test';
import type { Clip } from '../../web/src/document/project';
import type { C2Warp } from '../../web/src/element';
import { builtCommand } from './command';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { difference } from './images';
import { drawn, goTo, openTimeline, ruler, timeline } from './timeline';

const SAMPLE = fileURLToPath(new URL('../../web/public/samples/gingerbread.png', import.meta.url));

const keys = (editor: Editor, handle: string): Locator =>
  timeline(editor).getByRole('button', { name: new RegExp(`^${handle}, key at`) });

const clips = ({ page }: Editor): Promise<readonly Clip[]> =>
  page.locator('c2-warp').evaluate((element) => (element as C2Warp).project.clips ?? []);

/** The times and heights of a handle's keys in the first clip. */
async function way(editor: Editor, handle: string): Promise<readonly (readonly [time: number, y: number])[]> {
  const [clip] = await clips(editor);
  const track = clip?.tracks.find((track) => track.handle === handle);
  return (track?.keys ?? []).map(({ time, posed }) => [time, Number(posed?.[1])] as const);
}

test.beforeEach(async ({ page }) => {
  // The sample has clips of its own. These tests begin without any.
  await page.route('**/samples/gingerbread.c2warp.json', async (route) => {
    const { clips: _, ...project } = await (await route.fetch()).json();
    await route.fulfill({ json: project });
  });
});

/** Presses Tab until an element has the focus. */
async function tabTo(editor: Editor, wanted: Locator): Promise<void> {
  for (let presses = 0; presses < 120; presses++) {
    if (await wanted.evaluate((node) => node.matches(':focus'))) return;
    await editor.page.keyboard.press('Tab');
  }
  throw new Error(`Tab does not come to ${wanted}`);
}

/** Fails unless the command draws this time of the clip as the editor does. */
async function expectSameByCommand(editor: Editor, seconds: number, info: TestInfo): Promise<void> {
  const project = await editor.page
    .locator('c2-warp')
    .evaluate((element) => JSON.stringify((element as C2Warp).project));
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-'));
  try {
    const [file, out] = [join(folder, 'a.c2warp.json'), join(folder, 'out.png')];
    writeFileSync(file, project);
    const clip = JSON.parse(project).clips[0].name;
    const args = [
      'warp',
      file,
      '--image',
      SAMPLE,
      '--clip',
      clip,
      '--at',
      String(seconds),
      '--scale',
      '0.5',
      '-o',
      out,
    ];
    const { stderr, status } = spawnSync(builtCommand(), args, { encoding: 'utf8' });
    expect([status, stderr]).toEqual([0, '']);
    const apart = await difference(await drawn(editor), readFileSync(out).toString('base64'), info);
    expect(apart.mean).toBeLessThan(2);
    expect(apart.opaque).toBeGreaterThan(50_000);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a wave made by pointer survives a reload, plays, and is the same by command', async ({
  page,
}, info) => {
  const editor = await Editor.open(page);
  await editor.button('Animate: show the timeline').click();
  await timeline(editor).getByRole('button', { name: 'New clip' }).click();
  await goTo(editor, 0.5);
  await editor.dragHandle('right hand', { x: -10, y: -90 });
  await goTo(editor, 1);
  await editor.dragHandle('right hand', { x: 20, y: 60 });
  await expect(keys(editor, 'right hand')).toHaveCount(3);
  const made = await way(editor, 'right-hand');
  expect(made.map(([time]) => time)).toEqual([0, 0.5, 1]);
  expect(made[0]?.[1]).toBe(516);
  expect(made[1]?.[1]).toBeLessThan(400);

  // Between the keys.
  await goTo(editor, 0.7);
  const shown = (await editor.shownPose('right hand')).y;
  expect(shown).toBeGreaterThan(made[1]?.[1] ?? 0);
  expect(shown).toBeLessThan(made[2]?.[1] ?? 0);
  const time = Number(await ruler(editor).getAttribute('aria-valuenow'));
  await expectSameByCommand(editor, time, info);
  // The file rests.
  expect(await editor.projectHandle('right-hand')).toMatchObject({ posed: [900, 516] });

  await expect.poll(async () => (await editor.storedWork()).step).toBe('Move right hand');
  await page.reload();
  await editor.ready();
  expect(await way(editor, 'right-hand')).toEqual(made);
  expect((await editor.shownPose('right hand')).y).toBe(516);
  await openTimeline(editor);
  await page.keyboard.press('k');
  await expect.poll(async () => (await editor.shownPose('right hand')).y).toBeLessThan(480);
  await timeline(editor).getByRole('button', { name: 'Stop' }).click();
  const stopped = await editor.settled(() => ruler(editor).getAttribute('aria-valuenow'));
  expect(Number(stopped) * 30).toBeCloseTo(Math.round(Number(stopped) * 30), 1);
  await expectSameByCommand(editor, Number(stopped), info);
});

test('a walk made by dragging has whole depths, in the keys of drags that cross', async ({ page }) => {
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'New clip' }).click();
  const scale = await editor.scale();
  const depths = async (handle: string) => {
    const track = (await clips(editor))[0]?.tracks.find((track) => track.handle === handle);
    return (track?.keys ?? []).map(({ time, depth }) => [time, depth ?? null] as const);
  };
  await goTo(editor, 1);
  await editor.dragHandle('right hand', { x: (600 - 900) * scale, y: (800 - 516) * scale });
  await expect
    .poll(() => depths('right-hand'))
    .toEqual([
      [0, 1],
      [1, 1],
    ]);
  // The panel says so.
  await expect(page.getByRole('spinbutton', { name: 'Depth (Auto)' })).toHaveValue('1');
  await goTo(editor, 0.5);
  await editor.dragHandle('right hand', { x: 6, y: -20 });
  await goTo(editor, 1.5);
  await editor.dragHandle('right hand', { x: 60, y: -40 });
  await expect
    .poll(() => depths('right-hand'))
    .toEqual([
      [0, 1],
      [0.5, null],
      [1, 1],
      [1.5, null],
    ]);
  // A depth that a person sets is not automatic, and belongs only to its key.
  await page.keyboard.press('[');
  await expect(editor.field('depth')).toHaveValue('0');
  await expect(page.getByRole('spinbutton', { name: 'Depth (Auto)' })).toHaveCount(0);
  await goTo(editor, 1.2);
  await expect(editor.field('depth')).toHaveValue('1');
  expect(await depths('right-hand')).toEqual([
    [0, 1],
    [0.5, null],
    [1, 1],
    [1.5, 0],
  ]);
});

test('a motion is created, moved and eased with only the keyboard', async ({ page }) => {
  const editor = await Editor.open(page);
  await page.keyboard.press('t');
  await expect(timeline(editor)).toBeFocused();
  await tabTo(editor, timeline(editor).getByRole('button', { name: 'New clip' }));
  await page.keyboard.press('Enter');
  await tabTo(editor, ruler(editor));
  await page.keyboard.press('Shift+ArrowRight');
  for (let frame = 0; frame < 5; frame++) await page.keyboard.press('ArrowRight');
  await expect(ruler(editor)).toHaveAttribute('aria-valuetext', '0.50 s');
  await expect(page.getByText('0.50 s', { exact: true }).first()).toBeAttached();
  await tabTo(editor, editor.handle('left hand'));
  for (let step = 0; step < 4; step++) await page.keyboard.press('Shift+ArrowUp');
  expect(await way(editor, 'left-hand')).toEqual([
    [0, 516],
    [0.5, 476],
  ]);

  await tabTo(editor, keys(editor, 'left hand').first());
  await page.keyboard.press('ArrowRight');
  await expect(keys(editor, 'left hand').last()).toBeFocused();
  await page.keyboard.press('Alt+ArrowRight');
  await page.keyboard.press('Alt+ArrowRight');
  await expect.poll(async () => (await way(editor, 'left-hand'))[1]?.[0]).toBeCloseTo(0.5667, 3);
  await expect(page.getByText('Move 1 key', { exact: true })).toBeAttached();
  await page.keyboard.press('Control+c');
  await tabTo(editor, ruler(editor));
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Control+v');
  await expect(keys(editor, 'left hand')).toHaveCount(3);
  await page.keyboard.press('Delete');
  await expect(keys(editor, 'left hand')).toHaveCount(2);
  await page.keyboard.press('Control+z');
  await expect(keys(editor, 'left hand')).toHaveCount(3);
  await page.keyboard.press('t');
  await expect(timeline(editor)).toBeHidden();
  expect((await editor.shownPose('left hand')).y).toBe(516);
});

/** Adds a clip, stopped, and shows the key of the head at its second time. */
async function sway(editor: Editor): Promise<Locator> {
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'Sway' }).click();
  await timeline(editor).getByRole('button', { name: 'Stop' }).click();
  return keys(editor, 'head').nth(1);
}

const times = async (editor: Editor, handle: string): Promise<readonly number[]> =>
  (await way(editor, handle)).map(([time]) => time);

test('the keyboard deletes, moves, copies and cuts a pressed key', async ({ page }) => {
  const editor = await Editor.open(page);
  const key = await sway(editor);
  const before = await times(editor, 'head');
  const [first = 0, second = 0, third = 0] = before;
  await key.click();
  await expect(key).toBeFocused();
  await page.keyboard.press('Delete');
  expect(await times(editor, 'head')).toEqual(before.filter((time) => time !== second));
  await expect(editor.handles).toHaveCount(5);
  await page.keyboard.press('Control+z');
  expect(await times(editor, 'head')).toEqual(before);
  await expect(key).toHaveAttribute('aria-pressed', 'true');

  const pose = await editor.projectHandle('head');
  await page.keyboard.press('ArrowRight');
  await expect(keys(editor, 'head').nth(2)).toHaveAttribute('aria-pressed', 'true');
  await expect(ruler(editor)).toHaveAttribute('aria-valuenow', String(Number(third.toFixed(3))));
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(timeline(editor).locator('.clip-key[aria-pressed="true"]')).toHaveCount(2);
  await page.keyboard.press('ArrowDown');
  await expect(timeline(editor).locator('.clip-key[aria-pressed="true"]')).toHaveAttribute(
    'data-key-of',
    'left-hand',
  );
  await key.click();
  await page.keyboard.press('Alt+ArrowRight');
  expect((await times(editor, 'head'))[1]).toBeCloseTo(second + 1 / 30, 4);
  await page.keyboard.press('Control+z');
  expect(await editor.projectHandle('head')).toEqual(pose);

  await key.click();
  await page.keyboard.press('Control+c');
  await goTo(editor, first + 0.1);
  await page.keyboard.press('Control+v');
  expect(await times(editor, 'head')).toHaveLength(before.length + 1);
  await page.keyboard.press('Control+x');
  expect(await times(editor, 'head')).toEqual(before);
  await page.keyboard.press('Control+v');
  expect(await times(editor, 'head')).toHaveLength(before.length + 1);
});

test('the keyboard is about keys that were dragged, boxed or reached by Tab', async ({ page }) => {
  const editor = await Editor.open(page);
  const key = await sway(editor);
  const count = (await times(editor, 'head')).length;
  const at = await editor.centre(key);
  await editor.drag(at, { x: 30, y: 0 });
  await page.keyboard.press('Delete');
  expect(await times(editor, 'head')).toHaveLength(count - 1);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');

  const all = await timeline(editor).locator('.clip-key').count();
  await editor.drag({ x: at.x - 20, y: at.y - 8 }, { x: 40, y: 60 });
  const selected = await timeline(editor).locator('.clip-key[aria-pressed="true"]').count();
  expect(selected).toBeGreaterThan(1);
  await timeline(editor)
    .getByRole('button', { name: /^Onion skin/ })
    .click();
  await timeline(editor).getByRole('button', { name: 'Zoom in' }).click();
  await timeline(editor).getByRole('combobox', { name: 'Loop' }).focus();
  await page.keyboard.press('Backspace');
  await expect(timeline(editor).locator('.clip-key')).toHaveCount(all - selected);
  await expect(editor.handles).toHaveCount(5);
  await page.keyboard.press('Control+z');

  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await expect(timeline(editor).locator('.clip-key[aria-pressed="true"]')).toHaveCount(0);
  await tabTo(editor, keys(editor, 'head').first());
  await expect(keys(editor, 'head').first()).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Delete');
  await expect(timeline(editor).locator('.clip-key')).toHaveCount(all - 1);
  await expect(editor.handles).toHaveCount(5);
});

test('Escape lets go of keys before their handle, and a press on the handle takes it', async ({ page }) => {
  const editor = await Editor.open(page);
  const key = await sway(editor);
  const shell = page.locator('c2-warp .shell');
  await key.click();
  // The marks of the handle step back.
  await expect(shell).toHaveClass(/of-keys/);
  await page.keyboard.press('Escape');
  await expect(key).toHaveAttribute('aria-pressed', 'false');
  await expect(editor.handle('head')).toHaveAttribute('aria-pressed', 'true');
  await expect(shell).not.toHaveClass(/of-keys/);
  await key.click();
  const { x, y } = await editor.position('head');
  await page.mouse.click(x, y);
  await expect(key).toHaveAttribute('aria-pressed', 'false');
  await page.keyboard.press('ArrowUp');
  await expect(editor.button('Undo: move head')).toBeEnabled();
  await page.keyboard.press('Delete');
  await expect(editor.handle('head')).toHaveCount(0);
});

test('a motion is recorded while R is held', async ({ page }, info) => {
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'New clip' }).click();
  const from = await editor.position('right hand');
  await page.keyboard.down('r');
  await expect(timeline(editor).getByRole('button', { name: /^Record/ })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const now = async () => Number(await ruler(editor).getAttribute('aria-valuenow'));
  for (let step = 1; step <= 24; step++) {
    const before = await now();
    await page.mouse.move(from.x + 3 * step, from.y - 60 * Math.sin(step / 4));
    // Time advances with the frames of the screen, at any frame rate.
    if (step > 1) await expect.poll(now).toBeGreaterThan(before);
  }
  await page.mouse.up();
  await page.keyboard.up('r');
  await expect(editor.button('Undo: record right hand')).toBeEnabled();
  const made = await way(editor, 'right-hand');
  expect(made.length).toBeGreaterThan(3);
  expect(made[0]).toEqual([0, 516]);
  const heights = made.map(([, y]) => y);
  expect(Math.min(...heights)).toBeLessThan(430);
  expect(Math.max(...heights)).toBeGreaterThan(590);
  await expect(ruler(editor)).toHaveAttribute('aria-valuenow', '0');
  await goTo(editor, 0.3);
  await expectSameByCommand(editor, await now(), info);
});

test('keys are dragged and chosen by a box', async ({ page }) => {
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'Sway' }).click();
  await page.keyboard.press('k');
  await expect(timeline(editor).getByRole('button', { name: 'Play', exact: true })).toBeVisible();
  const [first, second] = [
    await editor.centre(keys(editor, 'head').nth(1)),
    await editor.centre(keys(editor, 'right hand').nth(2)),
  ];
  await page.mouse.move(first.x - 20, first.y - 8);
  await page.mouse.down();
  await page.mouse.move(second.x, second.y, { steps: 4 });
  await page.mouse.move(second.x + 20, second.y + 8);
  await page.mouse.up();
  await expect(timeline(editor).locator('.clip-key[aria-pressed="true"]')).toHaveCount(6);
  const before = await way(editor, 'head');
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  await page.mouse.move(first.x + 30, first.y, { steps: 3 });
  await page.mouse.up();
  const after = await way(editor, 'head');
  const moved = after.map(([time], k) => time - (before[k]?.[0] ?? 0));
  expect(moved[0]).toBe(0);
  expect(moved[1]).toBeGreaterThan(0.02);
  expect(moved[1]).toBeCloseTo(moved[2] ?? 0, 4);
  expect(moved[3]).toBe(0);
  await expect(editor.button('Undo: move 6 keys')).toBeEnabled();
});

test('clips are named, set, duplicated and deleted', async ({ page }) => {
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'Breathe' }).click();
  await timeline(editor).getByRole('button', { name: 'Rename the clip' }).click();
  const name = timeline(editor).getByRole('textbox', { name: 'Clip name' });
  await expect(name).toBeFocused();
  await page.keyboard.type('calm');
  await page.keyboard.press('Enter');
  await timeline(editor).getByRole('combobox', { name: 'Loop' }).selectOption('Back and forth');
  const duration = timeline(editor).getByRole('spinbutton', { name: 'Duration (s)' });
  await duration.fill('0.5');
  await duration.press('Enter');
  // The last key bounds it.
  expect(await clips(editor)).toMatchObject([{ name: 'calm', loop: 'alternate', duration: 1.3 }]);
  await timeline(editor).getByRole('button', { name: 'Duplicate the clip' }).click();
  expect((await clips(editor)).map((clip) => clip.name)).toEqual(['calm', 'calm copy']);
  await timeline(editor).getByRole('button', { name: 'Delete the clip' }).click();
  await expect(timeline(editor).getByRole('combobox', { name: 'Clip' })).toHaveValue('=calm');
  await editor.button(/^Undo/).click();
  expect(await clips(editor)).toHaveLength(2);
});

test('the neighbouring keys are shown faintly', async ({ page }) => {
  const editor = await Editor.open(page);
  await openTimeline(editor);
  await timeline(editor).getByRole('button', { name: 'Wave' }).click();
  await timeline(editor).getByRole('button', { name: 'Stop' }).click();
  await goTo(editor, 0.4);
  const skins = page.locator('c2-warp .onion-skin.pale');
  await expect(skins).toHaveCount(0);
  await timeline(editor)
    .getByRole('button', { name: /^Onion skin/ })
    .click();
  await expect(skins).toHaveCount(2);
});

test('an error in a clip names its key', async ({ page }) => {
  await Editor.open(page);
  const refusal = (tracks: unknown, duration = 1) =>
    page.locator('c2-warp').evaluate(
      (element, { tracks, duration }) => {
        const { project } = element as C2Warp;
        try {
          (element as C2Warp).project = { ...project, clips: [{ name: 'a', duration, tracks }] } as never;
          return '';
        } catch (error) {
          return (error as Error).message;
        }
      },
      { tracks, duration },
    );
  const track = (...times: number[]) => [{ handle: 'head', keys: times.map((time) => ({ time })) }];
  expect(await refusal(track(2))).toContain(
    'clips[0].tracks[0].keys[0].time: expected seconds from 0 to 1, found 2',
  );
  expect(await refusal(track(0.5, 0.5))).toContain('clips[0].tracks[0].keys[1].time');
  expect(await refusal([{ handle: 'ear', keys: [{ time: 0 }] }])).toContain('there is no handle "ear"');
  expect(await refusal([], 0)).toContain('clips[0].duration');
});

for (const [name, viewport] of [
  ['wide', { width: 1280, height: 800 }],
  ['a phone', { width: 390, height: 844 }],
] as const) {
  test(`axe finds no violation in the timeline, ${name}`, async ({ page }) => {
    await page.setViewportSize(viewport);
    const editor = await Editor.open(page);
    await openTimeline(editor);
    const check = async () => {
      const { violations } = await new AxeBuilder({ page }).include('c2-warp').analyze();
      expect(
        violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join(' ')}`),
      ).toEqual([]);
    };
    await check();
    await timeline(editor).getByRole('button', { name: 'Wave' }).click();
    await timeline(editor).getByRole('button', { name: 'Stop' }).click();
    await check();
  });
}

test.describe('by touch', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a wave starts with two taps, and every control is as large as a finger', async ({ page }) => {
    const editor = await Editor.open(page);
    await editor.button('More').tap();
    await editor.button('Animate: show the timeline').tap();
    await timeline(editor).getByRole('button', { name: 'Wave' }).tap();
    await expect.poll(async () => (await editor.shownPose('left hand')).y).toBeLessThan(500);
    await timeline(editor).getByRole('button', { name: 'Stop' }).tap();
    await keys(editor, 'left hand').nth(1).tap();
    await expect(keys(editor, 'left hand').nth(1)).toHaveAttribute('aria-pressed', 'true');
    const small = await timeline(editor).evaluate((node) =>
      [...node.querySelectorAll('button, select, [role=slider]')]
        .filter((control) => {
          const { width, height } = control.getBoundingClientRect();
          return width < 44 || height < 44;
        })
        .map((control) => control.outerHTML.slice(0, 120)),
    );
    expect(small).toEqual([]);
  });
});
