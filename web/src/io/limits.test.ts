import { describe, expect, it } from 'vitest';
import { checkSize } from './limits';

describe('checkSize', () => {
  it('lets pass what can be opened', () => {
    expect(() => checkSize(2, 2)).not.toThrow();
    expect(() => checkSize(16_384, 6000)).not.toThrow();
  });

  it('names the size and the limit', () => {
    expect(() => checkSize(1, 1)).toThrow('The picture has 1 × 1 px; at least 2 × 2 are needed to bend it.');
    expect(() => checkSize(20_000, 20)).toThrow('20000 × 20 px; a side may have 16,384 px at most.');
    expect(() => checkSize(12_000, 12_000)).toThrow('100 million pixels are the most');
  });
});
