/** The manifest and the running elements: nothing undocumented, and nothing documented that is not there. */
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { type Element as Documented, elements, hiddenNames } from '../../web/scripts/manifest/manifest.mjs';
import type { C2Warp } from '../../web/src/element';
import type { C2WarpPlayer } from '../../web/src/player';
import { Editor } from './editor';
import { expect, test } from './fixtures';
import { WorkerReplies } from './worker_replies';

const ALL = elements();
const [WARP, PLAYER] = ALL as [Documented, Documented];
const RIG = new URL('../../web/src/player/fixtures/posable.c2rig', import.meta.url);

const names = (members: readonly { readonly name: string }[]) => members.map(({ name }) => name).sort();

/** An attribute and the property that it sets; a property and the attribute that it sets. */
type Reflection = readonly [text: string | null, value: unknown, written: unknown, attribute: string | null];

/** By the rules of HTML for attributes of this type, whose property begins with `first`. */
function reflections(
  { text, words }: Documented['attributes'][number]['type'],
  name: string,
  first: unknown,
): Reflection[] {
  const absent: Reflection = [null, first, null, null];
  if (text === 'boolean')
    return [['', true, true, ''], absent, ['false', true, 'yes', ''], [null, false, false, null]];
  if (text === 'number')
    return [['12', 12, 12, '12'], ['7.9px', 7, 3, '3'], ['-1', 0, 0, '0'], ['x', 0, 1, '1'], absent];
  const known = (words ?? []).map((word): Reflection => [word.toUpperCase(), word, word, word]);
  const invalid = name === 'crossorigin' ? 'anonymous' : first;
  if (words) return [...known, ['', invalid, '', ''], ['none of these', invalid, 'x', 'x'], absent];
  if (['src', 'project', 'poster'].includes(name))
    return [
      ['/favicon.svg', '/favicon.svg', '/favicon.svg', '/favicon.svg'],
      ['', '', '', ''],
      ['http://[', 'http://[', '/favicon.svg', '/favicon.svg'],
      absent,
    ];
  return [['open', 'open', 'open', 'open'], ['', '', '', ''], [' A ', ' A ', 3, '3'], absent];
}

/** A page with both elements, which show nothing yet. */
async function openBlank(page: Page): Promise<void> {
  await page.goto('/harness/');
  for (const url of ['/element/c2warp.js', '/player/c2warp-player.js'])
    await page.addScriptTag({ type: 'module', url });
  await page.evaluate(
    async (tags) => {
      await Promise.all(tags.map((tag) => customElements.whenDefined(tag)));
    },
    names(ALL.map(({ tagName: name }) => ({ name }))),
  );
}

