import { describe, expect, it } from 'vitest';
import { en } from '../../texts/en';
import type { EditorEffect } from '../effects';
import { englishNotice } from '../english';
import { FakeRuntime } from '../fake_runtime';
import { DEFAULT_MAPS, type MapChoices, mapFile, mapFileName } from '../map_choices';
import { mapModel } from '../map_model';
import { snapshotOf } from './autosave';

const TAIL = { id: 'tail: tip', kind: 'point', rest: [50, 50], posed: [90, 50] } as const;

/** The panel's page for maps, with a handle that is selected. */
function opened(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'handle-added', handle: { ...TAIL, rotation: 0, scale: 1, depth: 0 } });
  runtime.dispatch({ type: 'export-kind-chosen', kind: 'maps' });
  return runtime;
}

const choose = (runtime: FakeRuntime, choice: Partial<MapChoices>) =>
  runtime.dispatch({ type: 'map-choice-made', choice });

const orders = (runtime: FakeRuntime) =>
  runtime.effects.filter(
    (effect): effect is Extract<EditorEffect, { type: 'export-map' }> => effect.type === 'export-map',
  );

describe('a map', () => {
  it('has a name with the picture, the map, the handle and the format', () => {
    const named = (choice: Partial<MapChoices>) => {
      const file = mapFile({ ...DEFAULT_MAPS, ...choice }, 'tail: tip');
      return file && mapFileName('cat.png', file);
    };
    expect(named({})).toBe('cat-inverse.exr');
    expect(named({ map: 'stretch', format: 'png' })).toBe('cat-stretch.png');
    expect(named({ map: 'heat' })).toBe('cat-heat-tail-tip.png');
    expect(named({ map: 'weights' })).toBe('cat-weights.zip');
    expect(named({ map: 'weights', table: 'csv' })).toBe('cat-weights.csv');
    expect(named({ map: 'weights', of: 'handle' })).toBe('cat-weights-tail-tip.npy');
  });

  it('is exported by the choices of the person', () => {
    const runtime = opened();
    choose(runtime, { map: 'forward', area: 'grown' });
    runtime.dispatch({ type: 'command-run', command: 'export' });
    const [order] = orders(runtime);
    expect(order).toMatchObject({
      name: 'cat-forward.exr',
      moment: null,
      file: { what: 'map', map: 'forward', format: 'exr', grow: true },
    });
    expect(order?.project.handles).toHaveLength(1);
    runtime.dispatch({ type: 'export-ended', saved: 'cat-forward.exr', error: null });
    expect(englishNotice(runtime.state)?.text).toBe('Saved as cat-forward.exr.');
  });

  it('of one handle needs a selection', () => {
    const runtime = opened();
    choose(runtime, { map: 'heat' });
    expect(mapModel(runtime.state)).toMatchObject({ file: 'cat-heat-tail-tip.png' });
    runtime.dispatch({ type: 'command-run', command: 'bail' });
    expect(mapModel(runtime.state)).toMatchObject({ handle: null, file: null });
    runtime.dispatch({ type: 'command-run', command: 'export' });
    expect(orders(runtime)).toEqual([]);
    expect(englishNotice(runtime.state)?.text).toBe(en.notices.selectOne);
  });

  it('has the points of a table as its size, and the rectangle of the area', () => {
    const runtime = opened();
    const { width = 0, height = 0 } = runtime.state.picture ?? {};
    choose(runtime, { map: 'weights', every: 7 });
    const points = { width: Math.ceil(width / 7), height: Math.ceil(height / 7) };
    expect(mapModel(runtime.state).size).toEqual(points);
    choose(runtime, { map: 'forward', area: 'grown' });
    expect(mapModel(runtime.state).size).toEqual({ width, height });
  });

  it('keeps the choices with the work', () => {
    const runtime = opened();
    choose(runtime, { map: 'disocclusion', format: 'png' });
    const kept = { ...DEFAULT_MAPS, map: 'disocclusion', format: 'png' };
    expect(snapshotOf(runtime.state)?.maps).toEqual(kept);
  });
});
