import { describe, expect, it } from 'vitest';
import { dataFile, fetchFile, fileName } from './address';

describe('fileName', () => {
  it('returns the last part of the address', () => {
    expect(fileName('https://a.example/b/my%20cat.png?large#top')).toBe('my cat.png');
    expect(fileName('100%.png')).toBe('100%.png');
  });

  it('ignores the content of data and blob addresses', () => {
    expect(fileName('data:image/png;base64,iVBO/Rw0K')).toBe('picture.png');
    expect(fileName('blob:https://a.example/4fdb')).toBe('picture.png');
  });
});

describe('fetchFile', () => {
  it('rejects with a code if the file cannot be loaded', async () => {
    const options = { signal: new AbortController().signal, credentials: 'same-origin' } as const;
    await expect(fetchFile('data:,hello', options).then((file) => file.text())).resolves.toBe('hello');
    await expect(fetchFile('nowhere:/cat.png', options)).rejects.toMatchObject({
      code: 'address',
      message: expect.stringContaining('Could not load cat.png'),
    });
  });

  it('decodes data addresses without a request', async () => {
    const file = dataFile('data:image/png;name=cat.png;base64,AAEC');
    expect([file.type, ...new Uint8Array(await file.arrayBuffer())]).toEqual(['image/png', 0, 1, 2]);
    expect(await dataFile('data:,a%20b').text()).toBe('a b');
    expect(() => dataFile('data:image/png;base64,A*')).toThrow('The picture in the address is damaged');
  });
});
