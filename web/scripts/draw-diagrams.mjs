/**
 * `node web/scripts/draw-diagrams.mjs SCRIPT`: draws the Mermaid diagrams of web/docs as SVG, for the site. Code hosts
 * draw them on their own.
 *
 * SCRIPT is `dist/mermaid.min.js` of the npm package mermaid, version 11. The project does not depend on it, because
 * diagrams change rarely. The site does not build if a drawing is missing.
 */
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchChromium, prepareChromium } from './chromium.mjs';
import { drawingOf, THEMES } from './diagrams.mjs';
import { blocksOf } from './documents.mjs';
import { main, ROOT, StepError } from './steps.mjs';

const DOCS = join(ROOT, 'web/docs');

await main(async () => {
  const [script] = process.argv.slice(2);
  if (!script) throw new StepError('Usage: node web/scripts/draw-diagrams.mjs PATH/mermaid.min.js');
  await prepareChromium();
  const browser = await launchChromium();
  const page = await browser.newPage();
  const folder = join(drawingOf('', 'light'), '..');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  for (const name of readdirSync(DOCS)) {
    for (const source of blocksOf(readFileSync(join(DOCS, name), 'utf8'), 'mermaid')) {
      for (const theme of THEMES) {
        await page.goto('about:blank');
        await page.addScriptTag({ path: script });
        const file = drawingOf(source, theme);
        writeFileSync(
          file,
          await page.evaluate(draw, { source, theme: theme === 'dark' ? 'dark' : 'neutral' }),
        );
        console.log(file);
      }
    }
  }
  await browser.close();
});

/**
 * Runs in the page.
 * @param {{ source: string, theme: string }} diagram
 * @returns {Promise<string>}
 */
async function draw({ source, theme }) {
  const { mermaid } = /** @type {any} */ (globalThis);
  mermaid.initialize({ startOnLoad: false, theme, fontFamily: 'system-ui, sans-serif' });
  const { svg } = await mermaid.render('diagram', source);
  const holder = document.createElement('div');
  holder.innerHTML = svg;
  const drawing = /** @type {SVGSVGElement} */ (holder.firstElementChild);
  const { width, height } = drawing.viewBox.baseVal;
  drawing.setAttribute('width', String(Math.ceil(width)));
  drawing.setAttribute('height', String(Math.ceil(height)));
  // Mermaid writes 15 digits.
  const text = new XMLSerializer().serializeToString(drawing);
  return `${text.replaceAll(/\d+\.\d{3,}/g, (number) => String(Number(Number(number).toFixed(1))))}\n`;
}
