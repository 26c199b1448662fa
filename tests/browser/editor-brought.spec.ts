/** Brought to the editor: several files at once, projects whose pictures come later, addresses. */
import { mkdir, writeFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import type { C2Warp } from '../../web/src/element';
import { Editor } from './editor';
import { bring, disc, png, project } from './files';
import { expect, test } from './fixtures';

const note = { name: 'note.txt', mimeType: 'text/plain', buffer: Buffer.from('words') };

/** A project with one handle, for a picture of 64 × 64 px. */
const posed = (id: string, src: string) => ({
  format: 'c2warp/1',
  image: { src, width: 64, height: 64 },
  handles: [{ id, kind: 'point', rest: [32, 32], posed: [36, 30] }],
});

test('a drop opens its first picture, and a notice names the other files', async ({ page }) => {
  const editor = await Editor.open(page);
  const unknown = { name: '.hidden', mimeType: '', buffer: Buffer.from('nothing') };
  await bring(
    editor,
    'drop',
    note,
    unknown,
    png('damaged.png', disc(64).subarray(0, 90)),
    png('disc.png', disc(64)),
  );
  await expect(editor.status).toContainText('64 × 64 px');
  await expect(page.getByText('disc.png', { exact: true })).toBeVisible();
  await expect(page.getByText('note.txt and 2 more were not opened')).toBeVisible();
  await expect(editor.notice).toBeHidden();
});

for (const name of ['holiday', 'old.c2warp.json']) {
  test(`a folder ${name} dropped before a picture is named, and the picture opens`, async ({ page }) => {
    const editor = await Editor.open(page);
    const [folder, picture] = [test.info().outputPath(name), test.info().outputPath('disc.png')];
    await mkdir(folder, { recursive: true });
    await writeFile(picture, disc(64));
    const devtools = await page.context().newCDPSession(page);
    const data = { items: [], files: [folder, picture], dragOperationsMask: 1 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await devtools.send('Input.dispatchDragEvent', { type, x: 300, y: 300, data });
    }
    await expect(editor.status).toContainText('64 × 64 px');
    await expect(page.getByText(`${name} was not opened`)).toBeVisible();
    await expect(editor.handles).toHaveCount(0);
  });
}

test('a waiting project is only used by its own picture', async ({ page }) => {
  const editor = await Editor.open(page);
  const asks = page.getByText('belongs to the picture a.png (64 × 64 px)');
  const open = async (...files: readonly ReturnType<typeof png>[]) => {
    await bring(editor, 'drop', ...files);
    const picture = files.find(({ mimeType }) => mimeType === 'image/png')?.name ?? '';
    await expect(page.getByText(picture, { exact: true })).toBeVisible();
    await expect(editor.solved).toContainText('64 × 64 px');
  };
  await bring(editor, 'drop', project(posed('first', 'a.png'), 'a.c2warp.json'));
  await expect(asks).toBeVisible();
  await page.locator('c2-warp').evaluate((element) => (element as C2Warp).load('/samples/gingerbread.png'));
  await expect(editor.solved).toContainText('1024 × 1280 px');
  await expect(asks).toBeVisible();
  await open(png('b.png', disc(64)));
  await expect(editor.handles).toHaveCount(0);
  await expect(asks).toBeVisible();
  // Another project is loaded with the requested picture.
  await open(project(posed('second', 'a.png'), 'other.json'), png('a.png', disc(64)));
  await expect(editor.handle('second')).toBeVisible();
  await expect(asks).toBeHidden();
  await open(png('a.png', disc(64)));
  await expect(editor.handles).toHaveCount(0);
});

test('a newer offer closes an older error', async ({ page }) => {
  const editor = await Editor.open(page);
  await bring(editor, 'drop', project('{}', 'other.json'));
  await expect(editor.notice).toContainText('format: missing');
  await bring(editor, 'drop', project(posed('first', 'a.png'), 'a.c2warp.json'));
  await expect(editor.button('Open picture')).toBeVisible();
  await expect(editor.notice).toBeHidden();
});

/** Serves pictures from another origin, which other pages may read if `shared`. */
async function elsewhere(page: Page, shared: boolean): Promise<void> {
  await page.route('https://pictures.example/**', (route) => {
    // Playwright adds the header where it is missing.
    const headers = { 'Access-Control-Allow-Origin': shared ? '*' : 'https://another.example' };
    const { pathname } = new URL(route.request().url());
    if (pathname.endsWith('.json')) return route.fulfill({ headers, json: posed('first', 'disc.png') });
    if (pathname.endsWith('.png'))
      return route.fulfill({ headers, body: disc(64), contentType: 'image/png' });
    return route.fulfill({ headers, body: '<!doctype html>', contentType: 'text/html' });
  });
}

/** Dispatches a drop or a paste of texts, by their types. */
async function bringTexts(
  editor: Editor,
  event: 'drop' | 'paste',
  texts: Readonly<Record<string, string>>,
): Promise<void> {
  await editor.page.locator('c2-warp .stage').focus();
  await editor.page.locator('c2-warp').evaluate(
    (element, { event, texts }) => {
      const transfer = new DataTransfer();
      for (const [type, text] of Object.entries(texts)) transfer.setData(type, text);
      const init = { bubbles: true, cancelable: true, composed: true };
      element.dispatchEvent(
        event === 'drop'
          ? new DragEvent('drop', { ...init, dataTransfer: transfer })
          : new ClipboardEvent('paste', { ...init, clipboardData: transfer }),
      );
    },
    { event, texts },
  );
}

const DISC = 'https://pictures.example/disc.png';

test.describe('addresses', () => {
  // The browser reports refused requests as errors.
  test.use({ strict: undefined });

  const brought: [title: string, event: 'drop' | 'paste', texts: Readonly<Record<string, string>>][] = [
    ['a pasted address', 'paste', { 'text/plain': ` ${DISC}\n` }],
    [
      'pasted HTML with a picture',
      'paste',
      { 'text/html': `<p><img src="${DISC}"></p>`, 'text/plain': 'a disc' },
    ],
    ['a dropped link', 'drop', { 'text/uri-list': `# a link\r\n${DISC}`, 'text/plain': DISC }],
    [
      'a picture dragged out of a link',
      'drop',
      { 'text/uri-list': 'https://pictures.example/page', 'text/html': `<a><img src='${DISC}'></a>` },
    ],
    ['a pasted data URL', 'paste', { 'text/plain': `data:image/png;base64,${disc(64).toString('base64')}` }],
  ];
  for (const [title, event, texts] of brought) {
    test(`${title} opens, and the work before is kept`, async ({ page }) => {
      await elsewhere(page, true);
      const editor = await Editor.open(page);
      await editor.dragHandle('left hand', { x: 20, y: -40 });
      await bringTexts(editor, event, texts);
      await expect(editor.status).toContainText('64 × 64 px');
      await expect(editor.button('Back to gingerbread.png')).toBeVisible();
    });
  }

  test('a picture that its server does not share is refused in plain words', async ({ page }) => {
    await elsewhere(page, false);
    const editor = await Editor.open(page);
    await bringTexts(editor, 'drop', { 'text/uri-list': DISC });
    await expect(editor.notice).toContainText(
      'Could not load disc.png. pictures.example does not let this page read it (CORS), or cannot be reached.',
    );
    await expect(editor.handles).toHaveCount(5);
  });

  test('a web page in place of a picture, and a drop without a link, are named', async ({ page }) => {
    await elsewhere(page, true);
    const editor = await Editor.open(page);
    await bringTexts(editor, 'paste', { 'text/plain': 'https://pictures.example/page' });
    await expect(editor.notice).toContainText('page is a web page');
    await editor.notice.getByRole('button', { name: 'Dismiss' }).click();
    await bringTexts(editor, 'drop', { 'text/html': '<p>words</p>' });
    await expect(page.getByText('Drop a picture or a link to one')).toBeVisible();
  });

  test('the field beside Open takes addresses of pictures and projects', async ({ page }) => {
    await elsewhere(page, true);
    const editor = await Editor.open(page);
    const type = async (text: string) => {
      await editor.button('Open recent work').click();
      await page.getByRole('textbox', { name: 'Address of a picture or project' }).fill(text);
      await page.keyboard.press('Enter');
    };
    await type('disc.png');
    await expect(editor.notice).toContainText('“disc.png” is not the address of a picture');
    await type('https://pictures.example/pose.json');
    await expect(page.getByText('pose.json belongs to the picture disc.png')).toBeVisible();
    await expect(editor.notice).toBeHidden();
    await type(DISC);
    await expect(editor.handle('first')).toBeVisible();
  });

  test('a slow address shows that it opens, and can be cancelled', async ({ page }) => {
    let come = () => {};
    const comes = new Promise<void>((done) => {
      come = done;
    });
    await page.route('https://pictures.example/**', async (route) => {
      await comes;
      await route.abort();
    });
    const editor = await Editor.open(page);
    await bringTexts(editor, 'paste', { 'text/plain': DISC });
    await expect(editor.status).toContainText('Opening disc.png');
    await expect(page.getByRole('progressbar', { name: 'Opening disc.png' })).toBeVisible();
    await editor.status.getByRole('button', { name: 'Cancel' }).click();
    await expect(editor.solved).toContainText('1024 × 1280 px');
    come();
    await expect(editor.notice).toBeHidden();
  });

  test('an address of the page that cannot be opened is refused in a notice', async ({ page }) => {
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    await page.goto('/?src=samples/missing.png');
    const editor = new Editor(page);
    await expect(editor.notice).toContainText('Could not load missing.png: the server answered 404');
    expect(asked.filter((address) => address.includes('missing.png') && !address.includes('?'))).toHaveLength(
      1,
    );
  });
});

const CACTUS = '/?src=samples/cactus.png&project=samples/cactus.c2warp.json';

test('the address of the page names a picture, which opens where there is no work', async ({ page }) => {
  await page.goto(CACTUS);
  const editor = new Editor(page);
  await expect(editor.handle('left arm')).toBeVisible();
  await expect(page).toHaveTitle('cactus.png – c2warp');
  await expect(editor.notice).toBeHidden();
});

test('the address of the page offers a picture in place of stored work', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.dragHandle('left hand', { x: 20, y: -40 });
  await expect.poll(() => editor.storedWork()).toMatchObject({ step: 'Move left hand' });
  await page.goto(CACTUS);
  const notice = page.locator('c2-warp .notice');
  await expect(notice).toContainText('A link or another program wants to open cactus.png.');
  await expect(editor.button('Undo: move left hand')).toBeEnabled();
  await notice.getByRole('button', { name: 'Open' }).click();
  await expect(editor.handle('left arm')).toBeVisible();
  await expect(page).toHaveTitle('cactus.png – c2warp');
  await editor.openRecent('gingerbread.png');
  await expect(editor.button('Undo: move left hand')).toBeEnabled();
});

