/** `c2warp/react` by React 19 and React 18: properties, listeners, references, and markup of servers. */
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { expect, test } from './fixtures';
import type { ReactPage } from './react/page';

const SOURCE = { src: '/samples/gingerbread.png', project: '/samples/gingerbread.c2warp.json' };

async function open(page: Page, url: string): Promise<void> {
  await page.goto(url);
  await page.addScriptTag({ type: 'module', url: '/element/c2warp.js' });
  await page.evaluate(() => customElements.whenDefined('c2-warp'));
  await page.waitForFunction(() => 'page' in globalThis);
}

const heard = (page: Page) => page.evaluate(() => Reflect.get(globalThis, 'heard') as unknown[]);

for (const version of ['react', 'react-18']) {
  test.describe(version, () => {
    test('sets properties, listens, and hands out the element', async ({ page }) => {
      await open(page, `/${version}/`);
      await page.evaluate((source) => {
        const { C2Warp, createElement, createRef, createRoot, StrictMode } = Reflect.get(
          globalThis,
          'page',
        ) as ReactPage;
        const heard: unknown[] = [];
        const ref = createRef<C2Warp>();
        const root = createRoot(document.querySelector('#root') as Element);
        const render = (props: object, listener: string) => {
          const onSelectionChange = ({ detail }: CustomEvent) => heard.push([listener, detail.selection]);
          const all = { ...source, ref, onSelectionChange, className: 'wide', ...props };
          root.render(createElement(StrictMode, null, createElement(C2Warp, all)));
        };
        const onLoad = ({ detail }: CustomEvent) => heard.push(['load', detail.origin]);
        Object.assign(globalThis, { heard, ref, render });
        render({ onLoad, readonly: true, tool: 'hand', posable: false }, 'first');
      }, SOURCE);
      await expect.poll(() => heard(page)).toEqual([['load', 'page']]);
      const shown = () =>
        page.evaluate(() => {
          const { current } = Reflect.get(globalThis, 'ref') as { current: C2Warp };
          const { className, readonly, posable, tool, project, localName } = current;
          return { className, readonly, posable, tool, handles: project.handles.length, localName };
        });
      const first = { className: 'wide', posable: false, handles: 5, localName: 'c2-warp' };
      expect(await shown()).toEqual({ ...first, readonly: true, tool: 'hand' });
      await page.evaluate(() => Reflect.get(globalThis, 'render')({ selection: ['head'] }, 'second'));
      await expect.poll(async () => (await heard(page)).at(-1)).toEqual(['second', ['head']]);
      expect(await shown()).toEqual({ ...first, readonly: false, tool: 'hand' });
      expect(await heard(page)).toHaveLength(2);
    });

    test('keeps changes by a reader, until the page sets another value', async ({ page }) => {
      await open(page, `/${version}/`);
      await page.evaluate((source) => {
        const { C2Warp, createElement, createRoot } = Reflect.get(globalThis, 'page') as ReactPage;
        const root = createRoot(document.querySelector('#root') as Element);
        const render = (props: object) => root.render(createElement(C2Warp, { ...source, ...props }));
        Object.assign(globalThis, { render });
        render({ tool: 'hand' });
      }, SOURCE);
      const warp = page.locator('c2-warp');
      const tool = () => warp.evaluate((element) => (element as C2Warp).tool);
      await warp.evaluate((element) => (element as C2Warp).loaded);
      await warp.evaluate((element) => Object.assign(element, { tool: 'bar' }));
      await expect.poll(tool).toBe('bar');
      await page.evaluate(() => Reflect.get(globalThis, 'render')({ tool: 'hand', title: 'again' }));
      await expect(warp).toHaveAttribute('title', 'again');
      expect(await tool()).toBe('bar');
      await page.evaluate(() => Reflect.get(globalThis, 'render')({ tool: 'point' }));
      await expect.poll(tool).toBe('point');
    });

    test('hydrates the markup of a server, and misses no event', async ({ page }) => {
      await open(page, `/${version}/`);
      await page.evaluate((source) => {
        const { C2Warp, createElement, hydrateRoot } = Reflect.get(globalThis, 'page') as ReactPage;
        const heard: unknown[] = [];
        Object.assign(globalThis, { heard });
        const onLoad = ({ detail }: CustomEvent) => heard.push(detail.origin);
        const app = createElement(C2Warp, { ...source, posable: true, onLoad, className: 'wide' });
        const root = document.querySelector('#root') as Element;
        const markup = '<c2-warp class="wide"></c2-warp>';
        root.append(document.createRange().createContextualFragment(markup));
        hydrateRoot(root, app);
      }, SOURCE);
      await expect.poll(() => heard(page)).toEqual(['page']);
      await expect(page.locator('c2-warp')).toHaveAttribute('posable', '');
    });
  });
}
