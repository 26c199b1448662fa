import { describe, expect, it } from 'vitest';
import type { Study } from '../../document/generated/study';
import { FakeRuntime } from '../fake_runtime';

const study: Study = {
  outline: [],
  sites: [],
  falloff: [1, 0],
  rounds: [0.5, 0.2, -0.1].map((score, sites) => ({ score, sites, points: [] })),
  allowed_score: -0.05,
};

function opened(): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'study-shown', page: 'rounds' });
  const { shown } = runtime.state.solution;
  if (shown) runtime.dispatch({ type: 'study-found', solution: shown, study });
  return runtime;
}

const elapse = (runtime: FakeRuntime) => runtime.dispatch({ type: 'timer-elapsed', timer: 'replay' });

describe('the replay', () => {
  it('begins at the last round, plays from the first, and ends', () => {
    const runtime = opened();
    const replay = () => runtime.state.study.replay;
    expect(replay()).toEqual({ round: null, playing: false });
    runtime.dispatch({ type: 'round-shown', round: 9 });
    expect(replay().round).toBe(2);
    runtime.dispatch({ type: 'replay-switched', on: true });
    expect(replay()).toEqual({ round: 0, playing: true });
    elapse(runtime);
    expect(replay()).toEqual({ round: 1, playing: true });
    elapse(runtime);
    expect(replay()).toEqual({ round: 2, playing: false });
  });

  it('pauses, and stops on another page', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'replay-switched', on: true });
    runtime.dispatch({ type: 'replay-switched', on: false });
    elapse(runtime);
    expect(runtime.state.study.replay).toEqual({ round: 0, playing: false });
    runtime.dispatch({ type: 'replay-switched', on: true });
    runtime.dispatch({ type: 'study-shown', page: 'cells' });
    elapse(runtime);
    expect(runtime.state.study.replay).toEqual({ round: 0, playing: false });
  });
});
