import { beforeEach, describe, expect, it } from 'vitest';
import { withMode } from '../document/bending';
import { handleById, newProject, openDocument } from '../document/document';
import { addHandle, changeHandles, selectHandles } from '../document/edits';
import { TestHistory } from '../document/fixtures';
import { rotationOf, type Turns, withAutoRotation } from '../document/handle';
import type { BarHandle, PointHandle } from '../document/project';
import type { Box } from '../geometry/box';
import { type Guide, type Guides, snappedTo } from '../geometry/guides';
import type { LocatedPoint } from '../geometry/place';
import { add, rotated, type Vec } from '../geometry/vec';
import { TestTools } from './fixtures';
import type { Effect, Press, ToolContext } from './state';

const handle = (id: string, x: number): PointHandle => ({ id, kind: 'point', rest: [x, 0], posed: [x, 0] });
/** Through the grip of both. */
const line = [
  [96, 20],
  [96, 70],
] as const;
const bar: BarHandle = { id: 'arm', kind: 'bar', rest: line, posed: line };
const image = { src: 'a.png', width: 200, height: 200 };

/** An editor without a page: it carries effects out on a history, as the element does. */
class Bench {
  readonly machine = new TestTools();
  readonly history = new TestHistory(
    addHandle(addHandle(openDocument(newProject(image, 0.5)), handle('a', 0)), handle('b', 100)),
  );
  readonly others: Effect[] = [];
  turns: Turns = new Map();
  posesOnly = false;
  /** The guides of the last move. */
  shown: readonly Guide[] = [];
  guides: Guides = { lines: [], grid: Number.POSITIVE_INFINITY };
  placement: LocatedPoint | null = { rest: [7, 8], rotation: 30, scale: 2 };
  view: Box = { min: [-1e3, -1e3], max: [1e3, 1e3] };
  /** Where a handle is led to that is placed beside the picture. */
  led: Vec | null = null;

  constructor() {
    this.history.update(selectHandles(this.history.present, []));
  }

  get selection() {
    return this.history.present.selection;
  }

  posed(id: string) {
    return handleById(this.history.present, id)?.posed;
  }

  rotation(id: string) {
    const found = handleById(this.history.present, id);
    return found && rotationOf(found);
  }

  down = (at: Vec, keys: Partial<Press> = {}) => this.#apply(this.machine.down(press(at, keys), this.#scene));
  move = (at: Vec, keys: Partial<Press> = {}) => this.#apply(this.machine.move(press(at, keys), this.#scene));
  up = (at: Vec, keys: Partial<Press> = {}) => this.#apply(this.machine.up(press(at, keys), this.#scene));
  cancel = () => this.#apply(this.machine.cancel());

  click(at: Vec, keys: Partial<Press> = {}) {
    this.down(at, keys);
    this.up(at, keys);
  }

  drag(from: Vec, to: Vec, keys: Partial<Press> = {}) {
    this.down(from, keys);
    this.move([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], keys);
    this.move(to, keys);
    this.up(to, keys);
  }

  get #scene(): ToolContext {
    return {
      document: this.history.present,
      grips: {
        handle: 10,
        line: 5,
        ring: 30,
        band: 5,
        slop: 3,
        view: this.view,
      },
      turns: this.turns,
      posesOnly: this.posesOnly,
      brush: { kind: 'stiffen', radius: 20, strength: 1, erases: false },
      guards: false,
      heldOutline: () => null,
      trace: null,
      snap: (at) => snappedTo(at, this.guides, 5),
      place: (at) => this.placement && { posed: this.led ?? at, ...this.placement },
      layerUnder: (corners) => corners.map((at) => this.placement ?? { rest: at, rotation: 0, scale: 1 }),
    };
  }

  #apply(effects: readonly Effect[]) {
    const { history } = this;
    for (const effect of effects) {
      if (effect.type === 'begin') history.begin(effect.label);
      else if (effect.type === 'edit') history.update(effect.document);
      else if (effect.type === 'commit') history.commit();
      else if (effect.type === 'bail') history.bail();
      else if (effect.type === 'select') history.update(selectHandles(history.present, effect.ids));
      else if (effect.type === 'guides') this.shown = effect.guides;
      else this.others.push(effect);
    }
  }
}

const press = (at: Vec, keys: Partial<Press>): Press => ({
  at,
  stage: at,
  shift: false,
  alt: false,
  free: false,
  ...keys,
});

let bench: Bench;
beforeEach(() => {
  bench = new Bench();
});

