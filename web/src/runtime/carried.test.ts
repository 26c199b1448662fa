import { describe, expect, it } from 'vitest';
import { splitProject } from './carried';

const project = (src: unknown) => JSON.stringify({ format: 'c2warp/1', image: { src, width: 4, height: 3 } });

describe('a project that holds its picture', () => {
  it('is split into both', async () => {
    const { text, picture } = splitProject(project('data:image/png;name=my%20cat.png;base64,AAEC'));
    expect(text).toBe(project('my cat.png'));
    expect(picture).toMatchObject({ name: 'my cat.png', file: { size: 3, type: 'image/png' } });
    const file = picture?.file as Blob;
    expect([...new Uint8Array(await file.arrayBuffer())]).toEqual([0, 1, 2]);
  });

  it('may leave the name out', () => {
    const { text, picture } = splitProject(project('data:image/webp;base64,AAEC'));
    expect(text).toBe(project('picture.png'));
    expect(picture?.file.type).toBe('image/webp');
  });

  it('is refused if the picture is damaged', () => {
    expect(() => splitProject(project('data:image/png;base64,A*'))).toThrow(
      'The picture in the address is damaged',
    );
  });
});

describe('any other text', () => {
  it('stays as it is', () => {
    for (const text of ['', '{', 'null', '[]', project('cat.png'), project(7)])
      expect(splitProject(text)).toEqual({ text, picture: null });
  });
});
