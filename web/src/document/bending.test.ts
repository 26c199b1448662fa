import { describe, expect, it } from 'vitest';
import { detailOf, modeOf, withDetail, withMode } from './bending';
import { newProject } from './document';
import type { PointHandle, Project } from './project';

const point = (id: string, rotation?: PointHandle['rotation']): PointHandle => ({
  id,
  kind: 'point',
  rest: [id.charCodeAt(0), 0],
  posed: [9, 9],
  ...(rotation === undefined ? {} : { rotation }),
});

const rotations = ({ handles }: Project) => handles.map(({ rotation }) => rotation);

const fresh = newProject({ src: 'a.png', width: 8, height: 8 }, null);

describe('the mode of bending', () => {
  it('of a new project is rigid, with smooth supports and 150 virtual sites', () => {
    expect(fresh.pose).toEqual({ mode: 'rigid', blend: 'linear', density: 150 });
    expect(fresh.weighting?.support).toBe('smooth');
    expect(withMode(withMode(fresh, 'harmonic'), 'rigid')).toEqual(fresh);
  });

  it('harmonic has the supports of the paper and no virtual sites', () => {
    const handles = [point('a', 'auto'), point('b', 30)];
    const project = withMode({ ...fresh, handles }, 'harmonic');
    expect(project.pose).toEqual({ mode: 'harmonic', blend: 'linear', density: 0 });
    expect(project.weighting).toEqual({ ...fresh.weighting, support: 'paper' });
    expect(project.handles.map(({ rotation }) => rotation)).toEqual([0, 30]);
  });

  it('rigid makes unturned points automatic and keeps the others', () => {
    const handed = { ...fresh, handles: [point('a'), point('b', 0), point('c', 30)] };
    const { handles } = withMode(handed, 'rigid');
    expect(handles.map(({ rotation, posed }) => [rotation, posed])).toEqual([
      ['auto', [9, 9]],
      ['auto', [9, 9]],
      [30, [9, 9]],
    ]);
  });

  it('harmonic keeps the turns that automatic points show', () => {
    const handles = [point('a', 'auto'), point('b', 'auto'), point('c', 0)];
    const turns = new Map([
      ['a', -63.25],
      ['c', 5],
    ]);
    expect(rotations(withMode({ ...fresh, handles }, 'harmonic', turns))).toEqual([-63.25, 0, 0]);
  });

  it('has its last detail and automatic points when it is chosen again', () => {
    const before = withDetail({ ...fresh, handles: [point('a', 0), point('b', 'auto')] }, 'fine');
    const after = withMode(before, 'harmonic', new Map([['b', -63]]));
    expect(rotations(after)).toEqual([0, -63]);
    const added = { ...after, handles: [...after.handles, point('c', 0)] };
    const back = withMode(added, 'rigid', undefined, { before, after });
    expect(detailOf(back)).toBe('fine');
    expect(rotations(back)).toEqual([0, 'auto', 'auto']);
    // Points that were turned in the other mode keep their turn.
    const turned = { ...after, handles: [point('a', 12), point('b', -60)] };
    expect(rotations(withMode(turned, 'rigid', undefined, { before, after }))).toEqual([12, -60]);
  });

  it('is harmonic by default', () => {
    const { pose: _, ...bare }: Project = fresh;
    expect(modeOf(bare)).toBe('harmonic');
    expect(detailOf(bare)).toBeNull();
  });

  it('has a named detail', () => {
    expect(detailOf(fresh)).toBe('medium');
    expect(withDetail(fresh, 'fine').pose).toEqual({ ...fresh.pose, density: 200 });
    expect(detailOf(withDetail(fresh, 'coarse'))).toBe('coarse');
  });
});