describe('select', () => {
  it('selects by click, adds and removes with Shift, deselects on empty space', () => {
    bench.click([2, 2]);
    expect(bench.selection).toEqual(['a']);
    bench.click([100, 0], { shift: true });
    expect(bench.selection).toEqual(['a', 'b']);
    bench.click([0, 0], { shift: true });
    expect(bench.selection).toEqual(['b']);
    bench.click([50, 80]);
    expect(bench.selection).toEqual([]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('deletes a handle by a click with Alt, as one undo step, and only that one', () => {
    bench.click([0, 0]);
    bench.click([100, 0], { shift: true });
    bench.click([1, 1], { alt: true });
    expect([bench.posed('a'), bench.posed('b')]).toEqual([undefined, [100, 0]]);
    expect(bench.history.undoLabel).toBe('Delete a');
    expect(bench.selection).toEqual(['b']);
  });

  it('keeps a handle if Alt is released first, or handles can only be posed', () => {
    bench.down([0, 0], { alt: true });
    bench.up([0, 0]);
    bench.posesOnly = true;
    bench.click([0, 0], { alt: true });
    expect(bench.posed('a')).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('turns the nearest handle by its ring with Alt, without selecting it first', () => {
    bench.drag([30, 0], [0, 30], { alt: true });
    expect([bench.rotation('a'), bench.rotation('b')]).toEqual([90, 0]);
    bench.click([50, 80]);
    bench.drag([30, 0], [0, 30]);
    expect(bench.rotation('a')).toBe(90);
  });

  it('snaps the pressed handle to guides, and all that is selected with it', () => {
    bench.guides = { lines: [{ axis: 0, at: 40 }], grid: Number.POSITIVE_INFINITY };
    bench.click([0, 0]);
    bench.click([100, 0], { shift: true });
    bench.drag([2, 2], [39, 12]);
    expect([bench.posed('a'), bench.posed('b')]).toEqual([
      [40, 10],
      [140, 10],
    ]);
    expect(bench.shown).toEqual([{ axis: 0, at: 40 }]);
  });

  it('leaves guides alone where Ctrl frees it or Shift has its own directions', () => {
    bench.guides = { lines: [{ axis: 0, at: 40 }], grid: Number.POSITIVE_INFINITY };
    bench.drag([0, 0], [38, 12], { free: true });
    expect(bench.posed('a')).toEqual([38, 12]);
    bench.drag([38, 12], [40, 40], { shift: true });
    expect(bench.posed('a')?.[0]).not.toBe(40);
    expect(bench.shown).toEqual([]);
  });

  it('drags all that is selected, as one undo step', () => {
    bench.click([0, 0]);
    bench.click([100, 0], { shift: true });
    bench.drag([1, 1], [21, 11]);
    expect([bench.posed('a'), bench.posed('b')]).toEqual([
      [20, 10],
      [120, 10],
    ]);
    expect(bench.history.undo()).toBe('Move 2 handles');
    expect(bench.posed('a')).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('keeps to steps of 45° with Shift', () => {
    bench.down([0, 0]);
    bench.move([40, 6], { shift: true });
    expect(bench.posed('a')).toEqual([40, 0]);
    bench.move([-20, 21], { shift: true });
    expect(bench.posed('a')).toEqual([-20.5, 20.5]);
    bench.move([40, 6]);
    expect(bench.posed('a')).toEqual([40, 6]);
  });

  it('moves nothing by a trembling click', () => {
    bench.drag([0, 0], [2, 0]);
    expect(bench.posed('a')).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('turns by the ring, about the handle', () => {
    bench.click([0, 0]);
    bench.drag([30, 0], [0, 30]);
    expect(bench.rotation('a')).toBe(90);
    expect(bench.posed('a')).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBe('Turn a');
  });

  it('turns by an Alt-drag, in steps of 15° with Shift', () => {
    bench.down([100, 0], { alt: true });
    bench.move([110, 0], { alt: true });
    bench.move([100, 40], { alt: true });
    expect(bench.rotation('b')).toBe(90);
    bench.move([90, 40], { alt: true, shift: true });
    expect(bench.rotation('b')).toBe(105);
    bench.up([90, 40]);
    expect(bench.history.undoLabel).toBe('Turn b');
  });

  it('turns an automatic handle on from where it is, and pins it there', () => {
    bench.history.update(changeHandles(bench.history.present, ['a'], withAutoRotation));
    bench.turns = new Map([['a', 25]]);
    bench.click([0, 0]);
    bench.drag([30, 0], [0, 30]);
    expect(bench.rotation('a')).toBe(115);
    bench.history.undo();
    expect(handleById(bench.history.present, 'a')?.rotation).toBe('auto');
  });

  it('has no ring around unselected handles', () => {
    bench.drag([30, 0], [0, 30]);
    expect(bench.rotation('a')).toBe(0);
  });

  it('boxes over empty space, with Shift in addition', () => {
    bench.drag([80, -20], [120, 20]);
    expect(bench.selection).toEqual(['b']);
    bench.drag([-20, -20], [20, 20], { shift: true });
    expect(bench.selection).toEqual(['b', 'a']);
    expect(bench.others.at(-1)).toEqual({ type: 'box', box: null });
  });

  it('bails out of a drag and of a box', () => {
    bench.down([0, 0]);
    bench.move([40, 40]);
    bench.cancel();
    expect(bench.posed('a')).toEqual([0, 0]);
    bench.down([80, -20]);
    bench.move([120, 20]);
    bench.cancel();
    expect(bench.selection).toEqual(['a']);
    expect(bench.machine.busy).toBe(false);
  });
});

describe('several selected', () => {
  /** The ring is 65 px wide about their centre: they are 50 px away, 10 and 5 more are for hit areas. */
  const [centre, radius] = [[50, 0] as const, 65];
  const onRing = (degrees: number, away = radius): Vec => add(centre, rotated([0, -away], degrees));

  beforeEach(() => {
    bench.history.update(
      selectHandles(changeHandles(bench.history.present, ['b'], withAutoRotation), ['a', 'b']),
    );
  });

  it('turn as one by the ring around them, as one undo step', () => {
    bench.drag(onRing(-60), onRing(30, 300));
    expect([bench.posed('a'), bench.posed('b')]).toEqual([
      [50, -50],
      [50, 50],
    ]);
    expect(handleById(bench.history.present, 'a')?.rotation).toBe(90);
    expect(handleById(bench.history.present, 'b')?.rotation).toBe('auto');
    expect(bench.history.undo()).toBe('Turn 2 handles');
    expect(bench.posed('a')).toEqual([0, 0]);
    expect(bench.history.undoLabel).toBeNull();
  });

  it('turn by steps of 15° with Shift, and by more than one turn', () => {
    bench.down(onRing(0));
    for (const degrees of [90, 180, 270, 360, 428]) bench.move(onRing(degrees), { shift: true });
    bench.up(onRing(428));
    expect(bench.rotation('a')).toBe(435);
  });

  it('turn as one by an Alt-drag of one of them, from where it is pressed', () => {
    bench.drag([104, 0], [50, 90], { alt: true });
    expect(bench.posed('a')).toEqual([50, -50]);
    expect(bench.rotation('a')).toBe(90);
  });

  it('turn by an Alt-drag of one at their centre from where that leads', () => {
    bench.history.update(addHandle(bench.history.present, handle('c', 50)));
    bench.history.update(selectHandles(bench.history.present, ['a', 'b', 'c']));
    bench.down([52, 0], { alt: true });
    bench.move([50, 20], { alt: true });
    bench.move([30, 0], { alt: true });
    expect(bench.rotation('a')).toBe(90);
  });

  it('have no rings of their own', () => {
    bench.drag([0, 30], [30, 0]);
    expect(bench.rotation('a')).toBe(0);
  });

  it('scale by the grip, and in tenths with Shift', () => {
    bench.down(onRing(135));
    bench.move(onRing(135, radius + 27));
    expect([bench.posed('a'), bench.posed('b')]).toEqual([
      [-27, 0],
      [127, 0],
    ]);
    expect(handleById(bench.history.present, 'b')).toMatchObject({ scale: 1.54, rotation: 'auto' });
    bench.move(onRing(135, radius + 27), { shift: true });
    expect(bench.posed('a')).toEqual([-25, 0]);
    bench.move(centre, { shift: true });
    expect(handleById(bench.history.present, 'a')).toMatchObject({ scale: 0.1 });
    bench.cancel();
    expect(bench.posed('a')).toEqual([0, 0]);
    bench.drag(onRing(135), onRing(135, radius + 50));
    expect(bench.history.undo()).toBe('Scale 2 handles');
  });

  it('have knob and grip turned with them', () => {
    bench.drag(onRing(0), onRing(90));
    bench.drag(onRing(225), onRing(225, radius + 50));
    expect(bench.posed('a')).toEqual([50, -100]);
  });

  it('have a ring that fits into the view, but none smaller than that of one handle', () => {
    bench.view = { min: [0, -60], max: [200, 40] };
    bench.drag(onRing(0, 40), onRing(90, 40));
    expect(bench.rotation('a')).toBe(90);
    bench.view = { min: [0, 0], max: [20, 20] };
    bench.drag(onRing(90, 30), onRing(0, 30));
    expect(bench.rotation('a')).toBe(0);
  });

  it('turn by the knob and scale by the grip, unless a handle is nearer', () => {
    const [beside, grip] = [add(onRing(0), [6, 0]), add(onRing(135), [0, 6])];
    for (const [id, at] of [
      ['near the knob', beside],
      ['near the grip', grip],
    ] as const) {
      bench.history.update({
        ...addHandle(bench.history.present, { id, kind: 'point', rest: at, posed: at }),
        selection: ['a', 'b'],
      });
    }
    bench.drag(onRing(0), onRing(90));
    expect(bench.history.undoLabel).toBe('Turn 2 handles');
    bench.history.undo();
    bench.drag(onRing(135), onRing(135, 2 * radius));
    expect(bench.history.undoLabel).toBe('Scale 2 handles');
    bench.history.undo();
    bench.drag(add(beside, [1, 0]), add(beside, [30, 0]));
    expect(bench.history.undoLabel).toBe('Move near the knob');
  });

  it('let a click on the ring or its grip through to what lies beneath', () => {
    bench.history.update(selectHandles(addHandle(bench.history.present, bar), ['a', 'b']));
    bench.click(onRing(135));
    expect(bench.selection).toEqual(['arm']);
  });
});

describe('point', () => {
  beforeEach(() => {
    bench.machine.choose('point');
  });

  it('places at once, posed where it was clicked, and free to turn', () => {
    bench.down([50, 60]);
    const added = handleById(bench.history.present, 'handle-1');
    expect(added).toMatchObject({ rest: [7, 8], posed: [50, 60], rotation: 'auto', scale: 2 });
    expect(bench.selection).toEqual(['handle-1']);
    bench.up([50, 60]);
    expect(bench.history.undo()).toBe('Add handle');
    expect(bench.history.present.project.handles).toHaveLength(2);
  });

  it('places with the turn the picture has there where it does not bend rigidly', () => {
    const { present } = bench.history;
    bench.history.update({ ...present, project: withMode(present.project, 'harmonic') });
    bench.click([50, 60]);
    expect(handleById(bench.history.present, 'handle-1')).toMatchObject({ rotation: 30, scale: 2 });
  });

  it('gives a handle on a part that has turned over a scale that the solver takes', () => {
    bench.machine.choose('point');
    bench.placement = { rest: [7, 8], rotation: 0, scale: 0.004 };
    bench.click([50, 60]);
    expect(handleById(bench.history.present, 'handle-1')).toMatchObject({ scale: 1 });
  });

  it('rests at its posed place while nothing is bent, at rounding limits too', () => {
    bench.placement = { rest: [50.125 - 1e-6, 60.375], rotation: 0, scale: 1 };
    bench.click([50.125, 60.375 - 1e-6]);
    const added = handleById(bench.history.present, 'handle-1');
    expect(added).toMatchObject({ rest: added?.posed, posed: [50.13, 60.37] });
  });

  it('is led onto the picture from close beside it, and dragged from there', () => {
    bench.machine.choose('point');
    bench.led = [48, 60];
    bench.drag([44, 60], [64, 60]);
    expect(handleById(bench.history.present, 'handle-1')).toMatchObject({ rest: [7, 8], posed: [68, 60] });
  });

  it('places and drags in one undo step', () => {
    bench.drag([50, 60], [70, 60]);
    expect(bench.posed('handle-1')).toEqual([70, 60]);
    bench.history.undo();
    expect(bench.history.present.project.handles).toHaveLength(2);
  });

  it('places by a click within the ring of the selection, and turns it by a drag', () => {
    bench.click([50, 60]);
    bench.click([80, 60]);
    expect(bench.history.present.project.handles).toHaveLength(4);
    expect(bench.history.undo()).toBe('Add handle');
    expect(bench.selection).toEqual(['handle-1']);
    bench.drag([80, 60], [50, 90]);
    expect(bench.rotation('handle-1')).not.toBe(0);
    expect(bench.history.present.project.handles).toHaveLength(3);
  });

  it('misses beside the picture', () => {
    bench.placement = null;
    bench.click([50, 60]);
    expect(bench.others).toEqual([{ type: 'miss', at: [50, 60] }]);
    expect(bench.history.present.project.handles).toHaveLength(2);
  });

  it('moves an existing handle', () => {
    bench.drag([0, 0], [20, 0]);
    expect(bench.posed('a')).toEqual([20, 0]);
  });
});

describe('hand', () => {
  it('pans by stage pixels', () => {
    bench.machine.choose('hand');
    bench.drag([0, 0], [10, 20]);
    const pans = bench.others.map((effect) => (effect.type === 'pan' ? effect.by : null));
    expect(pans).toEqual([
      [5, 10],
      [5, 10],
    ]);
    expect(bench.posed('a')).toEqual([0, 0]);
  });
});
