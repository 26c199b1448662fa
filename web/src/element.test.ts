import { describe, expect, it } from 'vitest';

describe('the element', () => {
  it('can be imported where there is no DOM', async () => {
    expect(typeof customElements).toBe('undefined');
    const { C2Warp } = await import('./element');
    expect(C2Warp.name).toBe('C2Warp');
  });
});
