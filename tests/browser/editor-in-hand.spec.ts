/**
 * Keyboard commands apply to the selection that is shown, whichever control was pressed before.
 *
 * The walk finds the controls in the page, so it also presses new ones. After each press that leaves the selection
 * as it was, Delete must delete what is shown as selected, and undo must bring it back.
 */
import type { Page } from '@playwright/test';
import { Editor } from './editor';
import { expect, test } from './fixtures';

/** Controls that can be pressed, except text fields, whose keys are their own. */
const PRESSABLE = 'button, select, summary, input:not([type=text], [type=url]), [role=slider], [role=switch]';

/** Adds handles, a while after its press. */
const LATER = '[data-command=suggest]';

/** Longer walks than this end in a failure, not in a time limit. */
const MOST_PRESSES = 400;

interface Seen {
  /** The keys that are shown as selected, or else the handles. */
  readonly selected: readonly string[];
  readonly keys: number;
  readonly handles: number;
  /** Something can be undone. */
  readonly changed: boolean;
  readonly playing: boolean;
  /** A name is being typed, or a choice or a colour is open: Escape ends that. */
  readonly inside: boolean;
  readonly timeline: boolean;
  readonly picture: string;
  /** Names of the controls that are rendered and enabled. */
  readonly controls: readonly string[];
  /** A control that was not pressed yet, and the place to press it. */
  readonly next: { readonly name: string; readonly x: number; readonly y: number } | null;
}

/** Looks at the page. @param pressed names of controls that are not asked for again. */
const look = (page: Page, pressed: readonly string[]): Promise<Seen> =>
  page.locator('c2-warp').evaluate(
    async (host, { pressable, later, pressed }) => {
      const root = (host as HTMLElement).shadowRoot as ShadowRoot;
      // Input waits for a picture that is being opened, and pages of exports are loaded later.
      const busy = '.stage.awaiting, .export:popover-open[aria-busy=true]';
      while (root.querySelector(busy)) await new Promise(requestAnimationFrame);
      const all = (selector: string) => [...root.querySelectorAll<HTMLElement>(selector)];
      /** Names leave out numbers, and the state in a summary. */
      const nameOf = (control: HTMLElement) => {
        const place = control.parentElement?.closest('[aria-label]')?.getAttribute('aria-label') ?? '';
        const { textContent } =
          control.localName === 'summary' ? (control.firstElementChild ?? control) : control;
        const { labels } = control as HTMLInputElement;
        const label = control.getAttribute('aria-label') ?? labels?.[0]?.textContent ?? textContent ?? '';
        const own = control.dataset.command ?? label.replace(/[\d.,]+/g, '#').trim();
        return `${place} › ${own}`.replace(/\s+/g, ' ');
      };
      const controls = all(pressable).filter(
        (control) =>
          !control.matches(`:disabled, .stage *, .clip-key, ${later}`) &&
          control.checkVisibility({ visibilityProperty: true }),
      );
      const isOpen = (control: Element) => control.closest('[popover]') !== null;
      const waiting = controls.filter((control) => !pressed.includes(nameOf(control)));
      // A press beside an open card would close it: its controls come first.
      waiting.sort((a, b) => Number(isOpen(b)) - Number(isOpen(a)));
      let next: Seen['next'] = null;
      for (const control of waiting) {
        control.scrollIntoView({ block: 'nearest', inline: 'nearest' });
        const { left, top, width, height } = control.getBoundingClientRect();
        const [x, y] = [left + width / 2, top + height / 2];
        const under = root.elementFromPoint(x, y);
        if (!under || !(control.contains(under) || under.contains(control))) continue;
        next = { name: nameOf(control), x, y };
        break;
      }
      const keys = all('.clip-key[aria-pressed="true"]');
      const handles = all('.handle[data-handle]');
      const chosen = handles.filter((handle) => handle.getAttribute('aria-pressed') === 'true');
      return {
        selected:
          keys.length > 0
            ? keys.map(({ dataset }) => `key of ${dataset.keyOf} at ${dataset.time}`)
            : chosen.map(({ dataset }) => `handle ${dataset.handle}`),
        keys: all('.clip-key').length,
        handles: handles.length,
        inside:
          root.activeElement?.matches('input:is([type=text], [type=url])') === true ||
          root.querySelector(':is(select, input):open') !== null,
        changed: root.querySelector('[data-command="undo"]:not(:disabled)') !== null,
        playing: root.querySelector('.clip-bar [data-command="play"][aria-label="Stop"]') !== null,
        timeline: root.querySelector('.timeline') !== null,
        picture: root.querySelector('.top .title')?.textContent?.match(/\S+\.png/)?.[0] ?? '',
        controls: controls.map(nameOf),
        next,
      };
    },
    { pressable: PRESSABLE, later: LATER, pressed },
  );

