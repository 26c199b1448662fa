import { beforeEach, describe, expect, it } from 'vitest';
import { type Document, newProject, openDocument } from '../document/document';
import { TestHistory } from '../document/fixtures';
import type { Project } from '../document/project';
import { cellsForStrokes } from '../document/stiffness';
import type { Vec } from '../geometry/vec';
import { TestTools } from './fixtures';
import type { Effect, Press, ToolContext } from './state';

const project = newProject({ src: 'a.png', width: 400, height: 400 }, null);
const press = (at: Vec, alt = false): Press => ({ at, stage: at, shift: false, alt, free: false });

/** Carries the effects of the brush out on a history, as the editor does. */
class Bench {
  readonly machine = new TestTools();
  readonly history = new TestHistory(openDocument(project));
  /** The place of the original under a place of the posed picture. */
  under = (at: Vec): Vec => at;
  erases = false;

  constructor() {
    this.machine.choose('brush');
  }

  drag(path: readonly Vec[], alt = false) {
    const [first = [0, 0]] = path;
    this.#apply(this.machine.down(press(first, alt), this.#context));
    for (const at of path.slice(1)) this.#apply(this.machine.move(press(at, alt), this.#context));
    this.#apply(this.machine.up(press(path.at(-1) ?? first, alt), this.#context));
  }

  cancel(at: Vec) {
    this.#apply(this.machine.down(press(at), this.#context));
    this.#apply(this.machine.cancel());
  }

  stiffness([x, y]: Vec): number {
    const { width, height, values } = cellsForStrokes(this.history.present.project);
    return (values[Math.floor((y * height) / 400) * width + Math.floor((x * width) / 400)] ?? 0) / 255;
  }

  get #context(): ToolContext {
    return {
      document: this.history.present,
      grips: {
        handle: 10,
        line: 6,
        ring: 30,
        band: 5,
        slop: 3,
        view: { min: [-1e3, -1e3], max: [1e3, 1e3] },
      },
      posesOnly: false,
      brush: { kind: 'stiffen', radius: 30, strength: 1, erases: this.erases },
      guards: false,
      heldOutline: () => null,
      trace: null,
      snap: (at) => ({ at, guides: [] }),
      turns: new Map(),
      place: () => null,
      layerUnder: (corners) => corners.map((at) => ({ rest: this.under(at), rotation: 0, scale: 1 })),
    };
  }

  #apply(effects: readonly Effect[]) {
    for (const effect of effects) {
      if (effect.type === 'begin') this.history.begin(effect.label);
      else if (effect.type === 'edit') this.history.update(effect.document as Document);
      else if (effect.type === 'commit') this.history.commit();
      else if (effect.type === 'bail') this.history.bail();
    }
  }
}

describe('the brush', () => {
  let bench: Bench;
  const projectNow = (): Project => bench.history.present.project;
  beforeEach(() => {
    bench = new Bench();
  });

  it('paints along a drag, as one undo step', () => {
    bench.drag([
      [100, 200],
      [200, 200],
      [300, 200],
    ]);
    expect([100, 150, 300].map((x) => bench.stiffness([x, 200]))).toEqual([1, 1, 1]);
    expect(bench.stiffness([200, 300])).toBe(0);
    expect(bench.history.undoLabel).toBe('Paint stiffness');
    bench.history.undo();
    expect(projectNow()).toEqual(project);
  });

  it('paints with a single press, and keeps nothing of a cancelled one', () => {
    bench.cancel([200, 200]);
    expect(projectNow()).toEqual(project);
    bench.drag([[200, 200]]);
    expect(bench.stiffness([200, 200])).toBe(1);
  });

  it('erases with Alt, and paints with Alt while it erases', () => {
    bench.drag([[200, 200]]);
    bench.drag([[200, 200]], true);
    expect(bench.history.undoLabel).toBe('Erase stiffness');
    expect(bench.stiffness([200, 200])).toBe(0);
    bench.erases = true;
    bench.drag([[200, 200]], true);
    expect(bench.stiffness([200, 200])).toBe(1);
    bench.drag([[200, 200]]);
    expect(bench.stiffness([200, 200])).toBe(0);
  });

  it('paints the place of the original under the pointer', () => {
    bench.under = ([x, y]) => [y, x];
    bench.drag([[300, 100]]);
    expect([bench.stiffness([100, 300]), bench.stiffness([300, 100])]).toEqual([1, 0]);
  });

  it('paints no line between two parts of the original that touch in the pose', () => {
    bench.under = ([x, y]) => (x < 200 ? [x, y] : [x + 150, y]);
    bench.drag([
      [190, 200],
      [210, 200],
    ]);
    expect([190, 280, 360].map((x) => bench.stiffness([x, 200]))).toEqual([1, 0, 1]);
  });
});
