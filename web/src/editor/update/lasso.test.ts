import { describe, expect, it } from 'vitest';
import { ringsOf } from '../../document/domain';
import type { Vec } from '../../geometry/vec';
import { reasonAgainst } from '../can_run';
import { snapsToEdges, traceOf } from '../edge_snapping';
import { englishNotice, inEnglish, spokenText } from '../english';
import { FakeRuntime, testPicture } from '../fake_runtime';
import { toolContext } from '../hit_areas';
import { projectOf, selectionOf } from '../state';
import { snapshotOf } from './autosave';

const SQUARE: readonly Vec[] = [
  [100, 100],
  [200, 100],
  [200, 200],
  [100, 200],
];

const opened = (picture = testPicture()): FakeRuntime => {
  const runtime = new FakeRuntime();
  runtime.open(picture);
  return runtime;
};
const lassoed = (): FakeRuntime => {
  const runtime = opened();
  runtime.dispatch({ type: 'lasso-drawn', ring: SQUARE, hole: false });
  runtime.solve();
  return runtime;
};
const ring = (runtime: FakeRuntime) => ringsOf(projectOf(runtime.state))[0] ?? [];
const run = (runtime: FakeRuntime, command: 'lasso' | 'remove' | 'add-corner' | 'undo' | 'bar') =>
  runtime.dispatch({ type: 'command-run', command });

describe('a place outside of the selection', () => {
  it('can be added, as one step', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'placement-missed', at: [250, 150] });
    expect(englishNotice(runtime.state)).toMatchObject({
      text: 'The picture does not bend outside the selection.',
      action: { label: 'Extend the selection' },
    });
    runtime.dispatch({ type: 'notice-answered' });
    expect(Math.max(...ring(runtime).map(([x]) => x))).toBeGreaterThan(250);
    expect(englishNotice(runtime.state)).toBeNull();
    run(runtime, 'undo');
    expect(ring(runtime)).toEqual(SQUARE);
  });
  it('is refused before the selection is solved', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'lasso-drawn', ring: SQUARE, hole: false });
    expect(toolContext(runtime.state).place([250, 150])).toBeNull();
    expect(toolContext(runtime.state).place([150, 150])).not.toBeNull();
  });
  it('cannot be added beside the picture, nor without a lasso', () => {
    for (const [runtime, at] of [
      [lassoed(), [900, 150]],
      [opened(), [900, 150]],
    ] as const) {
      runtime.dispatch({ type: 'placement-missed', at });
      expect(englishNotice(runtime.state)?.action).toBeUndefined();
    }
  });
});

describe('the part in a lasso that shall turn', () => {
  it('gets a polygon by the notice, as one step', () => {
    const runtime = lassoed();
    expect(englishNotice(runtime.state)?.other?.label).toBe('Turn this part, bend the rest');
    runtime.dispatch({ type: 'notice-answered', other: true });
    const { handles, ...project } = projectOf(runtime.state);
    expect(handles.map(({ kind }) => kind)).toEqual(['polygon']);
    expect(project).toMatchObject({ fix_boundary: true, domain: { kind: 'image' } });
    expect(selectionOf(runtime.state)).toEqual([handles[0]?.id]);
    expect(runtime.state.tools.tool).toBe('select');
    run(runtime, 'undo');
    expect(ring(runtime)).toEqual(SQUARE);
    expect(projectOf(runtime.state).handles).toEqual([]);
  });
  it('needs a lasso, in a picture without transparency', () => {
    expect(inEnglish(reasonAgainst(lassoed().state, 'turn-part'))).toBeNull();
    expect(inEnglish(reasonAgainst(opened().state, 'turn-part'))).toBe('Draw a lasso around a part first');
    const clear = opened({ ...testPicture(), alphaThreshold: 0.5 });
    clear.dispatch({ type: 'lasso-drawn', ring: SQUARE, hole: false });
    expect(inEnglish(reasonAgainst(clear.state, 'turn-part'))).toContain('without transparency');
    expect(englishNotice(clear.state)?.other).toBeUndefined();
  });
});

