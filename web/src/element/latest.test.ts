import { describe, expect, it } from 'vitest';
import { LatestRequest, unlessAborted } from './latest';

const aborted = { name: 'AbortError' };

describe('the latest request', () => {
  it('lets through what comes while it lasts', async () => {
    const signal = new LatestRequest().next();
    expect(await unlessAborted(signal, Promise.resolve(7))).toBe(7);
    await expect(unlessAborted(signal, Promise.reject(new RangeError('wide')))).rejects.toThrow('wide');
  });

  it('ends with the next one, whatever comes of its work', async () => {
    const requests = new LatestRequest();
    const [older, newer] = [requests.next(), requests.next()];
    await expect(unlessAborted(older, Promise.resolve(7))).rejects.toMatchObject(aborted);
    await expect(unlessAborted(older, Promise.reject(new RangeError('wide')))).rejects.toMatchObject(aborted);
    expect(older.aborted).toBe(true);
    expect(await unlessAborted(newer, Promise.resolve(8))).toBe(8);
  });

  it('is over from the first once no more are taken', () => {
    const requests = new LatestRequest();
    const last = requests.next();
    requests.close();
    expect(() => last.throwIfAborted()).toThrow(expect.objectContaining(aborted));
    expect(() => requests.next().throwIfAborted()).toThrow(expect.objectContaining(aborted));
  });
});
