import { describe, expect, it } from 'vitest';
import { FakeRuntime, testPicture } from './fake_runtime';
import { bounded, otherVersion, withoutVersions, withReplaced } from './recent';
import { projectOf } from './state';
import { snapshotOf } from './update/autosave';
import type { WorkSnapshot } from './work';

function work(name: string, size = 1, edited = true): WorkSnapshot {
  const runtime = new FakeRuntime();
  runtime.open(testPicture(name));
  if (edited) runtime.dispatch({ type: 'boundary-switched', held: false });
  const snapshot = snapshotOf(runtime.state);
  if (!snapshot) throw new Error(projectOf(runtime.state).image.src);
  return { ...snapshot, id: name, file: { size, type: '' } };
}
const names = (works: readonly WorkSnapshot[]) => works.map(({ name }) => name).join(' ');

describe('recent work', () => {
  it('holds the newest ten', () => {
    const many = Array.from({ length: 12 }, (_, k) => work(`${k}`));
    expect(names(bounded(many))).toBe('2 3 4 5 6 7 8 9 10 11');
  });

  it('holds no more bytes than fit, and always the newest', () => {
    expect(names(bounded([work('a', 150e6), work('b', 60e6), work('c', 60e6)]))).toBe('b c');
    expect(names(bounded([work('a'), work('b', 900e6)]))).toBe('b');
  });

  it('takes work that gives way if it was edited', () => {
    expect(names(withReplaced([work('a')], work('b')))).toBe('a b');
    expect(names(withReplaced([work('a')], work('b', 1, false)))).toBe('a');
    expect(names(withReplaced([work('a')], null))).toBe('a');
  });

  it('knows the version of another tab until the person has answered', () => {
    const recent = [work('a'), { ...work('b'), fromOtherTab: true }];
    expect(otherVersion(recent, { name: 'a' })).toBeNull();
    expect(otherVersion(recent, { name: 'b' })).toBe(recent[1]);
    expect(otherVersion(withoutVersions(recent), { name: 'b' })).toBeNull();
  });
});
