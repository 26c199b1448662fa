/**
 * `node web/scripts/draw-icons.mjs`: draws `web/public/favicon.svg` as the icons of the installed editor.
 *
 * Run the script after you edit the SVG. `web/public/manifest.webmanifest` and `web/index.html` name the icons.
 */
import { mkdir, readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { findChromium, launchChromium } from './chromium.mjs';

const GROUND = '#f5f5f3';

/**
 * Systems cut maskable icons. A circle of 80 % of the width stays, and the drawing fits into it. iOS makes transparent
 * pixels black, and rounds the corners.
 */
const ICONS = [
  { name: '192.png', size: 192, part: 1, ground: 'none' },
  { name: '512.png', size: 512, part: 1, ground: 'none' },
  { name: 'maskable.png', size: 512, part: 0.66, ground: GROUND },
  { name: 'apple-touch.png', size: 180, part: 0.72, ground: GROUND },
];

const folder = fileURLToPath(new URL('../public/', import.meta.url));
if (findChromium() === undefined) throw new Error('No Chromium found: install one, or name it in CHROMIUM.');
const svg = await readFile(`${folder}favicon.svg`, 'utf8');
await mkdir(`${folder}icons`, { recursive: true });
const browser = await launchChromium(['--force-color-profile=srgb']);
try {
  for (const { name, size, part, ground } of ICONS) {
    const page = await browser.newPage({ viewport: { width: size, height: size } });
    const style = `body{margin:0;height:100vh;display:grid;place-items:center;background:${ground}}svg{width:${100 * part}vw}`;
    await page.setContent(`<style>${style}</style>${svg}`);
    await page.screenshot({ path: `${folder}icons/${name}`, omitBackground: true });
    await page.close();
    console.log(`${name}: ${size} × ${size}`);
  }
} finally {
  await browser.close();
}
