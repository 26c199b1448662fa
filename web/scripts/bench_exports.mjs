/**
 * The exports of `npm run bench`: the element exports a picture of 12 megapixels in each format, in Chromium.
 *
 * Times are compared with the time for drawing only, in the same run. Drawing and compressing run side by side, in two
 * workers.
 */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { withServedEditor } from './served_editor.mjs';
import { ROOT } from './steps.mjs';

/** Guideline for two cores of a cloud machine. */
const MOST_SECONDS = 4;

/** @returns {Promise<string>} A table in Markdown. */
export async function exportTable() {
  return withServedEditor(async (browser, address) => {
    const page = await browser.newPage();
    await page.goto(address);
    await page.locator('c2-warp .solved', { hasText: 'mesh point' }).waitFor({ timeout: 120_000 });
    return table(await page.evaluate(readFileSync(join(ROOT, 'tests/bench/exports.js'), 'utf8')));
  });
}

/** @param {{ drawing: number, files: { type: string, seconds: number, bytes: number }[] }} times In seconds. */
function table({ drawing, files }) {
  const rows = files.map(({ type, seconds, bytes }) => {
    const verdict = seconds <= MOST_SECONDS ? 'met' : 'missed';
    const ratio = (seconds / drawing).toFixed(2);
    return `| ${type} | ${seconds.toFixed(2)} | ${ratio} | ${(bytes / 1e6).toFixed(1)} | ≤ ${MOST_SECONDS} s ${verdict} |`;
  });
  return [
    '## Exports of 12 megapixels',
    '',
    `Drawing alone, on a canvas: ${drawing.toFixed(2)} s.`,
    '',
    '| format | s | ÷ drawing | MB | guideline |',
    '|---|---:|---:|---:|---|',
    ...rows,
  ].join('\n');
}
