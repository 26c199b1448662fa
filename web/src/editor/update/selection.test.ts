import { describe, expect, it } from 'vitest';
import { toStage } from '../../geometry/camera';
import { FakeRuntime } from '../fake_runtime';
import { projectOf } from '../state';

const UNTOUCHED = { shift: false, alt: false, free: false, coarse: false };

describe('a selection by the page during a drag', () => {
  const dragged = (ids: readonly string[]) => {
    const runtime = new FakeRuntime();
    runtime.open();
    for (const [id, x] of [
      ['nose', 200],
      ['ear', 60],
    ] as const)
      runtime.dispatch({
        type: 'handle-added',
        handle: { id, kind: 'point', rest: [x, 150], posed: [x, 150], rotation: 'auto', scale: 1, depth: 0 },
      });
    runtime.solve();
    const { camera } = runtime.state.view;
    const at = (x: number) => ({ stage: toStage(camera, [x, 150]), ...UNTOUCHED });
    runtime.dispatch({ type: 'press-began', pointer: at(200), pans: false });
    runtime.dispatch({ type: 'press-moved', pointer: at(220) });
    runtime.dispatch({ type: 'selection-set', ids });
    runtime.dispatch({ type: 'press-moved', pointer: at(260) });
    runtime.dispatch({ type: 'press-ended', pointer: at(260) });
    const nose = projectOf(runtime.state).handles.find(({ id }) => id === 'nose');
    return Math.round(Number(nose?.kind === 'point' && nose.posed[0]));
  };

  it('of the same handles lets the drag go on', () => {
    expect(dragged(['nose'])).toBe(260);
  });

  it('of others ends the drag, whose change stays', () => {
    expect(dragged(['ear'])).toBe(220);
  });
});
