import { describe, expect, it } from 'vitest';
import type { Vec } from '../geometry/vec';
import { type Document, newProject, openDocument } from './document';
import { selectHandles } from './edits';
import { posedLike } from './handle';
import { mirrorHandles } from './mirror';
import type { BarHandle, Handle, PointHandle } from './project';

/** The whole of a 400 × 800 picture: the axis is at 200, counterparts are less than 25 px away. */
const bounds = { min: [0, 0], max: [400, 800] } as const;
const isOn = ([x, y]: Vec) => x >= 0 && x <= 400 && y >= 0 && y <= 800;

const point = (id: string, rest: Vec, pose: Partial<PointHandle> = {}): PointHandle => ({
  id,
  kind: 'point',
  rest,
  posed: rest,
  rotation: 'auto',
  ...pose,
});
const bar = (id: string, rest: readonly Vec[], pose: Partial<BarHandle> = {}): BarHandle => ({
  id,
  kind: 'bar',
  rest,
  posed: rest,
  rotation: 'auto',
  ...pose,
});
const holding = (handles: readonly Handle[], selection: readonly string[]): Document =>
  selectHandles(
    openDocument({ ...newProject({ src: 'a.png', width: 400, height: 800 }, null), handles }),
    selection,
  );
const mirror = (handles: readonly Handle[], ...selection: readonly string[]) =>
  mirrorHandles(holding(handles, selection), bounds, isOn);

const left = point('left-hand', [50, 300], { posed: [80, 200], rotation: 30, scale: 2, depth: 1 });

describe('mirroring a handle', () => {
  it('poses and selects the counterpart, and keeps the handle', () => {
    const { document, unmatched: out } = mirror([left, point('right-hand', [350, 300])], 'left-hand');
    const image = { posed: [320, 200], rotation: -30, scale: 2, depth: 1 };
    expect(document.project.handles).toEqual([left, { ...point('right-hand', [350, 300]), ...image }]);
    expect(document.selection).toEqual(['right-hand']);
    expect(out).toEqual([]);
  });

  it('moves a nearby counterpart by the same vector, and keeps its rest position', () => {
    const [, right] = mirror([left, point('right-hand', [360, 310])], 'left-hand').document.project.handles;
    expect(right).toMatchObject({ rest: [360, 310], posed: [330, 210] });
  });

  it('adds a missing counterpart, with the id of the other side or a free one', () => {
    const far = point('right-hand', [350, 340]);
    const one = mirror([left], 'left-hand').document;
    const image = { rest: [350, 300], posed: [320, 200], rotation: -30, scale: 2, depth: 1 };
    expect(one.project.handles[1]).toEqual({ ...left, id: 'right-hand', ...image });
    expect(one.selection).toEqual(['right-hand']);
    const two = mirror([left, far], 'left-hand').document;
    expect(two.project.handles.map(({ id }) => id)).toEqual(['left-hand', 'right-hand', 'handle-1']);
    const bright = mirror([point('bright', [50, 300])], 'bright').document;
    expect(bright.selection).toEqual(['handle-1']);
  });

  it('poses the nearest handle of the kind if it is a mutual counterpart', () => {
    const arm = bar('arm', [
      [350, 300],
      [350, 310],
    ]);
    const fingers = [point('a', [50, 300]), point('b', [50, 312]), point('c', [350, 302])];
    expect(mirror([arm, ...fingers], 'a').document.selection).toEqual(['c']);
    const { document } = mirror([arm, ...fingers], 'b');
    expect(document.selection).toEqual(['handle-1']);
    expect(document.project.handles.at(-1)?.rest).toEqual([350, 312]);
  });

  it('leaves out handles whose mirror images are outside the domain', () => {
    const handles = [left, point('hat', [-40, 20])];
    const { document, unmatched: out } = mirror(handles, 'left-hand', 'hat');
    expect(out.map(({ id }) => id)).toEqual(['hat']);
    expect(document.selection).toEqual(['right-hand']);
    expect(mirror(handles, 'hat').document).toEqual(holding(handles, ['hat']));
  });

  it('flips a handle on the axis, and the whole pose if all are selected', () => {
    const head = point('head', [204, 100], { posed: [260, 120], rotation: -20 });
    const right = point('right-hand', [350, 300], { posed: [350, 500] });
    const all = ['head', 'left-hand', 'right-hand'];
    const once = mirror([head, left, right], ...all).document;
    expect(once.project.handles).toMatchObject([
      { rest: [204, 100], posed: [148, 120], rotation: 20 },
      { rest: [50, 300], posed: [50, 500], rotation: 'auto' },
      { rest: [350, 300], posed: [320, 200], rotation: -30 },
    ]);
    expect(mirrorHandles(once, bounds, isOn).document.project.handles).toMatchObject([head, left, right]);
  });
});

