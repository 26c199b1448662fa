import { beforeEach, describe, expect, it } from 'vitest';
import { newProject, openDocument } from '../document/document';
import { ringsOf } from '../document/domain';
import type { Project } from '../document/project';
import { enclosedBy } from '../geometry/enclosed';
import { areaOf, isSimple } from '../geometry/ring';
import type { Vec } from '../geometry/vec';
import { TestTools } from './fixtures';
import type { Effect, Press, ToolContext } from './state';

const scene: ToolContext = {
  document: openDocument(newProject({ src: 'a.jpg', width: 400, height: 400 }, null)),
  grips: { handle: 10, line: 6, ring: 30, band: 5, slop: 3, view: { min: [-1e3, -1e3], max: [1e3, 1e3] } },
  posesOnly: false,
  brush: { kind: 'stiffen', radius: 10, strength: 1, erases: false },
  guards: false,
  heldOutline: () => null,
  trace: null,
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

  it('follows a drag with few corners, and closes where it returns', () => {
    drag([
      [10, 10],
      [12, 10],
      [30, 10.5],
      [50, 10],
      [52, 11],
      [50, 60],
      [10, 60],
      [11, 30],
      [10, 18],
    ]);
    expect(lassoed()).toEqual({
      type: 'lassoed',
      ring: [
        [10, 10],
        [50, 10],
        [50, 60],
        [10, 60],
        [10, 18],
      ],
      hole: false,
    });
    expect(machine.draft).toBeNull();
  });
  it('continues after a drag that ends elsewhere', () => {
    drag([
      [10, 10],
      [50, 10],
      [50, 60],
    ]);
    expect(lassoed()).toBeUndefined();
    click([10, 60]);
    expect(machine.draft?.corners).toHaveLength(4);
    click([10, 12]);
    expect(lassoed()).toMatchObject({ ring: expect.arrayContaining([[10, 60]]) });
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
  it('is finished by Enter, and takes back a click or a whole drag, and redoes it', () => {
    click([10, 10]);
    drag([
      [90, 10],
      [100, 50],
      [90, 90],
    ]);
    click([50, 95]);
    expect(machine.draft?.corners).toHaveLength(5);
    machine.back();
    expect(machine.draft?.corners).toHaveLength(4);
    machine.back();
    expect(machine.draft?.corners).toEqual([[10, 10]]);
    machine.again();
    expect(machine.draft?.corners).toHaveLength(4);
    act(machine.finish(scene));
    expect(lassoed()).toMatchObject({
      ring: [
        [10, 10],
        [90, 10],
        [100, 50],
        [90, 90],
      ],
    });
  });
  it('drops curls of the hand at turns, and an end that overshoots its beginning', () => {
    drag([
      [20, 40],
      [150, 40],
      [300, 40],
      [306, 40],
      [306, 34],
      [300, 34],
      [300, 200],
      [300, 208],
      [292, 208],
      [292, 200],
      [308, 200],
      [20, 200],
      [20, 35],
      [24, 33],
    ]);
    const effect = lassoed();
    const ring = effect?.type === 'lassoed' ? effect.ring : [];
    expect(isSimple(ring)).toBe(true);
    expect(Math.abs(areaOf(ring) - 280 * 160)).toBeLessThan(200);
  });
  it('keeps a small loop whose corners were clicked', () => {
    const clicked = [
      [20, 40],
      [300, 40],
      [306, 34],
      [300, 28],
      [294, 34],
      [300, 200],
      [20, 200],
    ] as const;
    for (const at of clicked) click(at);
    act(machine.finish(scene));
    expect(lassoed()).toMatchObject({ ring: clicked });
  });
  it('keeps both lobes of a drag in the form of an eight', () => {
    const eight = Array.from({ length: 60 }, (_, k): Vec => {
      const turn = (2 * Math.PI * k) / 59;
      return [200 + 150 * Math.cos(turn), 200 + 80 * Math.sin(2 * turn)];
    });
    drag(eight);
    const effect = lassoed();
    const ring = effect?.type === 'lassoed' ? effect.ring : [];
    expect(
      enclosedBy([ring])
        .map(areaOf)
        .every((area) => area > 7000),
    ).toBe(true);
    expect(enclosedBy([ring])).toHaveLength(2);
  });
  it('cuts a hole with Alt at its beginning', () => {
    const alt = { alt: true };
    drag(
      [
        [10, 10],
        [50, 10],
        [50, 60],
        [12, 12],
      ],
      alt,
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
  describe('that snaps to edges', () => {
    // An edge along y = 100, which ways follow.
    const snapping: ToolContext = {
      ...scene,
      trace: (corners, [x, y]) => {
        const from = corners.at(-1);
        if (Math.abs(y - 100) > 20) return [[x, y]];
        return from
          ? [
              [(from[0] + x) / 2, 100],
              [x, 100],
            ]
          : [[x, 100]];
      },
    };
    const press2 = (at: Vec, keys: Partial<Press> = {}) => {
      machine.down(press(at, keys), snapping);
      act(machine.up(press(at, keys), snapping));
    };
    it('shows the way to the pointer, and sets it with a click', () => {
      press2([10, 104]);
      machine.hover(press([50, 96]), snapping);
      expect(machine.draft).toMatchObject({ next: [50, 100], path: [[30, 100]] });
      press2([50, 96]);
      expect(machine.draft?.corners).toEqual([
        [10, 100],
        [30, 100],
        [50, 100],
      ]);
      machine.back();
      expect(machine.draft?.corners).toEqual([[10, 100]]);
    });
    it('seeks ways from all corners that are there, and back to the first one', () => {
      press2([10, 104]);
      press2([50, 96]);
      const asked: (readonly Vec[])[] = [];
      const asking: ToolContext = {
        ...snapping,
        trace: (corners, to) => {
          asked.push([...corners, to]);
          return [[40, 60], to];
        },
      };
      machine.hover(press([90, 180]), asking);
      machine.hover(press([10, 101]), asking);
      expect(machine.draft?.path).toEqual([[40, 60]]);
      const corners = [
        [10, 100],
        [30, 100],
        [50, 100],
      ];
      expect(asked).toEqual([
        [...corners, [90, 180]],
        [...corners, [10, 100]],
      ]);
    });
    it('keeps each corner that was clicked, also at a narrow tip', () => {
      const direct: ToolContext = { ...scene, trace: (_, to) => [to] };
      const tip: Vec = [200, 30];
      for (const at of [[196, 50], tip, [204, 50], [204, 300], [196, 300]] as const) {
        machine.down(press(at), direct);
        act(machine.up(press(at), direct));
      }
      act(machine.finish(direct));
      expect(lassoed()).toMatchObject({ ring: expect.arrayContaining([tip]) });
    });
    it('draws freely with Alt', () => {
      press2([10, 104]);
      machine.hover(press([50, 96], { alt: true }), snapping);
      expect(machine.draft).toMatchObject({ next: [50, 96], path: [] });
    });
    it('puts the pieces of a drag on edges that are near', () => {
      machine.down(press([10, 104]), snapping);
      for (let x = 10; x <= 100; x += 5) machine.move(press([x, 104]), snapping);
      for (let y = 104; y <= 200; y += 4) machine.move(press([100, y]), snapping);
      act(machine.up(press([100, 200]), snapping));
      expect(machine.draft?.corners.slice(0, 3).every(([, y]) => y === 100)).toBe(true);
      expect(machine.draft?.corners.at(-1)).toEqual([100, 200]);
    });
  });
});

describe('the corners of a selection', () => {
  const square = [
    [100, 100],
    [200, 100],
    [200, 200],
    [100, 200],
  ] as const;
  const project: Project = {
    ...scene.document.project,
    domain: { kind: 'polygon', rings: [square] },
    handles: [{ id: 'a', kind: 'point', rest: [105, 105], posed: [105, 105] }],
  };
  const lassoed: ToolContext = { ...scene, document: openDocument(project) };
  const drag = (path: readonly Vec[]): readonly Effect[] => {
    const machine = new TestTools();
    machine.choose('lasso');
    const [first = [0, 0]] = path;
    machine.down(press(first), lassoed);
    const moves = path.slice(1).flatMap((at) => machine.move(press(at), lassoed));
    return [...moves, ...machine.up(press(path.at(-1) ?? first), lassoed)];
  };
  const ringOf = (effects: readonly Effect[]) => {
    const last = effects.findLast((effect) => effect.type === 'edit');
    return last?.type === 'edit' ? ringsOf(last.document.project)[0] : undefined;
  };

  it('move by drags, as one step, and tell of handles left outside', () => {
    const effects = drag([
      [102, 101],
      [110, 110],
      [142, 141],
    ]);
    expect(ringOf(effects)).toEqual([[140, 140], ...square.slice(1)]);
    expect(effects.filter(({ type }) => type === 'begin' || type === 'commit')).toHaveLength(2);
    expect(effects.at(-1)).toEqual({ type: 'left-out', count: 1 });
  });
  it('are added by drags from an edge', () => {
    expect(
      ringOf(
        drag([
          [150, 101],
          [150, 90],
          [150, 81],
        ]),
      ),
    ).toEqual([square[0], [150, 80], ...square.slice(1)]);
  });
  it('stop before the outline crosses itself', () => {
    expect(
      ringOf(
        drag([
          [100, 100],
          [150, 120],
          [400, 120],
        ]),
      )?.[0],
    ).toEqual([150, 120]);
  });
  it('get the focus by a click, and a click on an edge begins a new outline', () => {
    expect(drag([[100, 100]])).toEqual([
      { type: 'ring-focus', corner: expect.objectContaining({ ring: 0, index: 0 }) },
    ]);
    expect(drag([[150, 100]]).map(({ type }) => type)).toEqual(['select', 'drafted']);
  });
});
