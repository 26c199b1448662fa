import { describe, expect, it } from 'vitest';
import { checkSize } from './limits';

describe('checkSize', () => {
  it('accepts supported sizes', () => {
    expect(() => checkSize(2, 2)).not.toThrow();
    expect(() => checkSize(16_384, 6000)).not.toThrow();
  });

  it('names the size and the limit', () => {
    expect(() => checkSize(1, 1)).toThrow('The picture is 1 × 1 px. It must be at least 2 × 2 px.');
    expect(() => checkSize(20_000, 20)).toThrow('20000 × 20 px. Each side can be at most 16,384 px');
    expect(() => checkSize(12_000, 12_000)).toThrow('at most 100 million pixels');
  });
});
