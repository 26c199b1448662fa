/** Random choices with a fixed seed, for tests: the same sequence in every run. */

/** A small generator (mulberry32) of numbers in [0, 1). */
export function randomOf(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export const among = <T>(list: readonly T[], random: () => number): T =>
  list[Math.floor(random() * list.length)] as T;
