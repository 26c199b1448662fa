import { describe, expect, it } from 'vitest';
import { attributeOf, isUnknown, propertiesByAttribute, textOf, valueFrom } from './properties';

const PROPERTIES = {
  hintFor: { attribute: 'hint-for' },
  autoPlay: { kind: 'flag' },
  src: { kind: 'address' },
  features: { kind: 'optional' },
  theme: { words: ['light', 'dark', 'auto'], initial: 'auto' },
  crossOrigin: { words: ['anonymous', 'use-credentials'], invalid: 'anonymous' },
  samples: { attribute: false, initial: [] },
} as const;

const BASE = 'https://example.org/a/page.html';

describe('properties', () => {
  it('have an attribute of their own name unless they say otherwise', () => {
    const names = propertiesByAttribute(PROPERTIES);
    expect([names.get('hint-for'), names.get('autoplay'), names.has('samples')]).toEqual([
      'hintFor',
      'autoPlay',
      false,
    ]);
    expect(attributeOf(PROPERTIES, 'samples')).toBeNull();
  });

  it.each([
    ['hintFor', [null, ''], ['', ''], ['head', 'head']],
    ['autoPlay', [null, false], ['', true], ['false', true]],
    ['features', [null, null], ['', ''], ['open', 'open']],
    ['src', [null, ''], ['', ''], ['b.png', 'https://example.org/a/b.png'], ['http://[', 'http://[']],
    ['theme', [null, 'auto'], ['', 'auto'], ['DARK', 'dark'], ['blue', 'auto']],
    [
      'crossOrigin',
      [null, null],
      ['', 'anonymous'],
      ['use-credentials', 'use-credentials'],
      ['x', 'anonymous'],
    ],
  ] as const)('of an attribute such as that of %s reflect as in HTML', (name, ...values) => {
    for (const [text, value] of values as readonly (readonly [string | null, unknown])[])
      expect(valueFrom(PROPERTIES[name], text, BASE)).toBe(value);
  });

  it('without a value have no attribute', () => {
    const { autoPlay, hintFor, theme } = PROPERTIES;
    expect([textOf(autoPlay, true), textOf(autoPlay, undefined)]).toEqual(['', null]);
    expect([textOf(hintFor, 'head'), textOf(hintFor, undefined), textOf(theme, null)]).toEqual([
      'head',
      null,
      null,
    ]);
  });

  it('have words, and no others', () => {
    const { crossOrigin, hintFor, theme } = PROPERTIES;
    expect([isUnknown(theme, 'Dark'), isUnknown(theme, 'blue'), isUnknown(theme, '')]).toEqual([
      false,
      true,
      true,
    ]);
    expect([isUnknown(crossOrigin, ''), isUnknown(crossOrigin, 'x'), isUnknown(hintFor, 'x')]).toEqual([
      false,
      true,
      false,
    ]);
  });
});