describe('the first lasso of an opaque picture', () => {
  it('is free over a filled background, and its boundary can be held', () => {
    const runtime = opened();
    expect(projectOf(runtime.state).fix_boundary).toBe(true);
    runtime.dispatch({ type: 'lasso-drawn', ring: SQUARE, hole: false });
    expect(projectOf(runtime.state)).toMatchObject({ fix_boundary: false, fill: { method: 'patches' } });
    expect(englishNotice(runtime.state)?.action?.label).toBe('Lock its outline');
    runtime.dispatch({ type: 'notice-answered' });
    expect(projectOf(runtime.state).fix_boundary).toBe(true);
    // A second one does not change that.
    runtime.dispatch({ type: 'lasso-drawn', ring: SQUARE.map(([x, y]): Vec => [x + 150, y]), hole: false });
    expect(projectOf(runtime.state).fix_boundary).toBe(true);
  });
  it('is removed with its fill, and the frame is held again', () => {
    const runtime = lassoed();
    runtime.dispatch({ type: 'lasso-removed' });
    expect(projectOf(runtime.state)).toMatchObject({ fix_boundary: true, domain: { kind: 'image' } });
    expect(projectOf(runtime.state).fill).toBeUndefined();
  });
});

describe('a focused corner of the selection', () => {
  const focused = (): FakeRuntime => {
    const runtime = lassoed();
    run(runtime, 'lasso');
    runtime.dispatch({ type: 'ring-focused', corner: { ring: 0, index: 1 } });
    return runtime;
  };
  const focusOf = (runtime: FakeRuntime) => {
    const last = runtime.effects.findLast((effect) => effect.type === 'focus');
    return last?.type === 'focus' ? last.target.ring : undefined;
  };

  it('is moved by arrows, in one step', () => {
    const runtime = focused();
    for (let k = 0; k < 3; k++) runtime.dispatch({ type: 'arrow-pressed', by: [10, 0] });
    expect(ring(runtime)[1]).toEqual([230, 100]);
    expect(spokenText(runtime.state)).toBe('Corner 2 of the selection: x 230, y 100');
    run(runtime, 'undo');
    expect(ring(runtime)).toEqual(SQUARE);
  });
  it('stays where the outline would cross itself', () => {
    const runtime = focused();
    runtime.dispatch({ type: 'arrow-pressed', by: [0, 150] });
    expect(ring(runtime)).toEqual(SQUARE);
    expect(spokenText(runtime.state)).toMatch(/cross/);
  });
  it('is followed by a new one with C, and goes with Delete, unless it is needed', () => {
    const runtime = focused();
    run(runtime, 'add-corner');
    expect(ring(runtime)[2]).toEqual([200, 150]);
    expect(focusOf(runtime)).toEqual({ ring: 0, index: 2 });
    run(runtime, 'remove');
    run(runtime, 'remove');
    expect(ring(runtime)).toHaveLength(3);
    run(runtime, 'remove');
    expect(ring(runtime)).toHaveLength(3);
  });
  it('leaves keys to the crosshair once the stage has the focus', () => {
    const runtime = focused();
    runtime.dispatch({ type: 'stage-focused' });
    runtime.dispatch({ type: 'arrow-pressed', by: [10, 0] });
    expect(ring(runtime)).toEqual(SQUARE);
  });
});

describe('snapping to edges', () => {
  const values = { width: 400, height: 300, values: new Uint8Array(120_000), step: 1, coarser: null };

  it('is on for opaque pictures, and a choice stays with the work', () => {
    const runtime = opened();
    expect(snapsToEdges(runtime.state)).toBe(true);
    expect(snapsToEdges(opened({ ...testPicture(), alphaThreshold: 0.5 }).state)).toBe(false);
    runtime.dispatch({ type: 'edge-snapping-switched', on: false });
    expect(snapsToEdges(runtime.state)).toBe(false);
    expect(snapshotOf(runtime.state)?.edgeSnapping).toBe(false);
  });
  it('waits for the luminance, which the lasso asks for once', () => {
    const runtime = opened();
    const asked = () => runtime.effects.filter(({ type }) => type === 'read-luminance').length;
    expect(asked()).toBe(0);
    run(runtime, 'lasso');
    expect(traceOf(runtime.state)).toBeNull();
    const { picture } = runtime.state;
    if (picture) runtime.dispatch({ type: 'luminance-read', picture, values });
    expect(traceOf(runtime.state)?.([[10, 10]], [90, 10]).at(-1)).toEqual([90, 10]);
    // Places within a pixel of the frame lie on it.
    expect(traceOf(runtime.state)?.([[10, 10]], [399.4, 0.7])).toEqual([[400, 0]]);
    run(runtime, 'bar');
    run(runtime, 'lasso');
    expect(asked()).toBe(1);
    // The answer for a picture that has been closed.
    runtime.dispatch({ type: 'luminance-read', picture: testPicture('dog.png'), values });
    expect(runtime.state.luminance?.of).toBe(picture);
  });
});
