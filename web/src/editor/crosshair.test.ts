import { describe, expect, it } from 'vitest';
import { crosshairMoved, crosshairPlace } from './crosshair';
import { FakeRuntime } from './fake_runtime';
import type { EditorState } from './state';

/** A stage of 400 × 300 CSS pixels; the picture is shown at twice its size. */
function shown(crosshair: EditorState['display']['crosshair'] = null): EditorState {
  const { state } = new FakeRuntime();
  return {
    ...state,
    stage: { width: 400, height: 300 },
    view: { ...state.view, camera: { scale: 2, x: 20, y: 0 } },
    display: { ...state.display, crosshair },
  };
}

describe('the crosshair', () => {
  it('starts in the middle of the view, or at a given place', () => {
    const [x, y] = crosshairPlace(shown());
    expect(crosshairMoved(shown(), [1, 0], undefined)).toEqual([x + 2, y]);
    expect(crosshairMoved(shown(), [1, 0], [5, 5])).toEqual([7, 5]);
  });

  it('moves on from where it is', () => {
    expect(crosshairMoved(shown([5, 7]), [0, 1], [30, 30])).toEqual([5, 9]);
  });

  it('stays on the stage', () => {
    expect(crosshairMoved(shown(), [-100, -100], [0, 0])).toEqual([-10, 0]);
    expect(crosshairMoved(shown(), [1000, 1000], undefined)).toEqual([190, 150]);
  });
});
