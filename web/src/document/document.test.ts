import { describe, expect, it } from 'vitest';
import { newProject } from './document';

describe('a new project', () => {
  const image = { src: 'a.jpg', width: 400, height: 300 };

  it('holds the boundary of an opaque picture', () => {
    expect(newProject(image, null)).toMatchObject({ domain: { kind: 'image' }, fix_boundary: true });
  });
  it('leaves the boundary of a picture with transparency free', () => {
    expect(newProject(image, 0.5)).toMatchObject({ domain: { kind: 'alpha' }, fix_boundary: false });
  });
});
