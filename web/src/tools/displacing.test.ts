import { beforeEach, describe, expect, it } from 'vitest';
import { displacementAt, fieldForStrokes } from '../document/displacement';
import { isSameWork, newProject, openDocument } from '../document/document';
import { TestHistory } from '../document/fixtures';
import type { Project } from '../document/project';
import { distance, type Vec } from '../geometry/vec';
import type { ToolBrush } from './brush_kinds';
import { TestTools } from './fixtures';
import type { Effect, Press, ToolContext } from './state';

const resting = newProject({ src: 'a.png', width: 400, height: 400 }, null);
const press = (at: Vec, alt = false): Press => ({ at, stage: at, shift: false, alt, free: false });

/** Carries the effects of the brush out on a history, as the editor does. */
class Bench {
  readonly machine = new TestTools();
  readonly history = new TestHistory(openDocument(resting), isSameWork);
  /** The place of the original, after strokes, under a place of the posed picture. */
  under = (at: Vec): Vec => at;
  placed = true;
  brush: ToolBrush = { kind: 'push', radius: 40, strength: 1, erases: false };
  readonly missed: Vec[] = [];

  constructor() {
    this.machine.choose('brush');
  }

  down = (at: Vec, alt = false) => this.#apply(this.machine.down(press(at, alt), this.#context));
  move = (at: Vec) => this.#apply(this.machine.move(press(at), this.#context));
  up = (at: Vec) => this.#apply(this.machine.up(press(at), this.#context));
  cancel = () => this.#apply(this.machine.cancel());
  bail = () => this.#apply(this.machine.bail());

  drag(path: readonly Vec[], alt = false) {
    const [first = [0, 0], ...others] = path;
    this.down(first, alt);
    for (const at of others) this.move(at);
    this.up(path.at(-1) ?? first);
  }

  get project(): Project {
    return this.history.present.project;
  }

  at = (place: Vec): Vec => displacementAt(fieldForStrokes(this.project), place);

  get #context(): ToolContext {
    return {
      document: this.history.present,
      grips: { handle: 10, line: 6, ring: 30, band: 5, slop: 3, view: { min: [0, 0], max: [400, 400] } },
      posesOnly: false,
      brush: this.brush,
      guards: false,
      heldOutline: () => null,
      trace: null,
      snap: (at) => ({ at, guides: [] }),
      turns: new Map(),
      place: (at) => (this.placed ? { posed: at, rest: at, rotation: 0, scale: 1 } : null),
      layerUnder: (corners) => corners.map((at) => ({ rest: this.#rest(at), rotation: 0, scale: 1 })),
    };
  }

  /** The position at rest that the strokes so far have moved to the place under the pointer. */
  #rest(at: Vec): Vec {
    const moved = this.under(at);
    let rest = moved;
    for (let k = 0; k < 50; k++) {
      const by = this.at(rest);
      rest = [moved[0] - by[0], moved[1] - by[1]];
    }
    return rest;
  }

  #apply(effects: readonly Effect[]) {
    for (const effect of effects) {
      if (effect.type === 'begin') this.history.begin(effect.label);
      else if (effect.type === 'edit') this.history.update(effect.document);
      else if (effect.type === 'commit') this.history.commit();
      else if (effect.type === 'bail') this.history.bail();
      else if (effect.type === 'miss') this.missed.push(effect.at);
    }
  }
}

describe('the brush that moves the picture', () => {
  let bench: Bench;
  beforeEach(() => {
    bench = new Bench();
  });

  it('begins a push where it is pressed, and moves nothing yet', () => {
    bench.down([200, 200]);
    expect(bench.machine.busy).toBe(true);
    expect(bench.project).toEqual(resting);
    bench.up([200, 200]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('takes the place under the pointer along, as one undo step', () => {
    bench.drag([
      [200, 200],
      [205, 200],
      [210, 204],
    ]);
    const [x, y] = bench.at([200, 200]);
    expect(distance([x, y], [10, 4])).toBeLessThan(1.5);
    expect(bench.at([200, 260])).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBe('Push');
    bench.history.undo();
    expect(bench.project).toEqual(resting);
  });

  it('acts on a single press unless it pushes, and does the opposite with Alt', () => {
    bench.brush = { ...bench.brush, kind: 'bloat' };
    bench.drag([[200, 200]]);
    expect(bench.history.undoLabel).toBe('Bloat');
    expect(bench.at([212, 200])[0]).toBeGreaterThan(0.5);
    bench.history.undo();
    bench.drag([[200, 200]], true);
    expect(bench.history.undoLabel).toBe('Pinch');
    expect(bench.at([212, 200])[0]).toBeLessThan(-0.5);
  });

  it('pushes nothing across a jump to another part, and continues there', () => {
    bench.under = ([x, y]) => (x < 200 ? [x, y] : [x + 100, y]);
    bench.drag([
      [190, 200],
      [196, 200],
      [202, 200],
      [208, 200],
    ]);
    expect(bench.at([190, 200])[0]).toBeGreaterThan(4);
    expect(bench.at([190, 200])[0]).toBeLessThan(7);
    expect(bench.at([250, 200])).toEqual([0, 0]);
    expect(bench.at([302, 200])[0]).toBeGreaterThan(4);
    expect(bench.at([302, 200])[0]).toBeLessThan(7);
  });

  it('bloats no place between two parts that touch in the pose', () => {
    bench.brush = { ...bench.brush, kind: 'bloat', radius: 20 };
    bench.under = ([x, y]) => (x < 200 ? [x, y] : [x + 100, y]);
    bench.drag([
      [190, 200],
      [210, 200],
    ]);
    expect(bench.at([250, 207])).toEqual([0, 0]);
    expect(bench.at([190, 207])[1]).toBeGreaterThan(0.2);
    expect(bench.at([310, 207])[1]).toBeGreaterThan(0.2);
  });

  it('leaves nothing of a cancelled stroke, nor of one that Escape ends', () => {
    for (const end of [bench.cancel, bench.bail]) {
      bench.down([200, 200]);
      bench.move([220, 200]);
      expect(bench.project).not.toEqual(resting);
      end();
      expect(bench.project).toEqual(resting);
      expect(bench.history.undoLabel).toBeNull();
      expect(bench.machine.busy).toBe(false);
      bench.move([240, 200]);
      expect(bench.project).toEqual(resting);
    }
  });

  it('misses where nothing under it bends', () => {
    bench.placed = false;
    bench.drag([
      [390, 200],
      [300, 200],
    ]);
    expect(bench.missed).toEqual([[390, 200]]);
    expect(bench.project).toEqual(resting);
    expect(bench.history.undoLabel).toBeNull();
  });
});
