import { describe, expect, it } from 'vitest';
import { cargoCounts, playwrightCounts, summary, vitestCounts } from './counts.mjs';

describe('counts', () => {
  it('adds up every test binary of cargo', () => {
    const output = [
      'test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.1s',
      'test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.1s',
    ].join('\n');
    expect(cargoCounts(output)).toEqual({ passed: 15, failed: 2, skipped: 1 });
  });

  it('reads the reports of vitest and Playwright', () => {
    expect(vitestCounts('{"numPassedTests":4,"numFailedTests":1,"numPendingTests":2}')).toEqual({
      passed: 4,
      failed: 1,
      skipped: 2,
    });
    expect(playwrightCounts('{"stats":{"expected":5,"unexpected":1,"flaky":1,"skipped":0}}')).toEqual({
      passed: 5,
      failed: 2,
      skipped: 0,
    });
  });

  it('sums them in one line', () => {
    expect(
      summary([
        { passed: 1, failed: 0, skipped: 0 },
        { passed: 2, failed: 1, skipped: 3 },
      ]),
    ).toBe('3 passed, 1 failed');
  });
});
