import { describe, expect, it } from 'vitest';
import { nextTask, Queue } from './queue';

describe('Queue', () => {
  it('handles one request at a time, in order', async () => {
    const log: string[] = [];
    const queue = new Queue<string>(async (request) => {
      log.push(`begin ${request}`);
      await nextTask();
      log.push(`end ${request}`);
    });
    queue.push('a');
    queue.push('b');
    for (let i = 0; i < 8; i++) await nextTask();
    expect(log).toEqual(['begin a', 'end a', 'begin b', 'end b']);
  });

  it('shows newer requests to a paused request', async () => {
    const seen: boolean[] = [];
    const queue = new Queue<string>(async () => {
      seen.push(queue.waits((request) => request === 'newer'));
      await nextTask();
      seen.push(queue.waits((request) => request === 'newer'));
    });
    queue.push('older');
    await nextTask();
    await Promise.resolve();
    queue.push('newer');
    for (let i = 0; i < 6; i++) await nextTask();
    expect(seen).toEqual([false, true, false, false]);
  });
});
