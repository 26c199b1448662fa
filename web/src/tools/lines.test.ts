import { beforeEach, describe, expect, it } from 'vitest';
import { type Document, handleById, newProject, openDocument } from '../document/document';
import { addHandle, selectHandles } from '../document/edits';
import { straightBar } from '../document/fixtures';
import { anchor, corners, rotationOf } from '../document/handle';
import type { BarHandle } from '../document/project';
import type { Vec } from '../geometry/vec';
import { TestTools } from './fixtures';
import { TOOL_NAMES, type ToolName } from './machine';
import type { Draft, Effect, Press, ToolContext } from './state';

const arm = straightBar(100);
const image = { src: 'a.png', width: 400, height: 400 };

/** The picture is shown 1000 px to the right of where it rests, everywhere. */
class Bench {
  readonly machine = new TestTools();
  document: Document = selectHandles(addHandle(openDocument(newProject(image, 0.5)), arm), []);
  drafted: (Draft | null)[] = [];
  drawn: Draft | null = null;

  readonly scene = (): ToolContext => ({
    document: this.document,
    grips: { handle: 10, line: 6, ring: 30, band: 5, slop: 3, view: { min: [-1e3, -1e3], max: [1e3, 1e3] } },
    posesOnly: false,
    brush: { kind: 'stiffen', radius: 10, strength: 1, erases: false },
    guards: false,
    heldOutline: () => null,
    trace: null,
    snap: (at) => ({ at, guides: [] }),
    turns: new Map(),
    place: () => null,
    layerUnder: (corners) => corners.map(([x, y]) => ({ rest: [x - 1000, y], rotation: 0, scale: 2 })),
  });

  take(tool: ToolName) {
    this.apply(this.machine.choose(tool));
  }
  down = (at: Vec, keys: Partial<Press> = {}) =>
    this.apply(
      this.machine.down({ at, stage: at, shift: false, alt: false, free: false, ...keys }, this.scene()),
    );
  move = (at: Vec, keys: Partial<Press> = {}) =>
    this.apply(
      this.machine.move({ at, stage: at, shift: false, alt: false, free: false, ...keys }, this.scene()),
    );
  up = (at: Vec) =>
    this.apply(this.machine.up({ at, stage: at, shift: false, alt: false, free: false }, this.scene()));
  click(...places: readonly Vec[]) {
    for (const at of places) {
      this.down(at);
      this.up(at);
    }
  }
  drag(from: Vec, to: Vec, keys: Partial<Press> = {}) {
    this.down(from, keys);
    this.move([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], keys);
    this.move(to, keys);
    this.up(to);
  }
  get added() {
    return this.document.project.handles[1];
  }
  posed(id: string) {
    return handleById(this.document, id)?.posed;
  }
  apply(effects: readonly Effect[]) {
    for (const effect of effects) {
      if (effect.type === 'edit') this.document = effect.document;
      else if (effect.type === 'select') this.document = selectHandles(this.document, effect.ids);
      else if (effect.type === 'drafted') this.drafted.push(effect.draft);
      else if (effect.type === 'drawn') this.drawn = effect.draft;
    }
  }
}

let bench: Bench;
beforeEach(() => {
  bench = new Bench();
});