interface Walked {
  /** Controls after whose press Delete was checked. */
  readonly checked: readonly string[];
  /** Controls that change the selection. */
  readonly changing: readonly string[];
  /** Controls that were there once, or only after a press of those. */
  readonly missed: readonly string[];
}

/** Presses all controls. @param select makes the selection, and whatever shows it. */
async function walk(editor: Editor, select: () => Promise<void>): Promise<Walked> {
  const { page } = editor;
  const pressed: string[] = [];
  const [checked, changing, missed]: [string[], string[], string[]] = [[], [], []];
  /** The control after whose press another one has appeared. */
  const openers = new Map<string, string>();
  const { keyboard, mouse } = page;
  await select();
  const wanted = await look(page, pressed);
  expect(wanted.selected).not.toEqual([]);
  const ofKeys = wanted.selected[0]?.startsWith('key') === true;
  const count = ({ keys, handles }: Seen) => (ofKeys ? keys : handles);
  const note = (controls: readonly string[], opener: string) => {
    for (const name of controls) if (!openers.has(name)) openers.set(name, opener);
  };
  note(wanted.controls, '');

  /** Undoes the last press. */
  const restore = async (): Promise<Seen> => {
    let seen = await look(page, pressed);
    if (seen.picture !== wanted.picture) {
      await page.evaluate(() => indexedDB.deleteDatabase('c2warp'));
      await page.goto('/');
      await editor.ready();
    }
    if (seen.playing) await keyboard.press('k');
    for (let steps = 0; seen.changed && steps < 9; steps++) {
      await keyboard.press('Control+z');
      seen = await look(page, pressed);
    }
    if (String(seen.selected) !== String(wanted.selected)) {
      await select();
      seen = await look(page, pressed);
    }
    expect(seen.selected, `after ${pressed.at(-1)}`).toEqual(wanted.selected);
    return seen;
  };

  /** The place of a control, once all is pressed again that leads to it. */
  const reach = async (name: string): Promise<Seen['next']> => {
    const others = [...openers.keys()].filter((other) => other !== name);
    const { next } = await look(page, others);
    const opener = openers.get(name);
    const way = next || !opener ? null : await reach(opener);
    if (!way) return next;
    await mouse.click(way.x, way.y);
    return (await look(page, others)).next;
  };

  /** A control that is no longer in view. */
  const hidden = async (): Promise<Seen['next']> => {
    for (const name of openers.keys()) {
      if (pressed.includes(name)) continue;
      await page.locator('c2-warp').evaluate(({ shadowRoot }) => {
        const open = shadowRoot?.querySelectorAll<HTMLElement>(':popover-open') ?? [];
        for (const popover of open) popover.hidePopover();
      });
      const next = await reach(name);
      const { selected } = await look(page, pressed);
      if (next && String(selected) === String(wanted.selected)) return next;
      // It was there once, as the buttons of notices are, or the way to it changes the selection.
      pressed.push(name);
      missed.push(name);
      await restore();
    }
    return null;
  };

  let now = wanted;
  for (let presses = 0; presses < MOST_PRESSES; presses++) {
    const next = now.next ?? (await hidden());
    if (!next) return { checked, changing, missed };
    const { name, x, y } = next;
    pressed.push(name);
    note([name], '');
    await mouse.click(x, y);
    await editor.waitFrames();
    let after = await look(page, pressed);
    if (after.inside) {
      await keyboard.press('Escape');
      const isInside = async () => {
        after = await look(page, pressed);
        return after.inside;
      };
      await expect.poll(isInside, `Escape after ${name}`).toBe(false);
    }
    if (String(after.selected) !== String(wanted.selected)) {
      changing.push(name);
      now = await restore();
      continue;
    }
    note(after.controls, name);
    await keyboard.press('Delete');
    const deleted = await look(page, pressed);
    expect(count(deleted), `Delete after ${name}`).toBe(count(after) - wanted.selected.length);
    if (ofKeys) expect(deleted.handles, name).toBe(after.handles);
    await keyboard.press('Control+z');
    now = await look(page, pressed);
    expect([count(now), now.selected], `undo after ${name}`).toEqual([count(after), wanted.selected]);
    checked.push(name);
    if (now.changed || now.playing) now = await restore();
  }
  throw new Error('the walk does not end');
}

