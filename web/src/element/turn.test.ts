import { describe, expect, it } from 'vitest';
import { Turns } from './turn';

const aborted = { name: 'AbortError' };

describe('a turn', () => {
  it('lets through what comes while it lasts', async () => {
    const turn = new Turns().take();
    expect(await turn.through(Promise.resolve(7))).toBe(7);
    await expect(turn.through(Promise.reject(new RangeError('wide')))).rejects.toThrow('wide');
  });

  it('ends with the next one, whatever comes of its work', async () => {
    const turns = new Turns();
    const [older, newer] = [turns.take(), turns.take()];
    await expect(older.through(Promise.resolve(7))).rejects.toMatchObject(aborted);
    await expect(older.through(Promise.reject(new RangeError('wide')))).rejects.toMatchObject(aborted);
    expect(older.signal.aborted).toBe(true);
    expect(await newer.through(Promise.resolve(8))).toBe(8);
  });

  it('is over from the first where no more are given', () => {
    const turns = new Turns();
    const last = turns.take();
    turns.close();
    expect(() => last.check()).toThrow(expect.objectContaining(aborted));
    expect(() => turns.take().check()).toThrow(expect.objectContaining(aborted));
  });
});
