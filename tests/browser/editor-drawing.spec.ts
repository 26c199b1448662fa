/** Drawings: an SVG is opened, bent, exported as SVG like the command does, and is still a drawing after a reload. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { builtCommand } from './command';
import { bytes, Editor } from './editor';
import { expect, test } from './fixtures';

const DRAWING = readFileSync(fileURLToPath(new URL('../drawings/features.svg', import.meta.url)), 'utf8')
  .replace('</svg>', '<script>parent.stopped = true</script><text x="9" y="9">A title</text></svg>')
  .replace('width="240" height="240">', '>');

const handle = (id: string, rest: readonly number[], posed: readonly number[]) => ({
  id,
  kind: 'point',
  rest,
  posed,
});
const PROJECT = {
  format: 'c2warp/1',
  image: { src: 'house.svg', width: 1024, height: 1024 },
  domain: { kind: 'image' },
  samples: 2000,
  handles: [
    handle('a', [150, 150], [230, 120]),
    handle('b', [850, 200], [800, 330]),
    handle('c', [512, 850], [500, 800]),
  ],
};

/** The numbers of all paths, in their order. */
const numbers = (svg: string): number[] =>
  [...svg.matchAll(/ d="([^"]*)"/g)].flatMap(([, data = '']) => data.match(/-?[\d.]+/g) ?? []).map(Number);

let binary: string;

test.beforeAll(() => {
  binary = builtCommand();
});

