import { beforeEach, describe, expect, it } from 'vitest';
import type { Handle } from '../../document/project';
import { en } from '../../texts/en';
import { reasonAgainst } from '../can_run';
import { englishNotice, inEnglish, spokenText } from '../english';
import { FakeRuntime, PAGE } from '../fake_runtime';
import { foldsWords } from '../notice_words';
import { projectOf } from '../state';
import { viewModel } from '../view_model';

const point = (id: string, x: number): Handle => ({ id, kind: 'point', rest: [100, 100], posed: [x, 100] });

let runtime: FakeRuntime;

const check = () => runtime.dispatch({ type: 'timer-elapsed', timer: 'pose-check' });
const places = () => projectOf(runtime.state).handles.map(({ posed }) => posed[0]);
const pose = (id: string, x: number) => {
  runtime.dispatch({ type: 'handle-changed', handle: point(id, x) });
  check();
};

beforeEach(() => {
  runtime = new FakeRuntime();
  runtime.open();
  runtime.dispatch({ type: 'handle-added', handle: point('left-hand', 100) });
  runtime.dispatch({
    type: 'handle-added',
    handle: { ...point('left-elbow', 150), rest: [150, 100] } as Handle,
  });
  runtime.solve();
});

describe('handles that force folds', () => {
  it('are named once, with a way out', () => {
    pose('left-hand', 1200);
    const notice = englishNotice(runtime.state);
    expect(notice?.text).toBe('“left hand” folds the picture.');
    expect(notice?.action?.label).toBe('Unfold the picture');
    expect(viewModel(runtime.state, en).forcing).toEqual(['left hand']);
    runtime.dispatch({ type: 'notice-dismissed' });
    // The same handle again is no news.
    pose('left-hand', 1300);
    expect(englishNotice(runtime.state)).toBeNull();
    pose('left-hand', 100);
    expect(viewModel(runtime.state, en).forcing).toEqual([]);
    pose('left-hand', 1200);
    expect(englishNotice(runtime.state)?.text).toBe('“left hand” folds the picture.');
  });

  it('are moved by one press, as one step', () => {
    pose('left-hand', 1200);
    runtime.dispatch({ type: 'notice-answered' });
    expect(places()).toEqual([1000, 150]);
    expect(englishNotice(runtime.state)?.text).toBe(
      '“left hand” moved back to the nearest pose without folds.',
    );
    check();
    expect(inEnglish(reasonAgainst(runtime.state, 'without-folds'))).toBe('Nothing is folded');
    runtime.dispatch({ type: 'undo-asked' });
    expect(places()).toEqual([1200, 150]);
    expect(spokenText(runtime.state)).toBe('Undone: Unfold left hand');
  });

  it('say that no pose without folds was found', () => {
    pose('left-hand', 9100);
    runtime.dispatch({ type: 'command-run', command: 'without-folds' });
    expect(places()).toEqual([9100, 150]);
    expect(englishNotice(runtime.state)?.text).toMatch(/^Found no pose without folds/);
  });

  it('are not reported during a press, nor to people who may not edit', () => {
    runtime.dispatch({ type: 'page-changed', page: { ...PAGE, readonly: true } });
    pose('left-hand', 1200);
    expect(englishNotice(runtime.state)).toBeNull();
    expect(viewModel(runtime.state, en).forcing).toEqual(['left hand']);
  });
});

describe('the sentence about folds', () => {
  it('names one handle, several, or the first of many', () => {
    expect(inEnglish(foldsWords([]))).toBe('The picture folds over itself.');
    expect(inEnglish(foldsWords(['left hand', 'left elbow']))).toBe(
      '“left hand” and “left elbow” together fold the picture.',
    );
    expect(inEnglish(foldsWords(['a', 'b', 'c', 'd', 'e', 'f', 'g']))).toBe(
      '“a”, “b”, “c”, “d”, “e” and 2 more together fold the picture.',
    );
  });
});