test('samples open with their handles', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [name, handle, count] of [
    ['octopus', 'arm 1', 7],
    ['cactus', 'left arm', 5],
    ['cat', 'tail tip', 6],
    ['giraffe', 'neck', 8],
    ['snake', 'belly', 5],
    ['robot', 'body', 10],
    ['salamander', 'hips', 8],
    ['portrait', 'chin', 11],
    ['gingerbread', 'left hand', 5],
  ] as const) {
    await editor.button('Open recent work').click();
    await editor.button(`Open the sample ${name}`).click();
    await expect(editor.handle(handle)).toBeVisible();
    await expect(editor.handles).toHaveCount(count);
    await expect(page).toHaveTitle(`${name}.png – c2warp`);
  }
});

/** Shows a clip of the project at a time in seconds. */
const showMoment = (page: Page, clip: string, seconds: number) =>
  page.locator('c2-warp').evaluate(
    async (element, [clip, seconds]) => {
      const warp = element as C2Warp;
      warp.clip = clip;
      await warp.updateComplete;
      warp.currentTime = seconds;
    },
    [clip, seconds] as const,
  );

test('samples have clips that move their handles', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [name, clips] of [
    ['cat', { breathe: 'head', tail: 'tail tip' }],
    ['portrait', { tilt: 'brow' }],
    ['gingerbread', { wave: 'right hand', 'walk in place': 'left foot' }],
  ] as const) {
    await editor.waitForSolve(async () => {
      await editor.button('Open recent work').click();
      await editor.button(`Open the sample ${name}`).click();
    });
    await expect(page).toHaveTitle(`${name}.png – c2warp`);
    const named = await page
      .locator('c2-warp')
      .evaluate((element) => (element as C2Warp).project.clips?.map(({ name }) => name));
    expect(named).toEqual(Object.keys(clips));
    for (const [clip, handle] of Object.entries(clips)) {
      const rest = await editor.shownPose(handle);
      await showMoment(page, clip, 0.75);
      await expect.poll(() => editor.shownPose(handle)).not.toEqual(rest);
    }
  }
});

test('nothing is requested beyond the editor and its samples', async ({ page, baseURL }) => {
  const origins = new Set<string>();
  page.on('request', (request) => {
    if (/^https?:/.test(request.url())) origins.add(new URL(request.url()).origin);
  });
  const editor = await Editor.open(page);
  await editor.button('Open recent work').click();
  await bring(editor, 'drop', png('disc.png', disc(64)));
  await expect(editor.status).toContainText('64 × 64 px');
  expect([...origins]).toEqual([baseURL]);
});
