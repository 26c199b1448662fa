import { describe, expect, it } from 'vitest';
import { detailOf, modeOf, withBlend, withDetail, withMode } from './bending';
import { newProject } from './document';
import type { LineHandle, PointHandle, PoseMode, Project } from './project';

const point = (id: string, rotation?: PointHandle['rotation']): PointHandle => ({
  id,
  kind: 'point',
  rest: [id.charCodeAt(0), 0],
  posed: [9, 9],
  ...(rotation === undefined ? {} : { rotation }),
});

const corners = [
  [0, 0],
  [10, 0],
  [10, 5],
] as const;
const lines: readonly LineHandle[] = [
  { id: 'arm', kind: 'bar', rest: corners, posed: corners, rotation: 'auto' },
  { id: 'shell', kind: 'polygon', rest: corners, posed: corners, rotation: 450 },
];

const rotations = ({ handles }: Project) => handles.map(({ rotation }) => rotation);

const fresh = newProject({ src: 'a.png', width: 8, height: 8 }, null);

describe('the mode of bending', () => {
  it('of a new project is rigid, with smooth supports and 150 virtual sites', () => {
    expect(fresh.pose).toEqual({ mode: 'rigid', blend: 'linear', density: 150 });
    expect(fresh.weighting?.support).toBe('smooth');
    expect(withMode(withMode(fresh, 'harmonic'), 'rigid')).toEqual(fresh);
  });

  it('harmonic has the supports of the paper, no virtual sites, and the same rotations', () => {
    const handles = [point('a', 'auto'), point('b', 30), point('c', 0), point('d'), ...lines];
    const project = withMode({ ...fresh, handles }, 'harmonic');
    expect(project.pose).toEqual({ mode: 'harmonic', blend: 'linear', density: 0 });
    expect(project.weighting).toEqual({ ...fresh.weighting, support: 'paper' });
    expect(project.handles).toEqual(handles);
  });

  it('rigid makes unturned points automatic and keeps the others', () => {
    const handed = { ...fresh, handles: [point('a'), point('b', 0), point('c', 30), ...lines] };
    const { handles } = withMode(handed, 'rigid');
    expect(handles).toEqual([point('a', 'auto'), point('b', 'auto'), point('c', 30), ...lines]);
  });

  it.each([
    ['rigid', 'harmonic'],
    ['harmonic', 'rigid'],
  ] as const)('leads from %s to %s and back to the same project', (from, to) => {
    const handles = [point('a', 'auto'), point('b', 0), point('c'), point('d', -30), ...lines];
    const settings = [
      withMode(fresh, from),
      withBlend(withDetail(withMode(fresh, from), 'fine'), 'rigid'),
      { format: fresh.format, image: fresh.image, pose: { mode: from } },
    ] as const;
    for (const setting of settings) {
      const before: Project = { ...setting, handles };
      const after = withMode(before, to);
      expect(modeOf(after)).toBe(to);
      expect(JSON.stringify(withMode(after, from, { before, after }))).toBe(JSON.stringify(before));
    }
  });

  it('is the same as of a project that was made in it with these handles', () => {
    const handles = [point('a', 'auto'), point('b', 30), ...lines];
    for (const [from, to] of [
      ['rigid', 'harmonic'],
      ['harmonic', 'rigid'],
    ] as const) {
      const made = (mode: PoseMode) => ({
        ...newProject(fresh.image, null, { pose: { mode } }),
        handles,
      });
      expect(withMode(made(from), to)).toEqual(made(to));
    }
  });

  it('has its last detail and rotations when chosen again, and keeps later changes', () => {
    const before = withDetail({ ...fresh, handles: [point('a', 0), point('b', 'auto')] }, 'fine');
    const after = withMode(before, 'harmonic');
    const added = { ...after, handles: [...after.handles, point('c', 0), point('d', 12)] };
    const back = withMode(added, 'rigid', { before, after });
    expect(detailOf(back)).toBe('fine');
    expect(rotations(back)).toEqual([0, 'auto', 'auto', 12]);
    const turned = { ...after, handles: [point('a', 12), point('b', -60)] };
    expect(rotations(withMode(turned, 'rigid', { before, after }))).toEqual([12, -60]);
  });

  it('harmonic leaves points automatic that rigid made so, once they were moved', () => {
    const before = withMode({ ...fresh, handles: [] }, 'harmonic');
    const unturned = { ...before, handles: [point('a', 0), point('b')] };
    const after = withMode(unturned, 'rigid');
    const [a, b] = after.handles;
    if (!a || !b) throw new Error('two points');
    const moved = { ...after, handles: [{ ...a, posed: [50, 9] } as PointHandle, b] };
    expect(rotations(withMode(moved, 'harmonic', { before: unturned, after }))).toEqual(['auto', undefined]);
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