describe('drawing a bar', () => {
  beforeEach(() => bench.take('bar'));

  it('takes clicks, and is done by a double click', () => {
    bench.click([200, 200], [260, 200], [260, 260], [261, 260]);
    expect(bench.added).toEqual({
      id: 'bar-1',
      kind: 'bar',
      rest: [
        [-800, 200],
        [-740, 200],
        [-740, 260],
      ],
      posed: [
        [200, 200],
        [260, 200],
        [260, 260],
      ],
      rotation: 'auto',
      scale: 2,
    });
    expect(bench.document.selection).toEqual(['bar-1']);
    expect(bench.machine.draft).toBeNull();
    expect(bench.drawn?.corners).toHaveLength(3);
  });

  it('is drawn by one press, drag and release', () => {
    bench.drag([200, 200], [250, 260]);
    expect(bench.added?.posed).toEqual([
      [200, 200],
      [250, 260],
    ]);
  });

  it('is done by Enter as soon as it has two corners', () => {
    bench.click([200, 200]);
    bench.apply(bench.machine.finish(bench.scene()));
    expect(bench.added).toBeUndefined();
    bench.click([260, 200]);
    bench.apply(bench.machine.finish(bench.scene()));
    expect(bench.added?.posed).toHaveLength(2);
  });

  it('keeps to steps of 45° with Shift, clicked and dragged', () => {
    bench.click([200, 200]);
    bench.down([260, 204], { shift: true });
    bench.up([260, 204]);
    expect(bench.machine.draft?.corners[1]).toEqual([260, 200]);
    bench.apply(bench.machine.bail());
    bench.drag([200, 200], [204, 150], { shift: true });
    const end = bench.added && corners(bench.added)[1];
    expect(end?.[0]).toBeCloseTo(200);
    expect(end?.[1]).toBeCloseTo(150);
  });

  it('takes corners back one by one, and is given up by Escape', () => {
    bench.click([200, 200], [260, 200]);
    bench.apply(bench.machine.back());
    expect(bench.machine.draft?.corners).toEqual([[200, 200]]);
    bench.apply(bench.machine.back());
    expect(bench.machine.draft).toBeNull();
    bench.click([200, 200], [260, 200]);
    bench.apply(bench.machine.bail());
    expect(bench.machine.draft).toBeNull();
    expect(bench.drafted.at(-1)).toBeNull();
    expect(bench.added).toBeUndefined();
  });

  it('brings corners again that were taken back, also the first, until another is set', () => {
    const { machine } = bench;
    bench.click([200, 200], [260, 200], [260, 260]);
    for (let k = 0; k < 3; k++) bench.apply(machine.back());
    expect(machine.draft).toBeNull();
    for (const left of [1, 2, 3]) {
      expect(machine.takenBack).toBe(true);
      bench.apply(machine.again());
      expect(machine.draft?.corners).toHaveLength(left);
    }
    expect(machine.takenBack).toBe(false);
    expect(machine.draft?.corners.at(-1)).toEqual([260, 260]);
    bench.apply(machine.back());
    // A cancelled press does not set a line.
    bench.down([200, 260]);
    bench.apply(machine.cancel());
    expect(machine.takenBack).toBe(true);
    bench.click([200, 260]);
    expect(machine.takenBack).toBe(false);
    expect(bench.drafted.at(-1)?.corners).toHaveLength(3);
  });

  it('is over once all of it is taken back, and something before it', () => {
    bench.click([200, 200]);
    bench.apply(bench.machine.back());
    bench.machine.forget();
    expect(bench.machine.takenBack).toBe(false);
  });

  it('loses a corner, not the drawing, when a second finger comes', () => {
    bench.click([200, 200]);
    bench.down([260, 200]);
    bench.apply(bench.machine.cancel());
    expect(bench.machine.draft?.corners).toEqual([[200, 200]]);
    bench.take('bar');
    expect(bench.machine.draft?.corners).toEqual([[200, 200]]);
  });

  it.each(TOOL_NAMES.filter((tool) => tool !== 'bar'))('ends with its tool: %s has nothing of it', (tool) => {
    bench.click([200, 200], [260, 200]);
    bench.down([230, 300]);
    bench.take(tool);
    expect(bench.machine).toMatchObject({ draft: null, busy: false, takenBack: false });
    expect(bench.drafted.at(-1)).toBeNull();
    bench.take('bar');
    expect(bench.machine.draft).toBeNull();
    bench.click([100, 100]);
    expect(bench.machine.draft?.corners).toEqual([[100, 100]]);
  });

  it('comes back with its tool, whatever is being drawn by then', () => {
    bench.click([200, 200], [260, 200], [260, 260]);
    const { drawing } = bench.machine;
    bench.apply(bench.machine.restore());
    expect(bench.machine.draft).toBeNull();
    bench.take('polygon');
    bench.click([100, 100]);
    bench.down([160, 100]);
    bench.apply(bench.machine.restore(drawing));
    expect(bench.machine.busy).toBe(false);
    expect(bench.machine.tool).toBe('bar');
    expect(bench.machine.draft?.corners).toHaveLength(3);
    bench.apply(bench.machine.back());
    expect(bench.machine.draft?.corners).toHaveLength(2);
  });

  it('meets the nearest of several corners in reach', () => {
    const [near, far]: [Vec, Vec] = [
      [104, 0],
      [104, 80],
    ];
    const leg: BarHandle = { id: 'leg', kind: 'bar', rest: [near, far], posed: [near, far] };
    bench.document = selectHandles(addHandle(bench.document, leg), []);
    bench.click([200, 40], [103, 1]);
    expect(bench.machine.draft?.corners[1]).toEqual(near);
  });

  it('meets the corner of another handle, at rest as well', () => {
    bench.drag([200, 40], [104, 1]);
    expect(bench.added?.posed).toEqual([
      [200, 40],
      [100, 0],
    ]);
    expect(bench.added?.rest).toEqual([
      [-800, 40],
      [100, 0],
    ]);
  });

  it('follows the pointer between presses, and pans in the middle of it', () => {
    bench.click([200, 200]);
    bench.machine.hover(
      { at: [230, 210], stage: [0, 0], shift: false, alt: false, free: false },
      bench.scene(),
    );
    expect(bench.machine.draft?.next).toEqual([230, 210]);
    const pan = { down: () => ({ next: { up: () => ({ next: {}, effects: [] }) }, effects: [] }) };
    bench.machine.down(
      { at: [0, 0], stage: [0, 0], shift: false, alt: false, free: false },
      bench.scene(),
      pan,
    );
    bench.up([0, 0]);
    expect(bench.machine.draft?.corners).toEqual([[200, 200]]);
  });
});

