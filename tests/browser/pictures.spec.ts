/** Opens a corpus of picture files in the editor and with the command, and compares both. */
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { decode } from 'fast-png';
import { builtCommand } from './command';
import { CASES, type Outcome } from './corpus/cases';
import { expect, test } from './fixtures';

/** An opened picture in straight alpha, or the message of a refusal. */
type Result =
  | { readonly size: readonly number[]; readonly pixels: readonly number[]; readonly moves: boolean }
  | string;

/** Decoders of JPEG and lossy WebP round differently. */
const ROUNDING = 3;
/** Lossy WebP and AVIF change colours. */
const LOSS = 12;

const TABLE = readFileSync(fileURLToPath(new URL('../../web/docs/pictures.md', import.meta.url)), 'utf8');

test('the editor and the command open the corpus alike', async ({ page }) => {
  expect(CASES.length).toBeGreaterThanOrEqual(60);
  await page.goto('/harness/');
  const inEditor = await opened(page);
  const byCommand = commandResults();
  const wrong = CASES.flatMap(({ title, editor, command = editor }, i) => {
    const [ours, theirs] = [inEditor[i] ?? '', byCommand[i] ?? ''];
    return [
      ...faults(ours, editor).map((fault) => `${title}, editor: ${fault}`),
      ...faults(theirs, command, false).map((fault) => `${title}, command: ${fault}`),
      ...differences(ours, theirs).map((fault) => `${title}: ${fault}`),
    ];
  });
  expect(wrong).toEqual([]);
});

test('the manual has a row for every oddity of the corpus', () => {
  const rows = new Set(CASES.map(({ oddity }) => oddity));
  expect([...rows].filter((row) => !TABLE.includes(`| ${row} |`))).toEqual([]);
});

function opened(page: Page): Promise<Result[]> {
  return page.evaluate(
    (files) =>
      Promise.all(
        files.map(async (file): Promise<Result> => {
          try {
            const { width, height, rgba, moves } = await harness.openedPicture(
              new Blob([Uint8Array.from(file)]),
            );
            return { size: [width, height], pixels: [...rgba], moves };
          } catch (error) {
            return (error as Error).message;
          }
        }),
      ),
    CASES.map(({ file }) => file),
  );
}

function commandResults(): Result[] {
  const command = builtCommand();
  const folder = mkdtempSync(join(tmpdir(), 'c2warp-corpus-'));
  try {
    return CASES.map(({ file, editor }) => {
      writeFileSync(join(folder, 'picture'), Uint8Array.from(file));
      const [width, height] = 'size' in editor ? editor.size : [3, 2];
      const image = { src: 'picture', width, height };
      const project = { format: 'c2warp/1', image, domain: { kind: 'image' }, handles: [] };
      writeFileSync(join(folder, 'project.json'), JSON.stringify(project));
      const args = ['warp', 'project.json', '-o', 'out.png'];
      const { status, stderr } = spawnSync(command, args, { cwd: folder, encoding: 'utf8' });
      if (status !== 0) return stderr;
      const { width: columns, height: rows, data } = decode(readFileSync(join(folder, 'out.png')));
      return { size: [columns, rows], pixels: [...data], moves: false };
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The ways in which a result is not the expected one. */
function faults(result: Result, expected: Outcome, movesToo = true): string[] {
  if (typeof result === 'string') {
    return expected instanceof RegExp && expected.test(result) ? [] : [`was refused: ${result}`];
  }
  if (expected instanceof RegExp) return ['was opened'];
  const first = result.pixels.slice(0, 4);
  return [
    ...(String(result.size) === String(expected.size) ? [] : [`has the size ${result.size}`]),
    ...(first.every((value, i) => isClose(value, expected.first[i], LOSS)) ? [] : [`begins with ${first}`]),
    ...(!movesToo || result.moves === (expected.moves ?? false) ? [] : ['is wrong about the animation']),
  ];
}

/** The first pixel in which two opened pictures differ. Colours of transparent pixels do not count. */
function differences(a: Result, b: Result): string[] {
  if (typeof a === 'string' || typeof b === 'string' || a.pixels.length !== b.pixels.length) return [];
  for (let at = 0; at < a.pixels.length; at += 4) {
    const [one, other] = [a.pixels.slice(at, at + 4), b.pixels.slice(at, at + 4)];
    const bothClear = one[3] === 0 && other[3] === 0;
    if (!bothClear && !one.every((value, i) => isClose(value, other[i], ROUNDING)))
      return [`pixel ${at / 4} is ${one} in the editor and ${other} by the command`];
  }
  return [];
}

const isClose = (a: number, b: number | undefined, tolerance: number): boolean =>
  b !== undefined && Math.abs(a - b) <= tolerance;
