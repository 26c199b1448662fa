import { afterEach, describe, expect, it, vi } from 'vitest';
import { Surroundings } from './surroundings';

afterEach(() => vi.unstubAllGlobals());

describe('what surrounds the editor', () => {
  it('is told of at every change, until it is released', () => {
    const queries = new Map<string, EventTarget>();
    vi.stubGlobal('matchMedia', (query: string) => {
      const list = queries.get(query) ?? new EventTarget();
      queries.set(query, list);
      return list;
    });
    const changes = (query: string) => queries.get(query)?.dispatchEvent(new Event('change'));
    const heard: string[] = [];
    vi.stubGlobal('devicePixelRatio', 1);
    const surroundings = new Surroundings({
      coloured: () => heard.push('coloured'),
      scaled: () => heard.push(`scaled to ${devicePixelRatio}`),
    });
    changes('(prefers-color-scheme: dark)');
    vi.stubGlobal('devicePixelRatio', 2);
    changes('(resolution: 1dppx)');
    vi.stubGlobal('devicePixelRatio', 1.5);
    changes('(resolution: 2dppx)');
    changes('(resolution: 1dppx)');
    expect(heard).toEqual(['coloured', 'scaled to 2', 'scaled to 1.5']);
    surroundings.release();
    changes('(prefers-color-scheme: dark)');
    changes('(resolution: 1.5dppx)');
    expect(heard).toHaveLength(3);
  });
});
