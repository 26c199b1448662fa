import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { writeDeclarations } from './declarations.mjs';
import { blocksOf } from './documents.mjs';
import { ROOT, run, toolPath } from './steps.mjs';

const FOLDER = 'node_modules/.cache/element-types';
const PAGE = `
import type { C2Warp, Project } from './types/element.js';

export function follow(warp: C2Warp): void {
  warp.addEventListener('change', (event) => keep(event.detail.project));
  warp.addEventListener('error', (event) => console.error(event.detail.message));
  warp.addEventListener('pointerdown', (event) => console.log(event.pointerId));
  warp.addHandle({ kind: 'bar', rest: [[10, 20], [30, 40]] });
  // @ts-expect-error A handle of no such kind.
  warp.addHandle({ kind: 'line', rest: [[10, 20], [30, 40]] });
}

function keep(project: Project): void {
  console.log(project.handles.length);
}
`;

const PLAYING_PAGE = `
import type { C2WarpPlayer } from './player/player.js';

export async function wave(player: C2WarpPlayer): Promise<number> {
  player.addEventListener('error', (event) => console.error(event.message));
  player.clip = 'wave';
  await player.play();
  return document.querySelector('c2-warp-player')?.duration ?? player.currentTime;
}
`;

/** The first example of the manual, as a separate page. */
const [EXAMPLE = ''] = blocksOf(readFileSync(join(ROOT, 'web/docs/element.md'), 'utf8'), 'ts');

describe('the declarations of the element and the player', () => {
  it.each([
    ['esnext', 'bundler'],
    ['nodenext', 'nodenext'],
  ])(
    'are found by a page that resolves modules as %s, %s',
    { timeout: 120_000 },
    async (module, resolution) => {
      mkdirSync(join(ROOT, FOLDER), { recursive: true });
      await writeDeclarations(`${FOLDER}/types`, 'element');
      await writeDeclarations(`${FOLDER}/player`, 'player');
      writeFileSync(join(ROOT, FOLDER, 'page.ts'), PAGE);
      writeFileSync(join(ROOT, FOLDER, 'playing.ts'), PLAYING_PAGE);
      writeFileSync(join(ROOT, FOLDER, 'example.ts'), EXAMPLE.replace("'c2warp'", "'./types/element.js'"));
      const { code, output } = await run(process.execPath, [
        toolPath('tsc'),
        ...['--noEmit', '--strict', '--target', 'es2022', '--lib', 'es2022,dom', '--types', ''],
        ...['--module', module, '--moduleResolution', resolution],
        ...[`${FOLDER}/page.ts`, `${FOLDER}/playing.ts`, `${FOLDER}/example.ts`],
      ]);
      expect({ code, output }).toEqual({ code: 0, output: '' });
    },
  );
});
