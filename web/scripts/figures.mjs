/**
 * Draws every sample at rest and posed, side by side. `web/screenshots/poses.json` lists the positions of handles; the
 * command `c2warp` warps the pictures.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT, step } from './steps.mjs';

const SAMPLES = join(ROOT, 'web/public/samples');
const FOLDER = join(ROOT, 'web/screenshots');

/** @typedef {{ handles: { id: string, rest: unknown, posed: unknown }[] }} Project The part of a project to change. */

const STYLE = `
  body { margin: 0; padding: 24px; width: 1552px; background: #f6f5f1; font: 15px system-ui, sans-serif; color: #444 }
  main { display: grid; grid-template-columns: repeat(4, 1fr); gap: 24px }
  figure { margin: 0; padding: 16px; display: grid; grid-template-columns: 1fr 1fr; gap: 8px; background: #fff;
    border-radius: 12px }
  img { width: 100%; height: 240px; object-fit: contain }
  figcaption { grid-column: 1 / 3; text-align: center }`;

/**
 * Writes `web/screenshots/figures.jpg`.
 * @param {import('@playwright/test').Browser} browser
 */
export async function drawFigures(browser) {
  const poses = JSON.parse(readFileSync(join(FOLDER, 'poses.json'), 'utf8'));
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-figures-'));
  try {
    const figures = [];
    for (const [name, posed] of Object.entries(poses)) {
      const after = join(folder, `${name}.png`);
      await warp(name, posed, folder, after);
      figures.push(`<figure>${picture(join(SAMPLES, `${name}.png`))}${picture(after)}
        <figcaption>${name}</figcaption></figure>`);
    }
    const page = await browser.newPage({ viewport: { width: 1600, height: 720 } });
    await page.setContent(`<style>${STYLE}</style><main>${figures.join('')}</main>`);
    const path = join(FOLDER, 'figures.jpg');
    await page.locator('body').screenshot({ path, type: 'jpeg', quality: 88 });
    console.log(path);
    await page.close();
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * @param {string} name
 * @param {Record<string, unknown>} posed positions of handles; the others stay
 * @param {string} folder
 * @param {string} output
 */
async function warp(name, posed, folder, output) {
  /** @type {Project} */
  const project = JSON.parse(readFileSync(join(SAMPLES, `${name}.c2warp.json`), 'utf8'));
  const handles = project.handles.map((handle) => ({ ...handle, posed: posed[handle.id] ?? handle.rest }));
  const file = join(folder, `${name}.c2warp.json`);
  writeFileSync(file, JSON.stringify({ ...project, handles }));
  const files = [file, '--image', join(SAMPLES, `${name}.png`), '-o', output];
  const command = [
    'run',
    '--quiet',
    '--release',
    '--package',
    'c2warp-cli',
    '--',
    'warp',
    '--grow',
    ...files,
  ];
  await step(`Pose of ${name}`, 'cargo', command, `The ${name} was not warped. The reason is above.`);
}

/** @param {string} path */
const picture = (path) =>
  `<img alt="" src="data:image/png;base64,${readFileSync(path).toString('base64')}" />`;
