import { beforeEach, describe, expect, it, vi } from 'vitest';
import { startWorker } from './start_worker';

const PAGE = 'https://page.example/a/';

describe('startWorker', () => {
  const started = vi.fn();

  beforeEach(() => {
    started.mockReset();
    vi.stubGlobal('document', { baseURI: PAGE });
    vi.stubGlobal('origin', 'https://page.example');
    vi.stubGlobal('window', {});
    vi.stubGlobal(
      'Worker',
      class {
        constructor(address: string, options?: WorkerOptions) {
          started(address, options?.type);
        }
      },
    );
  });

  it('starts modules of the page’s origin, by relative URLs too', () => {
    startWorker('b/worker.js');
    expect(started).toHaveBeenCalledWith(`${PAGE}b/worker.js`, 'module');
  });

  it('starts modules of other origins through an importing script', async () => {
    startWorker('https://cdn.example/worker.js');
    const [address] = started.mock.calls[0] ?? [];
    expect(await (await fetch(address)).text()).toContain('import("https://cdn.example/worker.js")');
  });
});