function byCommand(): string {
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-drawing-'));
  try {
    writeFileSync(join(folder, 'house.svg'), DRAWING.replace(/<text.*<\/text>/, ''));
    writeFileSync(join(folder, 'project.json'), JSON.stringify(PROJECT));
    const args = ['warp', 'project.json', '-o', 'bent.svg'];
    const { status, stderr } = spawnSync(binary, args, { cwd: folder, encoding: 'utf8' });
    expect(status, stderr).toBe(0);
    return readFileSync(join(folder, 'bent.svg'), 'utf8');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function exportedSvg(editor: Editor, name: string): Promise<string> {
  const { page } = editor;
  const panel = page.getByRole('dialog', { name: 'Export' });
  await editor.button('Export as …').click();
  await panel.getByRole('button', { name: 'SVG', exact: true }).click();
  const started = page.waitForEvent('download');
  await panel.getByRole('button', { name: 'Export SVG' }).click();
  const download = await started;
  expect(download.suggestedFilename()).toBe(name);
  return (await bytes(download)).toString();
}

const svgFile = (name: string, content: string | Buffer) => ({
  name,
  mimeType: 'image/svg+xml',
  buffer: typeof content === 'string' ? Buffer.from(content) : content,
});

/** Opens the test project for the picture with this name. */
async function withHandles(editor: Editor, name: string): Promise<void> {
  const project = JSON.stringify({ ...PROJECT, image: { ...PROJECT.image, src: name } });
  await editor.chooseFile({
    name: 'p.c2warp.json',
    mimeType: 'application/json',
    buffer: Buffer.from(project),
  });
  await expect(editor.handles).toHaveCount(3);
}

const drawingOf = (content: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 90">${content}</svg>`;

test('a drawing is exported as SVG, as the command bends it, also after a reload', async ({ page }) => {
  const editor = await Editor.open(page);
  await editor.chooseFile({ name: 'house.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(DRAWING) });
  await expect(editor.status).toContainText('1024 × 1024 px');
  await expect(page.getByText('not opened')).toBeHidden();
  const project = Buffer.from(JSON.stringify(PROJECT));
  await editor.chooseFile({ name: 'house.c2warp.json', mimeType: 'application/json', buffer: project });
  await expect(editor.handles).toHaveCount(3);
  await expect(editor.solved).toContainText('2,024 mesh points');
  expect(await page.evaluate(() => 'stopped' in window)).toBe(false);

  const exported = () => exportedSvg(editor, 'house-warped.svg');
  const svg = await exported();
  await expect(page.getByText(/Saved as house-warped\.svg.*Scripts are left out\..*A title/)).toBeVisible();
  const [ours, theirs] = [numbers(svg), numbers(byCommand())];
  expect(ours.length).toBe(theirs.length);
  expect(Math.max(...ours.map((value, at) => Math.abs(value - (theirs[at] ?? Number.NaN))))).toBeLessThan(
    0.05,
  );

  await expect
    .poll(() => editor.storedWork())
    .toMatchObject({ picture: 'house.svg', handles: PROJECT.handles });
  await page.reload();
  await expect(editor.status).toContainText('1024 × 1024 px');
  await expect(editor.solved).toContainText('2,024 mesh points');
  expect(await exported()).toBe(svg);
});

test('a drawing that is damaged or has no size is refused', async ({ page }) => {
  const editor = await Editor.open(page);
  for (const [text, told] of [
    ['<svg xmlns="http://www.w3.org/2000/svg"/>', 'The drawing has no size'],
    ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><g></svg>', 'The drawing is damaged'],
  ] as const) {
    await editor.chooseFile({ name: 'bad.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(text) });
    await expect(editor.notice).toContainText(`bad.svg: ${told}`);
  }
});

test('an export reports left-out styles of a drawing', async ({ page }) => {
  const editor = await Editor.open(page);
  const path = '<path d="M0 0h60v60H0z" class="a" vector-effect="non-scaling-stroke"/>';
  const style =
    '<style>:root{--a:rgb(20 90 200 / 80%)}.a{fill:var(--a);stroke:light-dark(red, blue)}</style>';
  await editor.chooseFile(svgFile('lossy.svg', drawingOf(style + path)));
  await expect(editor.status).toContainText('1024 × 1024 px');
  await withHandles(editor, 'lossy.svg');
  const svg = await exportedSvg(editor, 'lossy-warped.svg');
  await expect(page.getByText(/The property vector-effect is not supported/)).toBeVisible();
  await expect(page.getByText(/Stroke: the value “light-dark\(red, blue\)” is left out/)).toBeVisible();
  expect(svg).toMatch(/fill="#145ac8"/);
  expect(svg).not.toMatch(/#000000|="black"/);
});

test('an encoded or compressed drawing keeps its names', async ({ page }) => {
  const editor = await Editor.open(page);
  const named = drawingOf('<g id="Größe"><path d="M0 0h60v60H0z"/></g>');
  const latin = Buffer.from(`<?xml version="1.0" encoding="ISO-8859-1"?>${named}`, 'latin1');
  for (const [name, content] of [
    ['latin.svg', latin],
    ['wide.svg', Buffer.from(`\ufeff${named}`, 'utf16le')],
    ['packed.svgz', gzipSync(latin)],
  ] as const) {
    await editor.chooseFile(svgFile(name, content));
    await expect(page).toHaveTitle(`${name} – c2warp`);
    await withHandles(editor, name);
    expect(await exportedSvg(editor, name.replace(/\..*/, '-warped.svg'))).toContain('id="Größe"');
  }
  for (const [name, content, told] of [
    ['words.gz', gzipSync('once upon a time'), 'This is a compressed file.'],
    ['bomb.svgz', gzipSync(`<svg${' '.repeat(65 << 20)}`), 'The drawing is larger than 64 MB.'],
    ['wrong.svg', Buffer.from(named, 'latin1'), 'The drawing cannot be read as utf-8.'],
  ] as const) {
    await editor.chooseFile(svgFile(name, content));
    await expect(editor.notice).toContainText(`${name}: ${told}`);
  }
});

test('the page does not draw drawings that would block it', async ({ page }) => {
  await page.addInitScript(() => {
    const { decode } = HTMLImageElement.prototype;
    const asked: string[] = [];
    Object.assign(globalThis, { asked });
    HTMLImageElement.prototype.decode = function decodeNoted() {
      asked.push(this.src);
      return decode.call(this);
    };
  });
  const editor = await Editor.open(page);
  const asked = () => page.evaluate(() => (globalThis as unknown as { asked: string[] }).asked.length);
  const before = await asked();
  const doubled = Array.from(
    { length: 12 },
    (_, at) => `<g id="a${at + 1}"><use href="#a${at}"/><use href="#a${at}" x="1"/></g>`,
  );
  const many = `<text y="9">A</text><defs><rect id="a0" width="60" height="60" fill="#c33"/>${doubled.join('')}</defs>`;
  await editor.chooseFile(svgFile('many.svg', drawingOf(`${many}<use href="#a12"/>`)));
  await expect(editor.status).toContainText('1024 × 1024 px');
  await expect(
    page.getByText('many.svg takes long to draw, so it was opened without its texts.'),
  ).toBeVisible();
  const filter = (part: string) =>
    drawingOf(`<filter id="f">${part}</filter><path d="M0 0h90v90H0z" filter="url(#f)"/>`);
  for (const [element, part] of [
    ['feTurbulence', '<feTurbulence numOctaves="1000" baseFrequency=".9"/>'],
    ['feMorphology', '<feMorphology radius="9"/>'],
  ] as const) {
    await editor.chooseFile(svgFile(`${element}.svg`, filter(part)));
    await expect(editor.notice).toContainText(
      `${element}.svg: This drawing takes too long to draw, mostly because of its <${element}>: simplify it.`,
    );
  }
  expect(await asked()).toBe(before);
  // A small drawing is drawn by the browser, with its texts.
  await editor.chooseFile(svgFile('small.svg', drawingOf('<text y="9">A</text>')));
  await expect(page).toHaveTitle('small.svg – c2warp');
  expect(await asked()).toBe(before + 1);
});
