import { describe, expect, it } from 'vitest';
import type { Clip } from '../../document/project';
import { en } from '../../texts/en';
import type { EditorEffect } from '../effects';
import { englishNotice, englishTask } from '../english';
import { FakeRuntime } from '../fake_runtime';
import { filmedRange } from '../film_choices';
import { filmModel } from '../film_model';
import { viewModel } from '../view_model';

const CODECS = {
  webm: { codec: 'vp9', width: 400, height: 300 },
  mp4: { codec: 'avc', width: 400, height: 300 },
} as const;

type FilmEffect = Extract<EditorEffect, { readonly type: 'export-film' }>;

const films = (runtime: FakeRuntime): readonly FilmEffect[] =>
  runtime.effects.filter((effect): effect is FilmEffect => effect.type === 'export-film');

const asked = (runtime: FakeRuntime) => runtime.effects.filter(({ type }) => type === 'find-codecs').length;

/** A picture with a clip, and the panel open at its film page. */
function opened(codecs: typeof CODECS | { webm: null; mp4: null } | null = CODECS): FakeRuntime {
  const runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'timeline-opened', open: true });
  runtime.dispatch({ type: 'clip-added', preset: null });
  runtime.dispatch({ type: 'popover-toggled', popover: 'export', open: true });
  runtime.dispatch({ type: 'export-kind-chosen', kind: 'film' });
  if (codecs) runtime.dispatch({ type: 'codecs-found', codecs });
  return runtime;
}

const run = (runtime: FakeRuntime) => runtime.dispatch({ type: 'command-run', command: 'export' });

describe('a film', () => {
  it('has the choices of the person, and names the file after the clip', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'film-choice-made', choice: { percent: 50, rate: 12, range: [0.5, 1] } });
    run(runtime);
    const [film] = films(runtime);
    expect(film?.name).toMatch(/^cat-.*\.webm$/);
    expect(film?.film).toMatchObject({
      format: 'webm',
      scale: 0.5,
      rate: 12,
      range: [0.5, 1],
      background: null,
    });
    expect(englishTask(runtime.state)).toMatchObject({ name: 'export', fraction: 0 });
  });

  it('is a GIF, and lacks formats, where the browser encodes no video', () => {
    const runtime = opened({ webm: null, mp4: null });
    const { film } = viewModel(runtime.state, en).exporting;
    expect(film).toMatchObject({ format: 'gif', lacking: ['webm', 'mp4'] });
    run(runtime);
    expect(films(runtime)[0]?.film.format).toBe('gif');
  });

  it('waits until the codecs of the browser are known', () => {
    const runtime = opened(null);
    run(runtime);
    expect(films(runtime)).toEqual([]);
    runtime.dispatch({ type: 'codecs-found', codecs: CODECS });
    expect(films(runtime)).toHaveLength(1);
  });

  it('asks for the codecs again when its size changes', () => {
    const runtime = opened();
    const before = asked(runtime);
    runtime.dispatch({ type: 'film-choice-made', choice: { quality: 10 } });
    expect(asked(runtime)).toBe(before);
    runtime.dispatch({ type: 'film-choice-made', choice: { percent: 30 } });
    expect(asked(runtime)).toBe(before + 1);
  });

  it('of a GIF has at most 50 frames a second, and of an MP4 always a background', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'film-choice-made', choice: { format: 'gif', rate: 60 } });
    run(runtime);
    runtime.dispatch({ type: 'export-ended', saved: 'cat.gif', error: null });
    runtime.dispatch({ type: 'film-choice-made', choice: { format: 'mp4', background: '#102030' } });
    run(runtime);
    expect(films(runtime).map(({ film }) => [film.rate, film.background])).toEqual([
      [50, null],
      [60, '#102030'],
    ]);
  });

  it('shows its pixels and frames, and the remaining time', () => {
    const runtime = opened();
    runtime.dispatch({ type: 'film-choice-made', choice: { percent: 50, rate: 10, range: [0, 0.5] } });
    expect(filmModel(runtime.state)).toMatchObject({ size: { width: 200, height: 150 }, frames: 5 });
    run(runtime);
    runtime.dispatch({ type: 'export-progressed', fraction: 0.4, left: 31 });
    expect(englishTask(runtime.state)).toMatchObject({ fraction: 0.4, left: 'about 30 s left' });
  });

  it('needs a clip', () => {
    const runtime = new FakeRuntime();
    runtime.open();
    runtime.dispatch({ type: 'export-kind-chosen', kind: 'film' });
    run(runtime);
    expect(films(runtime)).toEqual([]);
    expect(englishNotice(runtime.state)?.text).toContain('A film needs a clip');
  });

  it('stays within the clip', () => {
    const clip: Clip = { name: 'nod', duration: 2, loop: 'repeat', tracks: [] };
    expect(filmedRange(clip, [1, 5])).toEqual([1, 2]);
    expect(filmedRange(clip, [0, 2])).toBeNull();
    expect(filmedRange(clip, [3, 5])).toBeNull();
  });
});