/** Controls that may change the selection: tools that draw, clips, lists of handles, samples, and commands. */
const CHANGING = new RegExp(
  [
    'Document › (undo|redo|timeline)',
    'Tools › (bar|polygon|lasso|brush)',
    'Selected handle › (Rename head|mirror|remove)',
    'Clips › (Duplicate the clip|Delete the clip|Close the timeline)',
    'Keys › (set-key|cut-keys|paste-keys|remove-keys)',
    '(Properties|head|left hand|right hand|left foot|right foot) › (head|left hand|right hand|left foot|right foot)',
    'Samples › .*',
  ]
    .map((name) => `^${name}$`)
    .join('|'),
);

/** Fails unless Delete was checked after presses everywhere, and nothing has changed the selection by accident. */
function expectWhole({ checked, changing }: Walked): void {
  expect(changing.filter((name) => !CHANGING.test(name))).toEqual([]);
  const everywhere = [
    'Document › Overlays',
    'Document › Keyboard shortcuts',
    'Tools › hand',
    'View › zoom-in',
    'Type › Film',
    'Format › GIF',
    'Page › Rounds',
  ];
  expect(everywhere.filter((name) => !checked.includes(name))).toEqual([]);
  expect(checked.length).toBeGreaterThan(90);
}

test.beforeEach(async ({ page }) => {
  test.setTimeout(600_000);
  // Every press poses the picture, and the walk needs no detail.
  await page.route('**/samples/gingerbread.c2warp.json', async (route) => {
    const json = await (await route.fetch()).json();
    await route.fulfill({ json: { ...json, samples: 1500, pose: { ...json.pose, density: 30 } } });
  });
  page.on('filechooser', () => {});
  page.on('download', (download) => download.cancel());
});

test('after a press on any control, Delete deletes the keys shown as selected', async ({ page }) => {
  const editor = await Editor.open(page);
  const timeline = page.getByRole('region', { name: 'Timeline' });
  const key = timeline.getByRole('button', { name: /^head, key at/ }).nth(1);
  const walked = await walk(editor, async () => {
    if (!(await timeline.isVisible())) await page.keyboard.press('t');
    await key.click();
  });
  expectWhole(walked);
  // The card of a selected handle folds the settings.
  const more = [
    'Clips › Zoom out',
    'Clips › play',
    'Clips › Loop',
    'Timeline › Playhead',
    'Bending › Elastic',
  ];
  expect(more.filter((name) => !walked.checked.includes(name))).toEqual([]);
});

test('after a press on any control, Delete deletes the selected handle', async ({ page }) => {
  const editor = await Editor.open(page);
  expectWhole(
    await walk(editor, async () => {
      await page.keyboard.press('v');
      await page.keyboard.press('0');
      const { x, y } = await editor.position('head');
      await page.mouse.click(x, y);
    }),
  );
});
