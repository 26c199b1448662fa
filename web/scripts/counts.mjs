/** Counts of passed and failed tests, read from the reports of the test runners. */

/** @typedef {{ passed: number, failed: number, skipped: number }} Counts */

/**
 * @param {string} output The output of `cargo test`.
 * @returns {Counts}
 */
export function cargoCounts(output) {
  const counts = { passed: 0, failed: 0, skipped: 0 };
  for (const match of output.matchAll(/(\d+) passed; (\d+) failed; (\d+) ignored/g)) {
    counts.passed += Number(match[1]);
    counts.failed += Number(match[2]);
    counts.skipped += Number(match[3]);
  }
  return counts;
}

/**
 * @param {string} json Report of vitest's JSON reporter.
 * @returns {Counts}
 */
export function vitestCounts(json) {
  const { numPassedTests, numFailedTests, numPendingTests } = JSON.parse(json);
  return { passed: numPassedTests, failed: numFailedTests, skipped: numPendingTests };
}

/**
 * @param {string} json Report of Playwright's JSON reporter. A flaky test counts as failed.
 * @returns {Counts}
 */
export function playwrightCounts(json) {
  const { expected, unexpected, flaky, skipped } = JSON.parse(json).stats;
  return { passed: expected, failed: unexpected + flaky, skipped };
}

/**
 * The last line of a whole run.
 * @param {Counts[]} parts
 */
export function summary(parts) {
  const sum = (/** @type {keyof Counts} */ key) => parts.reduce((total, part) => total + part[key], 0);
  return `${sum('passed')} passed, ${sum('failed')} failed`;
}
