import { describe, expect, it } from 'vitest';
import type { EditorEffect } from '../effects';
import { engineModel } from '../engine_model';
import { FakeRuntime } from '../fake_runtime';

/** The panel's page for engines, with some handles. */
function opened(handles: number): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  for (let k = 0; k < handles; k++) {
    const at = [10 + k, 50] as const;
    const handle = {
      id: `${k}`,
      kind: 'point',
      rest: at,
      posed: at,
      rotation: 0,
      scale: 1,
      depth: 0,
    } as const;
    runtime.dispatch({ type: 'handle-added', handle });
  }
  runtime.dispatch({ type: 'export-kind-chosen', kind: 'engine' });
  return runtime;
}

const orders = (runtime: FakeRuntime) =>
  runtime.effects.filter(
    (effect): effect is Extract<EditorEffect, { type: 'export-engine-rig' }> =>
      effect.type === 'export-engine-rig',
  );

describe('a rig for an engine', () => {
  it('has at least one bone for each handle', () => {
    const runtime = opened(7);
    runtime.dispatch({ type: 'engine-choice-made', choice: { bones: 5 } });
    expect(engineModel(runtime.state).bones).toEqual({ now: 7, least: 7 });
    runtime.dispatch({ type: 'command-run', command: 'export' });
    expect(orders(runtime)[0]?.order.bones).toBe(7);
  });

  it('has as many bones as chosen if handles are fewer', () => {
    const runtime = opened(2);
    runtime.dispatch({ type: 'engine-choice-made', choice: { bones: 5 } });
    expect(engineModel(runtime.state).bones).toEqual({ now: 5, least: 2 });
    runtime.dispatch({ type: 'command-run', command: 'export' });
    expect(orders(runtime)[0]?.order.bones).toBe(5);
  });
});
