import { createElement } from 'react';
import { renderToString } from 'react-dom/server';
import { describe, expect, it } from 'vitest';
import { C2Warp } from './react';

describe('the component for React', () => {
  it('is a tag with its children on a server: properties wait for a page', () => {
    const text = createElement('p', null, 'A cat');
    const props = { src: 'cat.png', readonly: true, onChange: () => {}, className: 'wide', id: 'cat' };
    expect(renderToString(createElement(C2Warp, props, text))).toBe(
      '<c2-warp class="wide" id="cat"><p>A cat</p></c2-warp>',
    );
  });
});
