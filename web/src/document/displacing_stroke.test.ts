import { describe, expect, it } from 'vitest';
import type { Vec } from '../geometry/vec';
import { displacementAt, type Field, fieldForStrokes } from './displacement';
import {
  beginDisplacing,
  type DisplacingBrush,
  ledDisplacing,
  type StrokeLimits,
  withDisplacing,
} from './displacing_stroke';
import { newProject } from './document';
import type { Project } from './project';

const resting = newProject({ src: 'a.png', width: 1024, height: 768 }, null);
const FREE: StrokeLimits = { guarded: false, held: null };
const FRAME = [0, 0, 1024, 0, 1024, 0, 1024, 768, 1024, 768, 0, 768, 0, 768, 0, 0];

function stroke(
  project: Project,
  brush: Partial<DisplacingBrush>,
  path: readonly Vec[],
  limits: StrokeLimits = FREE,
): Project {
  let led = beginDisplacing(project, { kind: 'push', radius: 80, strength: 1, ...brush }, limits);
  path.forEach((to, k) => {
    led = ledDisplacing(led, path[k - 1] ?? null, to);
  });
  return withDisplacing(led);
}

const at = (project: Project, place: Vec): Vec => displacementAt(fieldForStrokes(project), place);

/** Places from one to another in so many steps. */
const way = (from: Vec, to: Vec, steps: number): Vec[] =>
  Array.from({ length: steps + 1 }, (_, k) => [
    from[0] + ((to[0] - from[0]) * k) / steps,
    from[1] + ((to[1] - from[1]) * k) / steps,
  ]);

/** The least area that the field brings a unit square to, sampled between control points too. */
function leastArea(field: Field): number {
  let least = 1;
  const step = field.spacing[0] / 2.7;
  for (let y = 0; y + step <= 768; y += step)
    for (let x = 0; x + step <= 1024; x += step) {
      const [a, b, c] = [
        displacementAt(field, [x, y]),
        displacementAt(field, [x + step, y]),
        displacementAt(field, [x, y + step]),
      ];
      const [xx, yx] = [1 + (b[0] - a[0]) / step, (b[1] - a[1]) / step];
      const [xy, yy] = [(c[0] - a[0]) / step, 1 + (c[1] - a[1]) / step];
      least = Math.min(least, xx * yy - xy * yx);
    }
  return least;
}

describe('a stroke that displaces', () => {
  it('pushes the place under its middle along, and nothing beyond its radius', () => {
    const pushed = stroke(resting, {}, way([500, 380], [540, 400], 1));
    const [x, y] = at(pushed, [500, 380]);
    expect(Math.hypot(x - 40, y - 20)).toBeLessThan(2.5);
    expect(at(pushed, [500, 520])).toEqual([0, 0]);
    expect(
      at(stroke(resting, { strength: 0.5 }, way([500, 380], [540, 400], 1)), [500, 380])[0],
    ).toBeLessThan(30);
  });

  it('hardly depends on how often the pointer reports', () => {
    for (const kind of ['push', 'pinch', 'bloat'] as const) {
      const [few, many] = [1, 40].map((steps) =>
        stroke(resting, { kind }, way([400, 300], [600, 400], steps)),
      );
      const most = way([320, 240], [680, 460], 60).map((place) => {
        const [a, b] = [at(few as Project, place), at(many as Project, place)];
        return Math.hypot(a[0] - b[0], a[1] - b[1]);
      });
      expect(Math.max(...most)).toBeLessThan(kind === 'push' ? 9 : 0.1);
    }
  });

  it('pinches and bloats about its middle, which stays', () => {
    const [pinched, bloated] = (['pinch', 'bloat'] as const).map((kind) =>
      stroke(resting, { kind }, [[500, 380]]),
    );
    expect(Math.abs(at(pinched as Project, [500, 380])[0])).toBeLessThan(0.1);
    expect(at(pinched as Project, [525, 380])[0]).toBeLessThan(-1.5);
    expect(at(bloated as Project, [525, 380])[0]).toBeGreaterThan(1.5);
    expect(at(bloated as Project, [475, 380])[0]).toBeLessThan(-1.5);
  });

  it('smooths steep places, and restores down to a project without a displacement', () => {
    let pushed = stroke(resting, { radius: 30 }, way([500, 380], [540, 380], 4));
    const [before] = at(pushed, [500, 380]);
    const smoothed = stroke(pushed, { kind: 'smooth', radius: 120 }, [[540, 380]]);
    expect(at(smoothed, [500, 380])[0]).toBeLessThan(0.9 * before);
    for (let k = 0; k < 60; k++) pushed = stroke(pushed, { kind: 'restore', radius: 300 }, [[520, 380]]);
    expect('displacement' in pushed).toBe(false);
  });

  it('smooths a bump: it takes much of its height, and little of its volume', () => {
    const across = (project: Project): readonly number[] =>
      [...fieldForStrokes(project).values].filter((_, at) => at % 2 === 0);
    const volume = (project: Project) => across(project).reduce((total, value) => total + value, 0);
    const height = (project: Project) => Math.max(...across(project));
    const bump = stroke(resting, { radius: 60 }, way([500, 380], [520, 380], 2));
    const smoothed = stroke(bump, { kind: 'smooth', radius: 250 }, [[510, 380]]);
    expect(height(smoothed)).toBeLessThan(0.6 * height(bump));
    expect(Math.abs(volume(smoothed) / volume(bump) - 1)).toBeLessThan(0.15);
    const again = stroke(smoothed, { kind: 'smooth', radius: 250 }, [[510, 380]]);
    expect(height(again)).toBeLessThan(height(smoothed));
  });

  it('flips no part while guarded, even with strong pushes', { timeout: 60_000 }, () => {
    let [free, guarded] = [resting, resting];
    for (let k = 0; k < 6; k++)
      for (const [from, to] of [
        [
          [300, 380],
          [700, 380],
        ],
        [
          [700, 300],
          [400, 460],
        ],
        [
          [500, 200],
          [520, 600],
        ],
      ] as const) {
        free = stroke(free, { radius: 60 }, way(from, to, 3));
        guarded = stroke(guarded, { radius: 60 }, way(from, to, 3), { guarded: true, held: null });
      }
    for (let k = 0; k < 200; k++)
      guarded = stroke(guarded, { kind: 'bloat', radius: 60 }, [[500, 380]], { guarded: true, held: null });
    expect(leastArea(fieldForStrokes(guarded))).toBeGreaterThan(0);
    expect(leastArea(fieldForStrokes(free))).toBeLessThan(0);
    expect(Math.hypot(...at(guarded, [500, 380]))).toBeGreaterThan(1);
  });

  it('leaves a held outline exactly where it is', () => {
    const held = { guarded: false, held: FRAME };
    const pushed = stroke(resting, { radius: 200 }, way([300, 380], [-100, 380], 8), held);
    for (let y = 0; y <= 768; y += 7) expect(at(pushed, [0, y])).toEqual([0, 0]);
    expect(at(pushed, [150, 380])[0]).toBeLessThan(-20);
    expect(at(stroke(resting, { radius: 200 }, way([300, 380], [-100, 380], 8)), [0, 380])[0]).toBeLessThan(
      -20,
    );
  });
});
