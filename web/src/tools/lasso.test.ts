import { beforeEach, describe, expect, it } from 'vitest';
import { newProject, openDocument } from '../document/document';
import type { Vec } from '../geometry/vec';
import { TestTools } from './fixtures';
import type { Effect, Press, ToolContext } from './state';

const scene: ToolContext = {
  document: openDocument(newProject({ src: 'a.jpg', width: 400, height: 400 }, null)),
  grips: { handle: 10, line: 6, ring: 30, band: 5, slop: 3, view: { min: [-1e3, -1e3], max: [1e3, 1e3] } },
  posesOnly: false,
  brush: { radius: 10, strength: 1, erases: false },
  snap: (at) => ({ at, guides: [] }),
  turns: new Map(),
  place: () => null,
  layerUnder: (corners) => corners.map((rest) => ({ rest, rotation: 0, scale: 1 })),
};
const press = (at: Vec, keys: Partial<Press> = {}): Press => ({
  at,
  stage: at,
  shift: false,
  alt: false,
  free: false,
  ...keys,
});

describe('the lasso', () => {
  let machine: TestTools;
  let effects: readonly Effect[];
  const lassoed = () => effects.find((effect) => effect.type === 'lassoed');
  const act = (done: readonly Effect[]) => {
    effects = done;
  };
  const click = (at: Vec) => {
    machine.down(press(at), scene);
    act(machine.up(press(at), scene));
  };
  const drag = (path: readonly Vec[], keys: Partial<Press> = {}) => {
    const [first = [0, 0]] = path;
    machine.down(press(first, keys), scene);
    for (const at of path.slice(1)) machine.move(press(at, keys), scene);
    act(machine.up(press(path.at(-1) ?? first, keys), scene));
  };

  beforeEach(() => {
    machine = new TestTools();
    machine.choose('lasso');
    effects = [];
  });

  it('follows a drag, with corners some way apart, and closes at its end', () => {
    drag([
      [10, 10],
      [12, 10],
      [50, 10],
      [52, 11],
      [50, 60],
      [10, 60],
    ]);
    expect(lassoed()).toEqual({
      type: 'lassoed',
      ring: [
        [10, 10],
        [50, 10],
        [50, 60],
        [10, 60],
      ],
      hole: false,
    });
    expect(machine.draft).toBeNull();
  });
  it('takes corners by clicks, and closes at the first', () => {
    for (const at of [
      [10, 10],
      [90, 10],
      [50, 80],
    ] as const)
      click(at);
    expect(machine.draft?.corners).toHaveLength(3);
    click([12, 11]);
    expect(lassoed()).toMatchObject({
      ring: [
        [10, 10],
        [90, 10],
        [50, 80],
      ],
    });
  });
  it('is finished by Enter, goes on drawing after a click, and takes corners back', () => {
    click([10, 10]);
    drag([
      [90, 10],
      [100, 50],
      [90, 90],
    ]);
    expect(machine.draft?.corners).toHaveLength(4);
    machine.back();
    act(machine.finish(scene));
    expect(lassoed()).toMatchObject({
      ring: [
        [10, 10],
        [90, 10],
        [100, 50],
      ],
    });
  });
  it('cuts a hole with Alt at its beginning', () => {
    drag(
      [
        [10, 10],
        [50, 10],
        [50, 60],
      ],
      { alt: true },
    );
    expect(lassoed()).toMatchObject({ hole: true });
  });
  it('is no lasso yet after a drag in a line of two corners', () => {
    drag([
      [10, 10],
      [50, 10],
    ]);
    expect(lassoed()).toBeUndefined();
    expect(machine.draft?.corners).toHaveLength(2);
  });
  it('goes without a trace where its press is cancelled', () => {
    machine.down(press([10, 10]), scene);
    machine.move(press([50, 10]), scene);
    machine.cancel();
    expect(machine.draft).toBeNull();
  });
});
