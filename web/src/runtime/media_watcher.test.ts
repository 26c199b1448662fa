import { afterEach, describe, expect, it, vi } from 'vitest';
import { MediaWatcher } from './media_watcher';

afterEach(() => vi.unstubAllGlobals());

describe('the media watcher', () => {
  it('reports each change until it is disposed', () => {
    const queries = new Map<string, EventTarget>();
    vi.stubGlobal('matchMedia', (query: string) => {
      const list = queries.get(query) ?? new EventTarget();
      queries.set(query, list);
      return list;
    });
    const changes = (query: string) => queries.get(query)?.dispatchEvent(new Event('change'));
    const heard: string[] = [];
    vi.stubGlobal('devicePixelRatio', 1);
    const watcher = new MediaWatcher({
      schemeChanged: () => heard.push('coloured'),
      pixelRatioChanged: () => heard.push(`scaled to ${devicePixelRatio}`),
    });
    changes('(prefers-color-scheme: dark)');
    vi.stubGlobal('devicePixelRatio', 2);
    changes('(resolution: 1dppx)');
    vi.stubGlobal('devicePixelRatio', 1.5);
    changes('(resolution: 2dppx)');
    changes('(resolution: 1dppx)');
    expect(heard).toEqual(['coloured', 'scaled to 2', 'scaled to 1.5']);
    watcher.dispose();
    changes('(prefers-color-scheme: dark)');
    changes('(resolution: 1.5dppx)');
    expect(heard).toHaveLength(3);
  });
});
