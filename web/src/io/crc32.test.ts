import { describe, expect, it } from 'vitest';
import { crc32 } from './crc32';

describe('the checksum', () => {
  it('is that of the catalogue, and of the last chunk of every PNG', () => {
    expect(crc32(new TextEncoder().encode('123456789'))).toBe(0xcbf43926);
    expect(crc32(new TextEncoder().encode('IEND'))).toBe(0xae426082);
  });
});
