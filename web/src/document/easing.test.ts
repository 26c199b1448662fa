import { describe, expect, it } from 'vitest';
import { newProject } from './document';
import { between } from './easing';
import { straightBar } from './fixtures';
import { anchor, rotationOf, turnedTo } from './handle';
import type { Project } from './project';

const bar = straightBar(10);
const holding = (...handles: Project['handles']): Project => ({
  ...newProject({ src: '', width: 8, height: 8 }, null),
  handles,
});

describe('between two poses', () => {
  it('a bar turns as a whole, and keeps its length', () => {
    const [half] = between(holding(bar), holding(turnedTo(bar, 180)), 0.5, new Map()).handles;
    if (half?.kind !== 'bar') throw new Error('a bar stays one');
    expect(rotationOf(half)).toBeCloseTo(90);
    expect(anchor(half)).toEqual([5, 0]);
    const [[x1, y1] = [0, 0], [x2, y2] = [0, 0]] = half.posed;
    expect(Math.hypot(x2 - x1, y2 - y1)).toBeCloseTo(10);
  });

  it('an automatic point goes from the turn that it has to the one it is given', () => {
    const free = { id: 'a', kind: 'point', rest: [0, 0], posed: [0, 0], rotation: 'auto' } as const;
    const turns = new Map([['a', 20]]);
    const [half] = between(
      holding(free),
      holding({ ...free, rotation: 40, posed: [4, 0] }),
      0.5,
      turns,
    ).handles;
    expect(half).toMatchObject({ rotation: 30, posed: [2, 0] });
    const [still] = between(holding(free), holding({ ...free, posed: [4, 0] }), 0.5, turns).handles;
    expect(still?.rotation).toBe('auto');
  });

  it('a point turns on past half a turn, and not back by the way around', () => {
    const hand = { id: 'hand', kind: 'point', rest: [0, 0], posed: [0, 0] } as const;
    const turned = (rotation: number) => holding(turnedTo(hand, rotation));
    const at = (share: number) => between(turned(170), turned(210), share, new Map()).handles[0]?.rotation;
    expect([at(0.25), at(0.5), at(1)]).toEqual([180, 190, 210]);
  });
});
