import { afterEach, describe, expect, it, vi } from 'vitest';
import { C2WarpError } from '../error';
import { Link, type Port } from './link';
import type { Boot, Extension, Reply, Request } from './messages';

class FakeWorker implements Port {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  readonly received: (Boot | Extension | Request)[] = [];
  ended = false;

  postMessage(message: Boot | Extension | Request): void {
    this.received.push(message);
  }

  terminate(): void {
    this.ended = true;
  }

  reply(reply: Reply): void {
    this.onmessage?.(new MessageEvent('message', { data: reply }));
  }

  requests(): Request[] {
    return this.received.filter((message) => 'name' in message);
  }
}

const LATER = {} as WebAssembly.Module;
const PICTURE = { width: 2, height: 2, sendTo: () => {} };
const BORDERS = { corners: new Uint32Array(), barycentric: new Float32Array() };

function linked() {
  const workers: FakeWorker[] = [];
  const link = new Link(
    () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker;
    },
    {} as WebAssembly.Module,
    async () => LATER,
    'https://c2warp.example/worker.js',
  );
  const worker = (index: number) => {
    const found = workers[index];
    if (!found) throw new Error(`there is no worker ${index}`);
    return found;
  };
  return { link, worker, workers };
}

describe('Link', () => {
  afterEach(() => void vi.useRealTimers());

  it('gives each request its own answer', async () => {
    const { link, worker } = linked();
    const first = link.send('picture', PICTURE);
    const second = link.send('cells', { project: '{}' });
    worker(0).reply({ id: 2, kind: 'done', body: BORDERS });
    worker(0).reply({ id: 1, kind: 'done', body: null });
    expect(await first).toBeNull();
    expect(await second).toBe(BORDERS);
  });

  it('passes on the code and the message of a failure, and the handles that it names', async () => {
    const { link, worker } = linked();
    const failure = { code: 'handle-outside', message: 'outside', handles: ['head'] } as const;
    const solve = link.send('solve', { project: '{}' });
    worker(0).reply({ id: 1, kind: 'failed', failure });
    await expect(solve).rejects.toMatchObject(failure);
    await expect(solve).rejects.toBeInstanceOf(C2WarpError);
  });

  it('ends a long-running worker only for a newer request', async () => {
    vi.useFakeTimers({ toFake: ['performance'] });
    const { link, worker, workers } = linked();
    void link.send('picture', PICTURE).catch(() => {});
    worker(0).reply({ id: 1, kind: 'done', body: null });
    const abandonAfter = async (ms: number) => {
      const solve = link.send('solve', { project: '{}' });
      vi.advanceTimersByTime(ms);
      link.abandon('solve');
      await expect(solve).rejects.toMatchObject({ name: 'AbortError' });
    };
    await abandonAfter(900);
    expect(worker(0).ended).toBe(false);
    const other = link.send('cells', { project: '{}' });
    await abandonAfter(1100);
    expect(worker(0).ended).toBe(false);
    worker(0).reply({ id: 3, kind: 'done', body: BORDERS });
    await other;
    await abandonAfter(1100);
    expect(worker(0).ended).toBe(true);
    void link.send('solve', { project: '{}' }).catch(() => {});
    expect(workers).toHaveLength(2);
    expect(
      worker(1)
        .requests()
        .map(({ name }) => name),
    ).toEqual(['picture', 'solve']);
    link.dispose();
  });

  it('asks the source of a picture to send the pixels to each worker', () => {
    const { link, worker } = linked();
    const ports: MessagePort[] = [];
    void link.send('picture', { ...PICTURE, sendTo: (port) => ports.push(port) });
    void link.send('solve', { project: '{}' });
    worker(0).reply({ kind: 'died', started: false, message: 'unreachable' });
    expect(worker(1).requests()).toHaveLength(2);
    expect(new Set(ports).size).toBe(2);
    for (const port of ports) port.close();
  });

  it('ignores results of an abandoned request', async () => {
    const { link, worker } = linked();
    const solve = link.send('solve', { project: '{}' });
    link.abandon('solve');
    worker(0).reply({ id: 1, kind: 'progress', stage: 'domain' });
    await expect(solve).rejects.toMatchObject({ name: 'AbortError' });
  });

  it('asks the successor of a dead worker once more, after the picture', async () => {
    const { link, worker } = linked();
    void link.send('picture', PICTURE);
    worker(0).reply({ id: 1, kind: 'done', body: null });
    const cells = link.send('cells', { project: '{}' });
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    expect(worker(0).ended).toBe(true);
    expect(worker(1).requests()).toEqual([
      { id: 0, name: 'picture', body: { width: 2, height: 2, pixels: expect.any(MessagePort) } },
      { id: 2, name: 'cells', body: { project: '{}' } },
    ]);
    worker(1).reply({ id: 2, kind: 'done', body: BORDERS });
    expect(await cells).toBe(BORDERS);
  });

  it('rejects each request for a lost picture, if its successor cannot have it', async () => {
    const { link, worker, workers } = linked();
    void link.send('picture', PICTURE);
    worker(0).reply({ id: 1, kind: 'done', body: null });
    const failure = { code: 'picture', message: 'the pixels are gone', handles: [] } as const;
    for (const successor of [1, 2]) {
      const cells = link.send('cells', { project: '{}' });
      if (successor === 1) worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
      worker(successor).reply({ id: 0, kind: 'failed', failure });
      await expect(cells).rejects.toMatchObject({ code: 'picture' });
      expect(worker(successor).ended).toBe(true);
    }
    expect(workers).toHaveLength(3);

    const again = link.send('picture', PICTURE);
    expect(worker(3).requests()).toHaveLength(1);
    worker(3).reply({ id: 4, kind: 'done', body: null });
    expect(await again).toBeNull();
  });

  it('sends the next picture to a successor that cannot have the last one', async () => {
    const { link, worker } = linked();
    void link.send('picture', PICTURE);
    worker(0).reply({ id: 1, kind: 'done', body: null });
    const cells = link.send('cells', { project: '{}' });
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    const next = link.send('picture', PICTURE);
    const failure = { code: 'picture', message: 'the pixels are gone', handles: [] } as const;
    worker(1).reply({ id: 0, kind: 'failed', failure });
    await expect(cells).rejects.toMatchObject({ code: 'picture' });
    worker(1).reply({ id: 3, kind: 'done', body: null });
    expect(await next).toBeNull();
  });

  it('gives up a request that ends two workers, and serves the next by a third', async () => {
    const { link, worker, workers } = linked();
    const solve = link.send('solve', { project: 'bad' });
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    worker(1).reply({ kind: 'died', started: true, message: 'unreachable' });
    await expect(solve).rejects.toMatchObject({ code: 'too-much' });
    // No words of the browser reach a person.
    await expect(solve).rejects.toThrow(
      'Not enough memory for this warp. Use fewer handles, or less detail.',
    );
    expect(workers).toHaveLength(2);
    void link.send('cells', { project: 'good' });
    expect(worker(2).requests()).toHaveLength(1);
  });

  it('blames no request for a worker that never started', async () => {
    const { link, worker } = linked();
    const solve = link.send('solve', { project: 'good' });
    worker(0).reply({ kind: 'died', started: false, message: 'CompileError: bad magic' });
    worker(1).reply({ kind: 'died', started: false, message: 'CompileError: bad magic' });
    await expect(solve).rejects.toMatchObject({ code: 'engine', cause: 'CompileError: bad magic' });
    await expect(solve).rejects.toThrow('Check that https://c2warp.example/worker.js exists');
  });

  it('does not restart for a picture that nobody asks about any more', () => {
    const { link, worker, workers } = linked();
    link.send('picture', PICTURE).catch(() => {});
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    worker(1).reply({ kind: 'died', started: true, message: 'unreachable' });
    expect(workers).toHaveLength(2);
  });

  it('rejects a message that cannot be sent, and does not resend it', async () => {
    const { link, worker } = linked();
    const refused = new Error('out of memory');
    worker(0).postMessage = () => {
      throw refused;
    };
    await expect(link.send('picture', PICTURE)).rejects.toBe(refused);
    const { postMessage } = FakeWorker.prototype;
    worker(0).postMessage = postMessage;
    const solve = link.send('solve', { project: '{}' });
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    expect(
      worker(1)
        .requests()
        .map(({ name }) => name),
    ).toEqual(['solve']);
    link.dispose();
    await expect(solve).rejects.toMatchObject({ name: 'AbortError' });
  });

  it('gives the later part of the module to each worker, once', async () => {
    const { link, worker } = linked();
    await Promise.all([link.extend(), link.extend()]);
    const parts = () => [0, 1].map((at) => worker(at).received.filter((message) => 'later' in message));
    link.send('cells', { project: '{}' });
    worker(0).reply({ kind: 'died', started: true, message: 'unreachable' });
    expect(parts()).toEqual([[{ later: LATER }], [{ later: LATER }]]);
  });

  it('rejects pending requests when disposed of, and starts no other worker', async () => {
    const { link, worker, workers } = linked();
    const solve = link.send('solve', { project: '{}' });
    link.dispose();
    expect(worker(0).ended).toBe(true);
    await expect(solve).rejects.toMatchObject({ name: 'AbortError' });
    await expect(link.send('solve', { project: '{}' })).rejects.toMatchObject({ name: 'AbortError' });
    expect(workers).toHaveLength(1);
  });
});
