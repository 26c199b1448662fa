import { describe, expect, it } from 'vitest';

describe('the element', () => {
  // All modules are compiled first, which takes long on a loaded machine.
  it('can be imported without a DOM', async () => {
    expect(typeof customElements).toBe('undefined');
    const { C2Warp } = await import('./element');
    expect(C2Warp.name).toBe('C2Warp');
  }, 60_000);
});
