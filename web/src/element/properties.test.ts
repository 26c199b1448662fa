import { describe, expect, it } from 'vitest';
import { attributeOf, propertiesByAttribute, textOf, valueFrom } from './properties';

const PROPERTIES = {
  hintFor: { attribute: 'hint-for' },
  autoPlay: { type: Boolean, reflect: true },
  samples: { attribute: false },
} as const;

describe('properties', () => {
  it('have an attribute of their own name unless they say otherwise', () => {
    expect([...propertiesByAttribute(PROPERTIES)]).toEqual([
      ['hint-for', 'hintFor'],
      ['autoplay', 'autoPlay'],
    ]);
    expect(attributeOf(PROPERTIES, 'samples')).toBeNull();
  });

  it('of a boolean are true while the attribute is present', () => {
    const { autoPlay, hintFor } = PROPERTIES;
    expect([valueFrom(autoPlay, ''), valueFrom(autoPlay, null)]).toEqual([true, false]);
    expect([textOf(autoPlay, true), textOf(autoPlay, undefined)]).toEqual(['', null]);
    expect([valueFrom(hintFor, 'head'), valueFrom(hintFor, null)]).toEqual(['head', null]);
    expect([textOf(hintFor, 'head'), textOf(hintFor, undefined)]).toEqual(['head', null]);
  });
});
