import { describe, expect, it } from 'vitest';
import { detailOf, modeOf, withDetail, withMode } from './bending';
import { newProject } from './document';
import type { PointHandle, Project } from './project';

const point = (id: string, rotation?: PointHandle['rotation']): PointHandle => ({
  id,
  kind: 'point',
  rest: [0, 0],
  posed: [9, 9],
  ...(rotation === undefined ? {} : { rotation }),
});

const fresh = newProject({ src: 'a.png', width: 8, height: 8 }, null);

describe('how a picture bends', () => {
  it('is rigid in a new project, with smooth supports and 30 virtual sites', () => {
    expect(fresh.pose).toEqual({ mode: 'rigid', blend: 'linear', density: 100 });
    expect(fresh.weighting?.support).toBe('smooth');
    expect(withMode(withMode(fresh, 'harmonic'), 'rigid')).toEqual(fresh);
  });

  it("is the paper's with its supports and no more sites than it needs", () => {
    const project = withMode({ ...fresh, handles: [point('a', 'auto'), point('b', 30)] }, 'harmonic');
    expect(project.pose).toEqual({ mode: 'harmonic', blend: 'linear', density: 0 });
    expect(project.weighting).toEqual({ ...fresh.weighting, support: 'paper' });
    expect(project.handles.map(({ rotation }) => rotation)).toEqual([0, 30]);
  });

  it('frees what nobody has turned, and keeps what somebody has', () => {
    const handed = { ...fresh, handles: [point('a'), point('b', 0), point('c', 30)] };
    const { handles } = withMode(handed, 'rigid');
    expect(handles.map(({ rotation, posed }) => [rotation, posed])).toEqual([
      ['auto', [9, 9]],
      ['auto', [9, 9]],
      [30, [9, 9]],
    ]);
  });

  it('comes back to the detail and to the turns that it had in that mode', () => {
    const before = withDetail({ ...fresh, handles: [point('a', 0), point('b', 'auto')] }, 'fine');
    const away = withMode(before, 'harmonic');
    expect(away.handles.map(({ rotation }) => rotation)).toEqual([0, 0]);
    const added = { ...away, handles: [...away.handles, point('c', 0)] };
    const back = withMode(added, 'rigid', before);
    expect(detailOf(back)).toBe('fine');
    expect(back.handles.map(({ rotation }) => rotation)).toEqual([0, 'auto', 'auto']);
    // What was turned meanwhile keeps its turn.
    const turned = { ...away, handles: [point('a', 12), point('b', 0)] };
    expect(withMode(turned, 'rigid', before).handles.map(({ rotation }) => rotation)).toEqual([12, 'auto']);
  });

  it('is harmonic where a file says nothing', () => {
    const { pose: _, ...bare }: Project = fresh;
    expect(modeOf(bare)).toBe('harmonic');
    expect(detailOf(bare)).toBeNull();
  });

  it('has a detail in words', () => {
    expect(detailOf(fresh)).toBe('medium');
    expect(withDetail(fresh, 'fine').pose).toEqual({ ...fresh.pose, density: 200 });
    expect(detailOf(withDetail(fresh, 'coarse'))).toBe('coarse');
  });
});
