import { describe, expect, it } from 'vitest';
import { addressIn, addressInList, nameIn, namesProject, pictureInHtml } from './address';

describe('an address in a text', () => {
  it('is the whole text', () => {
    expect(addressIn(' https://example.org/cat.png?size=2\n')).toBe('https://example.org/cat.png?size=2');
    expect(addressIn('HTTP://example.org')).toBe('HTTP://example.org');
    expect(addressIn('data:image/png;base64,AAAA')).toBe('data:image/png;base64,AAAA');
  });

  it('is no other text', () => {
    for (const text of [
      '',
      'cat.png',
      'see https://example.org/cat.png',
      'https://',
      'data:text/html,hi',
      'file:///a.png',
    ])
      expect(addressIn(text), text).toBeNull();
  });
});

describe('a picture in HTML', () => {
  it('is the first image with an address', () => {
    expect(pictureInHtml('<meta><p>A <img alt="x" src="https://a.org/cat.png"></p>')).toBe(
      'https://a.org/cat.png',
    );
    expect(pictureInHtml("<IMG\nwidth=3 SRC='https://a.org/?a=1&amp;b=2'>")).toBe('https://a.org/?a=1&b=2');
    expect(pictureInHtml('<img src=https://a.org/b.png><img src=https://a.org/c.png>')).toBe(
      'https://a.org/b.png',
    );
    expect(pictureInHtml('<img src="cid:1"><img src="data:image/gif;base64,R0=">')).toBe(
      'data:image/gif;base64,R0=',
    );
  });

  it('is missing without an image', () => {
    expect(
      pictureInHtml('<a href="https://a.org/cat.png">cat</a><imgage src="https://a.org/b.png">'),
    ).toBeNull();
    expect(pictureInHtml('<img data-src="https://a.org/cat.png">')).toBeNull();
  });
});

describe('a list of addresses', () => {
  it('begins behind its comments', () => {
    expect(addressInList('# from a page\r\nhttps://a.org/cat.png\r\nhttps://a.org/dog.png')).toBe(
      'https://a.org/cat.png',
    );
    expect(addressInList('# nothing')).toBeNull();
  });
});

describe('the name in an address', () => {
  it('is its last part', () => {
    expect(nameIn('https://a.org/b/big%20cat.png?x=/y#z')).toBe('big cat.png');
    expect(nameIn('https://a.org/')).toBe('a.org');
    expect(nameIn('https://a.org/50%.png')).toBe('50%.png');
    expect(nameIn('data:image/png;base64,AAAA')).toBe('picture');
  });

  it('recognises projects', () => {
    expect(namesProject('https://a.org/cat.c2warp.json?v=2')).toBe(true);
    expect(namesProject('https://a.org/cat.png?pose.json')).toBe(false);
  });
});