describe('mirroring a bar', () => {
  const upper = [
    [50, 300],
    [100, 300],
    [150, 300],
  ] as const;
  const bent = bar('left-arm', upper, {
    posed: [
      [50, 200],
      [100, 250],
      [150, 300],
    ],
  });

  it('keeps the order of its corners', () => {
    const { document } = mirror([bent], 'left-arm');
    expect(document.project.handles[1]).toMatchObject({
      id: 'right-arm',
      rest: [
        [350, 300],
        [300, 300],
        [250, 300],
      ],
      posed: [
        [350, 200],
        [300, 250],
        [250, 300],
      ],
    });
  });

  it('bends a counterpart with reversed and fewer corners', () => {
    const right = bar('bar-1', [
      [250, 300],
      [350, 300],
    ]);
    expect(mirror([bent, right], 'left-arm').document.project.handles[1]).toMatchObject({
      posed: [
        [250, 300],
        [350, 200],
      ],
    });
  });

  it('poses a counterpart with other corners on the mirror image', () => {
    const right = bar('bar-1', [
      [350, 300],
      [270, 300],
      [250, 300],
    ]);
    const turned = bar('left-arm', [upper[0], upper[2]], {
      posed: [
        [100, 250],
        [100, 350],
      ],
    });
    expect(mirror([turned, right], 'left-arm').document.project.handles[1]?.posed).toEqual([
      [300, 250],
      [300, 330],
      [300, 350],
    ]);
  });

  it('turns a counterpart about its own middle, with whole turns', () => {
    const turned = bar(
      'left-arm',
      [
        [50, 300],
        [150, 300],
      ],
      {
        posed: [
          [100, 250],
          [100, 350],
        ],
        rotation: 450,
      },
    );
    const right = bar('bar-1', [
      [250, 310],
      [350, 310],
    ]);
    expect(mirror([turned, right], 'left-arm').document.project.handles[1]).toMatchObject({
      rotation: -450,
      posed: [
        [300, 360],
        [300, 260],
      ],
    });
  });
});

it('a polygon is posed like one that starts at another corner', () => {
  const square = (x: number, y: number, size = 50): readonly Vec[] => [
    [x, y],
    [x + size, y],
    [x + size, y + size],
    [x, y + size],
  ];
  const [a, b, c, d] = square(300, 300) as [Vec, Vec, Vec, Vec];
  const source: Handle = { id: 'a', kind: 'polygon', rest: square(50, 300), posed: square(60, 280, 80) };
  const other: Handle = { id: 'b', kind: 'polygon', rest: [c, b, a, d], posed: [c, b, a, d] };
  expect(mirror([source, other], 'a').document.project.handles[1]?.posed).toEqual([
    [340, 360],
    [340, 280],
    [260, 280],
    [260, 360],
  ]);
});

it('a bar is moved, turned and scaled like another one elsewhere', () => {
  const like = bar(
    'a',
    [
      [0, 0],
      [10, 0],
    ],
    {
      posed: [
        [15, 90],
        [15, 110],
      ],
      scale: 2,
    },
  );
  const upright = bar('b', [
    [100, 0],
    [100, 40],
  ]);
  expect(posedLike(upright, like)).toMatchObject({
    scale: 2,
    posed: [
      [150, 120],
      [70, 120],
    ],
  });
});