for (const element of ALL) {
  const { tagName } = element;

  test(`<${tagName}> has the documented properties and methods, and no others`, async ({ page }) => {
    await openBlank(page);
    const found = await page.evaluate((tag) => {
      const shown = document.createElement(tag);
      const members: { name: string; isMethod: boolean; isReadonly: boolean }[] = [];
      let prototype = Object.getPrototypeOf(shown);
      for (; prototype !== HTMLElement.prototype; prototype = Object.getPrototypeOf(prototype))
        for (const [name, { value, set }] of Object.entries(Object.getOwnPropertyDescriptors(prototype)))
          members.push({ name, isMethod: typeof value === 'function', isReadonly: set === undefined });
      return members;
    }, tagName);
    const hidden = ['constructor', ...hiddenNames()];
    const shown = new Map(found.filter(({ name }) => !hidden.includes(name)).map((one) => [one.name, one]));
    expect([...shown.keys()].sort()).toEqual(names([...element.fields, ...element.methods]));
    for (const { name, readonly = false } of element.fields)
      expect([shown.get(name)?.isMethod, shown.get(name)?.isReadonly], name).toEqual([false, readonly]);
    for (const { name } of element.methods) expect(shown.get(name)?.isMethod, name).toBe(true);
  });

  test(`the properties of <${tagName}> begin with their documented values`, async ({ page }) => {
    await openBlank(page);
    const documented = element.fields.flatMap(({ name, ...rest }) =>
      rest.default === undefined ? [] : [[name, rest.default.replaceAll("'", '"')] as const],
    );
    const found = await page.evaluate(
      ([tag, fields]) => {
        const element = document.createElement(tag);
        return fields.map(([name]) => [name, JSON.stringify(Reflect.get(element, name))]);
      },
      [tagName, documented] as const,
    );
    expect(found).toEqual(documented);
  });

  test(`the attributes of <${tagName}> set properties, and properties set attributes`, async ({ page }) => {
    await openBlank(page);
    const observed = await page.evaluate((tag) => {
      const defined = customElements.get(tag) as CustomElementConstructor & {
        observedAttributes: string[];
      };
      return defined.observedAttributes;
    }, tagName);
    const documented = names(element.attributes);
    expect(documented).toEqual(expect.arrayContaining(observed));
    if (element === WARP) expect(documented).toEqual([...observed].sort());
    for (const { name, fieldName = '', type, default: initial = 'null' } of element.attributes) {
      const first = JSON.parse(initial.replaceAll("'", '"'));
      const read = await page.evaluate(
        ([tag, name, field, rows]) => {
          const results = [false, true].map((connected) => {
            const [read, written] = [document.createElement(tag), document.createElement(tag)];
            if (connected) document.body.append(read, written);
            const values = [Reflect.get(read, field)];
            for (const [text] of rows) {
              if (text === null) read.removeAttribute(name);
              else read.setAttribute(name, text);
              values.push(Reflect.get(read, field));
            }
            const texts = rows.map(([, , value]) => {
              Reflect.set(written, field, value);
              return written.getAttribute(name);
            });
            // Frameworks take a property back so.
            Reflect.set(written, field, undefined);
            const removed = written.getAttribute(name);
            read.remove();
            written.remove();
            return { values, texts, removed };
          });
          return results;
        },
        [tagName, name, fieldName, reflections(type, name, first).map(([...row]) => row)] as const,
      );
      const rows = reflections(type, name, first);
      const origin = new URL(page.url()).origin;
      const values = rows.map(([, value]) => (value === '/favicon.svg' ? `${origin}${value}` : value));
      const texts = rows.map(([, , , text]) => text);
      for (const found of read)
        expect(found, name).toEqual({ values: [first, ...values], texts, removed: null });
    }
  });
}

interface Heard {
  readonly type: string;
  readonly bubbles: boolean;
  readonly cancelable: boolean;
  readonly hasDetail: boolean;
}

/** Notes each event that scripts of an element dispatch on it. */
const listen = (page: Page, tag: string) =>
  page.addInitScript((tag) => {
    const heard: Heard[] = [];
    Object.assign(globalThis, { heard });
    const { dispatchEvent } = EventTarget.prototype;
    EventTarget.prototype.dispatchEvent = function (event: Event) {
      if (this instanceof Element && this.localName === tag && !(event instanceof DragEvent)) {
        const { type, bubbles, cancelable } = event;
        heard.push({ type, bubbles, cancelable, hasDetail: Reflect.get(event, 'detail') != null });
      }
      return dispatchEvent.call(this, event);
    };
  }, tag);

const heard = async (page: Page): Promise<readonly Heard[]> => {
  const all = await page.evaluate(() => Reflect.get(globalThis, 'heard') as Heard[]);
  const byType = new Map(all.map((event) => [event.type, event]));
  return [...byType.values()].sort((a, b) => (a.type < b.type ? -1 : 1));
};

const documentedEvents = ({ events }: Documented): Heard[] =>
  events
    .map(({ name, bubbles = false, cancelable = false, detail }) => ({
      type: name,
      bubbles,
      cancelable,
      hasDetail: detail !== undefined && detail.text !== 'null',
    }))
    .sort((a, b) => (a.type < b.type ? -1 : 1));

const has = (page: Page, ...types: readonly string[]) =>
  expect
    .poll(async () => (await heard(page)).map(({ type }) => type))
    .toEqual(expect.arrayContaining([...types]));

/** Notes every part that is shown at some time, and the texts of style sheets. */
const watchStyles = (page: Page) =>
  page.addInitScript(() => {
    const [parts, sheets] = [new Set<string>(), [] as string[]];
    Object.assign(globalThis, { parts, sheets });
    const note = (root: ParentNode) => {
      for (const element of root.querySelectorAll('[part]')) for (const name of element.part) parts.add(name);
    };
    const { attachShadow } = Element.prototype;
    Element.prototype.attachShadow = function (init) {
      const root = attachShadow.call(this, init);
      new MutationObserver(() => note(root)).observe(root, { childList: true, subtree: true });
      return root;
    };
    const { replaceSync } = CSSStyleSheet.prototype;
    // The object model drops shorthands with variables.
    CSSStyleSheet.prototype.replaceSync = function (text) {
      sheets.push(text);
      replaceSync.call(this, text);
    };
  });