describe('drawing a polygon', () => {
  beforeEach(() => bench.take('polygon'));

  it('closes on its first corner', () => {
    bench.click([200, 200], [260, 200], [230, 260], [204, 203]);
    expect(bench.added).toMatchObject({ id: 'polygon-1', kind: 'polygon' });
    expect(bench.added?.posed).toHaveLength(3);
  });

  it('wants three corners', () => {
    bench.click([200, 200], [260, 200], [261, 200]);
    expect(bench.added).toBeUndefined();
    expect(bench.machine.draft?.corners).toHaveLength(2);
  });

  it('tells where a press would close it', () => {
    bench.click([200, 200], [260, 200], [230, 260]);
    bench.machine.hover(
      { at: [202, 200], stage: [0, 0], shift: false, alt: false, free: false },
      bench.scene(),
    );
    expect(bench.machine.draft?.finishing).toBe(true);
  });
});

describe('an existing bar', () => {
  it('is moved by its line, with all selected handles', () => {
    bench.drag([30, 2], [50, 22]);
    expect(bench.posed('arm')).toEqual([
      [20, 20],
      [120, 20],
    ]);
    expect(bench.document.selection).toEqual(['arm']);
  });

  it('is bent by one end, and turned as its corners are', () => {
    bench.drag([100, 0], [0, 100]);
    expect(bench.posed('arm')).toEqual([
      [0, 0],
      [0, 100],
    ]);
    const bent = handleById(bench.document, 'arm');
    expect(bent && rotationOf(bent)).toBeCloseTo(90);
    expect(bent?.rotation).toBe('auto');
  });

  it('counts the turns of an end that is led around the other', () => {
    bench.down([100, 0]);
    for (const at of [
      [0, 100],
      [-100, 0],
      [0, -100],
      [100, 0],
      [0, 100],
    ] as const)
      bench.move(at);
    bench.up([0, 100]);
    const turned = handleById(bench.document, 'arm');
    expect(turned && rotationOf(turned)).toBeCloseTo(450);
  });

  it('turns by its ring, about its middle, by more than half a turn', () => {
    bench.click([30, 0]);
    bench.down([50, 30]);
    for (const at of [
      [20, 0],
      [50, -30],
      [80, 0],
    ] as const)
      bench.move(at);
    bench.up([80, 0]);
    const turned = handleById(bench.document, 'arm');
    expect(turned?.rotation).toBe(270);
    expect(turned && anchor(turned)).toEqual([50, 0]);
    expect(bench.posed('arm')).toEqual([
      [50, 50],
      [50, -50],
    ]);
  });

  it('is selected by a box that holds one of its corners', () => {
    bench.drag([130, 40], [90, -40]);
    expect(bench.document.selection).toEqual(['arm']);
  });

  it('is edited with its own tool once it is selected, and joined while it is not', () => {
    bench.take('bar');
    bench.click([100, 0]);
    expect(bench.machine.draft?.corners).toEqual([[100, 0]]);
    bench.apply(bench.machine.bail());
    bench.document = selectHandles(bench.document, ['arm']);
    bench.drag([100, 0], [120, 0]);
    expect(bench.posed('arm')?.[1]).toEqual([120, 0]);
  });
});

describe('a corner outside of the selection', () => {
  it('is reported immediately, and the drawing continues', () => {
    const bench = new Bench();
    const { project } = bench.document;
    const rings = [
      [
        [0, 0],
        [9, 0],
        [9, 9],
      ],
    ] as const;
    bench.document = { ...bench.document, project: { ...project, domain: { kind: 'polygon', rings } } };
    bench.take('bar');
    const effects = bench.machine.down(
      { at: [50, 60], stage: [50, 60], shift: false, alt: false, free: false },
      bench.scene(),
    );
    expect(effects).toContainEqual({ type: 'miss', at: [50, 60] });
    expect(bench.machine.draft?.corners).toEqual([[50, 60]]);
  });
});
