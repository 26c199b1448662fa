/**
 * Random sequences of edits: saved projects open as they were, and native code and WebAssembly solve and pose them
 * equally, bit for bit. These tests need no page.
 */
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { initSync } from '../../web/src/compute/generated/c2warp';
import { SOLVER } from '../../web/src/compute/loading';
import { checkedProject } from '../../web/src/compute/module';
import { createWarper } from '../../web/src/core_node';
import { fileProject } from '../../web/src/document/document';
import type { Project } from '../../web/src/document/project';
import { projectText } from '../../web/src/document/project_text';
import { testPicture } from '../../web/src/editor/fake_runtime';
import { randomOf } from '../../web/src/editor/random';
import { editedAtRandom, settle } from '../../web/src/editor/random_edits';
import { documentOf } from '../../web/src/editor/state';
import { builtSolutions } from './command';
import { expect, test } from './fixtures';

const SEQUENCES = process.env.LONG_TESTS ? 10_000 : 200;
const SAMPLE_FILES = new URL('../../web/public/samples/', import.meta.url);
/** Columns and rows of the points that are compared. */
const GRID = 6;
/** Cells are found on as few samples as with many, and a solve takes a tenth of the time. */
const SAMPLES = 500;

test('edits at random are solved alike by native code and WebAssembly', async () => {
  test.setTimeout(SEQUENCES * 500 + 600_000);
  const { width, height } = testPicture();
  const lines = Array.from({ length: SEQUENCES }, (_, seed) => {
    const { fill, ...project } = edited(seed);
    return JSON.stringify({ ...project, samples: SAMPLES });
  });
  const native = spawnSync(builtSolutions(), {
    input: lines.join('\n'),
    encoding: 'utf8',
    maxBuffer: 1 << 30,
  });
  expect(`${native.stderr}${native.status}`).toBe('0');
  const expected = native.stdout.trimEnd().split('\n');
  expect(expected.length).toBe(SEQUENCES);

  const data = new Uint8ClampedArray(width * height * 4).fill(255);
  const points = Float64Array.from({ length: 2 * GRID * GRID }, (_, at) => {
    const [column, row] = [((at >> 1) % GRID) + 0.5, Math.floor(at / 2 / GRID) + 0.5];
    return at % 2 === 0 ? (column / GRID) * width : (row / GRID) * height;
  });
  using warper = await createWarper({ width, height, data });
  for (const [seed, line] of lines.entries()) {
    const told = await warper.solve(line).then(
      async (solution) => {
        const { posed } = await solution.pose().map(points);
        return [solution.report.weights_hash, ...bits(posed)].join(' ');
      },
      (error: { code: string }) => error.code,
    );
    expect(told, `seed ${seed}: ${line}`).toBe(expected[seed]);
  }
});

test('edits at random are saved and opened as they were', () => {
  test.setTimeout(SEQUENCES * 100 + 60_000);
  initSync({ module: readFileSync(SOLVER) });
  for (let seed = 0; seed < SEQUENCES; seed++) {
    const project = edited(seed);
    for (const written of [project, rearranged(project, seed)])
      expect(opened(written), `seed ${seed}`).toBe(JSON.stringify(written));
  }
});

test('the samples are saved and opened as they were', () => {
  initSync({ module: readFileSync(SOLVER) });
  const names = readdirSync(SAMPLE_FILES).filter((name) => name.endsWith('.c2warp.json'));
  expect(names.length).toBeGreaterThan(5);
  for (const name of names) {
    const project = JSON.parse(readFileSync(new URL(name, SAMPLE_FILES), 'utf8'));
    expect(opened(project), name).toBe(JSON.stringify(project));
  }
});

/** A project after it was saved and opened: its keys and their order. */
const opened = (project: Project): string => JSON.stringify(checkedProject(projectText(project)));

/** Keys that files may leave out, of projects and of handles. */
const OPTIONAL = ['samples', 'weighting', 'pose', 'fix_boundary', 'edges', 'loose_parts'];
const OPTIONAL_OF_HANDLES = ['rotation', 'scale', 'depth', 'stiffness'];

/** The project as another program may write it: some keys are left out, and others have another order. */
function rearranged(project: Project, seed: number): Project {
  const random = randomOf(seed);
  const keys = <T extends object>(value: T, optional: readonly string[]): T => {
    const kept = Object.entries(value).filter(([key]) => !optional.includes(key) || random() < 0.5);
    const ranked = kept.map((entry) => ({ entry, rank: random() })).sort((a, b) => a.rank - b.rank);
    return Object.fromEntries(ranked.map(({ entry }) => entry)) as T;
  };
  const handles = project.handles.map((handle) => keys(handle, OPTIONAL_OF_HANDLES));
  return keys({ ...project, handles }, OPTIONAL);
}

/** The project after a random sequence of edits. */
function edited(seed: number): Project {
  const runtime = editedAtRandom(seed);
  settle(runtime);
  return fileProject(documentOf(runtime.state));
}

/** The bits of numbers in hexadecimal, NaN in one form. */
function bits(numbers: Float64Array): string[] {
  const view = new DataView(new ArrayBuffer(8));
  return Array.from(numbers, (value) => {
    view.setFloat64(0, value);
    return view.getBigUint64(0).toString(16).padStart(16, '0');
  });
}
