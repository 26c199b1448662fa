import { describe, expect, it } from 'vitest';
import { hashOf, MOST, projectIn } from './shared_rig';

const PROJECT = { format: 'c2warp/1', handles: [{ id: 'Pfötchen', kind: 'point', rest: [1, 2] }] };

describe('a rig in an address', () => {
  it('comes back', async () => {
    const hash = await hashOf(PROJECT);
    expect(hash).toMatch(/^#rig=[\w-]+$/);
    expect(await projectIn(hash)).toEqual(PROJECT);
  });

  it('is not read from other hashes', async () => {
    expect(await projectIn('')).toBeUndefined();
    expect(await projectIn('#playground')).toBeUndefined();
  });

  it('is refused if the address is damaged', async () => {
    const hash = await hashOf(PROJECT);
    await expect(projectIn(hash.slice(0, -9))).rejects.toThrow('damaged');
    await expect(projectIn('#rig=%')).rejects.toThrow('damaged');
    await expect(projectIn('#rig=')).rejects.toThrow('damaged');
  });

  it('is refused if it is too large', async () => {
    const random = Array.from({ length: 20_000 }, (_, k) => (k * 7919) ** 3 % 1_000_003);
    await expect(hashOf(random)).rejects.toThrow('too large');
    await expect(projectIn(`#rig=${'A'.repeat(MOST.characters)}`)).rejects.toThrow('too long');
    await expect(projectIn(await hashOf(' '.repeat(MOST.bytes)))).rejects.toThrow('too large');
  });
});
