import { describe, expect, it } from 'vitest';
import { newProject } from '../document/document';
import type { Lens } from '../document/generated/lens';
import type { Round, SiteStudy, Study } from '../document/generated/study';
import type { PointHandle } from '../document/project';
import { inEnglish } from './english';
import { FakeRuntime, solutionOf } from './fake_runtime';
import { lensModel } from './lens_model';
import { lensWords, percent } from './lens_words';
import { roundModel } from './rounds_model';
import { NO_STUDY } from './study_state';

const hand: PointHandle = { id: 'left hand', kind: 'point', rest: [2, 2], posed: [2, 2], rotation: 0 };
const project = { ...newProject({ src: 'a.png', width: 8, height: 8 }, null), handles: [hand] };
const solution = solutionOf('a', project);

const site = (handle: number): SiteStudy => ({
  rest: [2, 2],
  handle,
  cell_radius: 3,
  separation: 4,
  support_radius: 5,
  support_range: [4, 5],
  to_farthest: [],
  to_nearest: [],
});

const round = (score: number, sites: number, points: Round['points']): Round => ({ score, sites, points });

const study: Study = {
  outline: [],
  sites: [site(0), site(-1), site(-1)],
  falloff: [1, 0.5, 0],
  rounds: [
    round(0.5, 1, [{ at: [6, 6], owner: 0, distance: 6, limit: 3, path: [] }]),
    round(-0.2, 2, [{ at: [7, 6], owner: 1, distance: 2, limit: 3, path: [] }]),
    round(-0.3, 3, []),
  ],
  allowed_score: -0.05,
};

const lens: Lens = {
  at: [3.4, 2],
  shares: [{ handle: 0, weight: 0.25, passed_on: 0.75, site: 0, distance: 1.4, path: [] }],
  virtual_weight: 0.75,
  sites: [
    { site: 2, weight: 0.75, distance: 0.5 },
    { site: 0, weight: 0.25, distance: 1.4 },
  ],
};

const known = {
  ...NO_STUDY,
  explained: { of: solution, study },
  lens: { ...NO_STUDY.lens, found: { of: solution, at: lens.at, lens, study } },
};

describe('the lens', () => {
  it('shows the falloff of the heaviest site, or of a chosen one', () => {
    expect(lensModel(known)?.falloff).toMatchObject({ index: 2, distance: 0.5 });
    const chosen = { ...known, lens: { ...known.lens, site: 0 } };
    expect(lensModel(chosen)?.falloff).toMatchObject({ index: 0, distance: 1.4, curve: [1, 0.5, 0] });
  });

  it('stays as it is while another solution is explained', () => {
    const other = { of: solutionOf('b', project), study: null };
    expect(lensModel({ ...known, explained: other })).toEqual(lensModel(known));
    expect(lensModel(NO_STUDY)).toBeNull();
  });

  it('is described in words', () => {
    expect(inEnglish(lensWords(lens, project))).toBe('x 3, y 2: left hand 25 %, helper points 75 %');
    expect([0, 0.004, 0.099, 0.5].map(percent)).toEqual(['0 %', '0.4 %', '9.9 %', '50 %']);
  });

  it('asks one question at a time, and the newest next', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    runtime.dispatch({ type: 'command-run', command: 'lens' });
    const { shown } = runtime.state.solution;
    if (!shown) throw new Error('no solution');
    runtime.dispatch({ type: 'study-found', solution: shown, study });
    const questions = () => runtime.effects.filter(({ type }) => type === 'find-lens');
    expect(questions()).toHaveLength(1);
    for (const x of [100, 120, 140]) runtime.dispatch({ type: 'lens-pointed', at: [x, 100] });
    expect(questions()).toHaveLength(1);
    const { asked } = runtime.state.study.lens;
    if (asked) runtime.dispatch({ type: 'lens-found', solution: asked.of, at: asked.at, lens });
    expect(questions()).toHaveLength(2);
    expect(questions().at(-1)).toMatchObject({ at: [140, 100] });
  });
});

describe('a round', () => {
  const at = (index: number | null) => roundModel({ ...known, replay: { round: index, playing: false } });

  it('is at first the last one, with nothing left to do', () => {
    expect(at(null)).toMatchObject({ index: 2, sites: study.sites });
    expect(inEnglish(at(null)?.words ?? null)).toMatch(/^Round 3: done\./);
  });

  it('says which cell is divided and why', () => {
    expect(at(0)?.sites).toHaveLength(1);
    expect(inEnglish(at(0)?.words ?? null)).toMatch(
      /reaches 6 px, beyond the limit of 3 px\. .* the cell of left hand, 6 px away/,
    );
    expect(inEnglish(at(1)?.words ?? null)).toMatch(
      /asks for more helper points\. .* the cell of helper point 2/,
    );
  });
});
