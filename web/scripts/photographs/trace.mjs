/** Times on a page's main thread, from a trace of Chromium. */

/**
 * @typedef {object} TraceEvent
 * @property {string} name
 * @property {number} pid
 * @property {number} tid
 * @property {number} ts Microseconds.
 * @property {number} [dur]
 * @property {number} [tdur] Time on the processor, microseconds.
 * @property {{ name?: string, data?: { type?: string } }} [args]
 */

/** Events that run scripts. Scripts within one are part of it. */
const SCRIPTS = ['EventDispatch', 'FireAnimationFrame', 'TimerFire', 'FunctionCall', 'RunMicrotasks'];

/**
 * Milliseconds of script that each move of the pointer takes, up to the next one or to the end of the press. It is time
 * on the processor. That includes uploads of buffers, and calls of WebGL as far as they pass
 * commands on. Another process draws. Waiting for it takes no time on the processor.
 * @param {import('@playwright/test').Browser} browser
 * @param {import('@playwright/test').Page} page
 * @param {() => Promise<void>} moves
 * @returns {Promise<{ main: number[], workers: number[] }>} One number for each move.
 */
export async function scriptTimes(browser, page, moves) {
  await browser.startTracing(page, { categories: ['devtools.timeline', 'v8.execute', '__metadata'] });
  await moves();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  return timesOf(traceEvents);
}

/** @param {readonly TraceEvent[]} events */
export function timesOf(events) {
  const dispatched = (/** @type {string} */ type) =>
    events
      .filter(({ name, args }) => name === 'EventDispatch' && args?.data?.type === type)
      .sort((a, b) => a.ts - b.ts);
  const end = dispatched('pointerup')[0]?.ts ?? Infinity;
  const begin = dispatched('pointerdown')[0]?.ts ?? 0;
  const begun = dispatched('pointermove').filter(({ ts }) => ts > begin && ts < end);
  const [first] = begun;
  if (!first) throw new Error('the trace contains no pointer move');
  /** @type {Map<string, TraceEvent[]>} */
  const threads = new Map();
  for (const event of events) {
    if (event.pid !== first.pid || event.tdur === undefined || !SCRIPTS.includes(event.name)) continue;
    const thread = event.tid === first.tid ? 'main' : 'workers';
    const key = `${thread} ${event.tid}`;
    threads.set(key, [...(threads.get(key) ?? []), event]);
  }
  const times = { main: begun.map(() => 0), workers: begun.map(() => 0) };
  for (const [key, scripts] of threads) {
    const own = key.startsWith('main') ? times.main : times.workers;
    for (const { ts, tdur = 0 } of outermost(scripts)) {
      const move = ts < end ? begun.findLastIndex((event) => event.ts <= ts) : -1;
      if (move >= 0) own[move] = (own[move] ?? 0) + tdur / 1000;
    }
  }
  return times;
}

/** @param {readonly TraceEvent[]} events of one thread. */
function outermost(events) {
  let end = 0;
  return [...events]
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0))
    .filter(({ ts, dur = 0 }) => {
      if (ts < end) return false;
      end = ts + dur;
      return true;
    });
}

/** @param {readonly number[]} times @param {number} share From 0 to 1. */
export const quantile = (times, share) =>
  [...times].sort((a, b) => a - b)[Math.min(times.length - 1, Math.floor(share * times.length))] ?? 0;
