/**
 * `node web/scripts/draw-samples.mjs`: draws every SVG in `web/public/samples` as a PNG of the same name.
 *
 * Chromium draws it at its own size and with its alpha. Run the script after you edit an SVG.
 */
import { readdir, readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { findChromium, launchChromium } from './chromium.mjs';

const samples = fileURLToPath(new URL('../public/samples/', import.meta.url));
if (findChromium() === undefined) throw new Error('No Chromium found: install one, or name it in CHROMIUM.');
const browser = await launchChromium(['--force-color-profile=srgb']);
try {
  for (const name of (await readdir(samples)).filter((file) => file.endsWith('.svg'))) {
    const svg = await readFile(samples + name, 'utf8');
    const [, width, height] = svg.match(/viewBox="0 0 (\d+) (\d+)"/) ?? [];
    if (!width || !height) throw new Error(`${name}: expected viewBox="0 0 WIDTH HEIGHT"`);
    const page = await browser.newPage({ viewport: { width: Number(width), height: Number(height) } });
    await page.setContent(`<style>body{margin:0}svg{display:block}</style>${svg}`);
    await page.screenshot({ path: samples + name.replace(/\.svg$/, '.png'), omitBackground: true });
    await page.close();
    console.log(`${name} → ${width} × ${height}`);
  }
} finally {
  await browser.close();
}