/** Parts that were shown, custom properties that style sheets read, and slots, of the one element of a page. */
const stylesOf = (page: Page, tag: string) =>
  page.locator(tag).evaluate(({ shadowRoot }) => {
    const { parts, sheets } = globalThis as unknown as { parts: Set<string>; sheets: string[] };
    const used = sheets.join('\n').matchAll(/var\(\s*(--(?!_)[\w-]+)/g);
    return {
      parts: [...parts].sort(),
      cssProperties: [...new Set([...used].map(([, name]) => name))].sort(),
      slots: [...(shadowRoot as ShadowRoot).querySelectorAll('slot')].map(({ name }) => name).sort(),
    };
  });

const documentedStyles = ({ cssParts, cssProperties, slots }: Documented) => ({
  parts: names(cssParts),
  cssProperties: names(cssProperties),
  slots: names(slots),
});

test('<c2-warp> fires the documented events, and has the documented parts', async ({ page }) => {
  await listen(page, 'c2-warp');
  await watchStyles(page);
  const replies = await WorkerReplies.intercept(page);
  const editor = await Editor.open(page);
  const warp = page.locator('c2-warp');
  await editor.dragHandle('left hand', { x: 20, y: -30 });
  await has(page, 'ready', 'load', 'input', 'change', 'historychange', 'selectionchange', 'titlechange');

  await warp.evaluate((element) => element.setAttribute('theme', 'blue'));
  await has(page, 'error');

  const at = await editor.fromImage('head', [512, 260]);
  await page.keyboard.press('p');
  const { x, y } = at(512, 700);
  await page.mouse.click(x, y);
  await page.keyboard.press('Delete');
  await page.keyboard.press('v');
  await has(page, 'toolchange', 'beforeadd', 'beforeremove');

  await page.keyboard.press('t');
  await expect(page.getByRole('region', { name: 'Timeline' })).toBeVisible();
  await warp.evaluate(async (element) => {
    const warp = element as C2Warp;
    const { clips = [], ...project } = warp.project;
    warp.project = { ...project, clips: clips.map((clip) => ({ ...clip, loop: 'none' })) };
    await warp.play();
    warp.pause();
    warp.playbackRate = 16;
    await warp.play();
  });
  await has(page, 'play', 'pause', 'timeupdate', 'ended');

  const saved = page.waitForEvent('download');
  await editor.button('Save').click();
  await saved;
  await replies.hold();
  const exported = page.waitForEvent('download');
  await editor.pressExport();
  await has(page, 'progress');
  await replies.release();
  await exported;
  const buffer = Buffer.from(await (await page.request.get('/samples/cat.png')).body());
  await editor.chooseFile({ name: 'cat.png', mimeType: 'image/png', buffer });
  await has(page, 'beforesave', 'beforeexport', 'beforeopen');

  expect(await heard(page)).toEqual(documentedEvents(WARP));
  expect(await stylesOf(page, 'c2-warp')).toEqual(documentedStyles(WARP));
});

test('<c2-warp-player> fires the documented events, and has the documented parts', async ({ page }) => {
  await listen(page, 'c2-warp-player');
  await watchStyles(page);
  await page.route('**/posable.c2rig', (route) => route.fulfill({ body: readFileSync(RIG) }));
  await openBlank(page);
  await page.evaluate(() => {
    const player = document.createElement('c2-warp-player');
    Object.assign(player, { src: '/posable.c2rig', poster: '/favicon.svg', posable: true });
    player.style.width = '256px';
    document.body.append(player);
  });
  await has(page, 'loadeddata');
  const player = page.locator('c2-warp-player');
  const grip = player.getByRole('button').first();
  await expect(grip).toBeVisible();
  await grip.focus();
  await page.keyboard.press('ArrowRight');
  await has(page, 'input', 'change');
  await player.evaluate(async (element) => {
    const player = element as C2WarpPlayer;
    await player.play();
    player.pause();
    player.playbackRate = 16;
    await player.play();
  });
  await has(page, 'play', 'pause', 'timeupdate', 'ratechange', 'ended');
  await player.evaluate((element) => element.setAttribute('clip', 'no such clip'));
  await has(page, 'error');
  expect(await heard(page)).toEqual(documentedEvents(PLAYER));
  expect(await stylesOf(page, 'c2-warp-player')).toEqual(documentedStyles(PLAYER));
});
