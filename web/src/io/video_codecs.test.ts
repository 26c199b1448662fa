import { describe, expect, it } from 'vitest';
import { codedShape, configsOf } from './video_codecs';

describe('codecs of films', () => {
  it('name the least level that holds size and rate', () => {
    const hd = { width: 1920, height: 1080, rate: 30 };
    expect(configsOf('vp9', hd)).toEqual(['vp09.00.40.08']);
    expect(configsOf('vp9', { ...hd, rate: 60 })).toEqual(['vp09.00.41.08']);
    expect(configsOf('av1', hd)).toEqual(['av01.0.08M.08']);
    expect(configsOf('avc', hd)).toEqual(['avc1.640028', 'avc1.4d0028', 'avc1.42e028']);
    expect(configsOf('avc', { width: 64, height: 64, rate: 30 })[0]).toBe('avc1.64001e');
    // Beyond all levels, the browser decides.
    expect(configsOf('avc', { width: 16_000, height: 16_000, rate: 60 })[0]).toBe('avc1.64003e');
  });

  it('have even sides where the codec needs them', () => {
    const odd = { width: 123, height: 154, rate: 10 };
    expect(codedShape('avc', odd)).toEqual({ width: 124, height: 154, rate: 10 });
    expect(codedShape('vp9', odd)).toEqual(odd);
  });
});
