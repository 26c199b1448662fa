import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { PoseChecks } from './pose_checks';

describe('PoseChecks', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('looks once for many poses, and only where the answer is shown', () => {
    const host = {
      shown: false,
      folds: vi.fn(() => 2),
      beyond: vi.fn(() => true),
      changed: vi.fn(),
      outside: vi.fn(),
    };
    const checks = new PoseChecks(host);
    checks.posed();
    vi.runAllTimers();
    expect(host.folds).not.toHaveBeenCalled();
    host.shown = true;
    for (let frame = 0; frame < 5; frame++) checks.posed();
    vi.runAllTimers();
    expect(host.folds).toHaveBeenCalledTimes(1);
    expect([checks.folds, checks.beyond, host.changed.mock.calls.length]).toEqual([2, true, 1]);
  });
});
