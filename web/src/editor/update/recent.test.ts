import { describe, expect, it } from 'vitest';
import type { EditorEffect } from '../effects';
import { englishNotice } from '../english';
import { FakeRuntime, testFile, testPicture } from '../fake_runtime';
import { isUnsaved, projectOf } from '../state';
import type { WorkSnapshot } from '../work';
import { isKept, snapshotOf } from './autosave';

const edit = (runtime: FakeRuntime, held = false) => {
  runtime.dispatch({ type: 'boundary-switched', held });
  runtime.solve();
};
const open = (runtime: FakeRuntime, name: string) => {
  runtime.dispatch({ type: 'files-received', files: [{ name, file: testFile(name) }] });
  runtime.read(testPicture(name));
  runtime.solve();
};
const names = ({ state }: FakeRuntime) => state.opening.recent.map(({ name }) => name).join(' ');
const stores = (runtime: FakeRuntime) =>
  runtime.effects.filter(({ type }) => type === 'store') as Extract<EditorEffect, { type: 'store' }>[];
const stored = () => {
  const runtime = new FakeRuntime();
  runtime.dispatch({ type: 'autosave-key-set', key: 'editor' });
  runtime.open(testPicture('cat.png'));
  return runtime;
};

describe('the offer to go back', () => {
  const offered = () => {
    const runtime = stored();
    edit(runtime);
    open(runtime, 'dog.png');
    expect(englishNotice(runtime.state)?.action?.label).toBe('Back to cat.png');
    return runtime;
  };

  it('passes after a while', () => {
    const runtime = offered();
    runtime.dispatch({ type: 'timer-elapsed', timer: 'notice' });
    expect(englishNotice(runtime.state)).toBeNull();
    expect(names(runtime)).toBe('cat.png');
  });

  it('ends with the next edit', () => {
    const runtime = offered();
    edit(runtime);
    expect(englishNotice(runtime.state)).toBeNull();
  });
});

describe('recent work', () => {
  it('is removed from the list, and put back', () => {
    const runtime = stored();
    for (const name of ['dog.png', 'fox.png']) {
      edit(runtime);
      open(runtime, name);
    }
    expect(names(runtime)).toBe('cat.png dog.png');
    runtime.dispatch({ type: 'recent-removed', id: 'cat.png' });
    expect(names(runtime)).toBe('dog.png');
    expect(stores(runtime).at(-1)).toMatchObject({ work: null, recent: [{ name: 'dog.png' }] });
    runtime.dispatch({ type: 'notice-answered' });
    expect(names(runtime)).toBe('cat.png dog.png');
    runtime.dispatch({ type: 'recent-removed', id: null });
    expect(names(runtime)).toBe('');
  });
});

describe('the work of two tabs', () => {
  const restored = () => {
    const other = stored();
    edit(other);
    const work = snapshotOf(other.state) as WorkSnapshot;
    const version: WorkSnapshot = { ...work, id: 'other', fromOtherTab: true, guarded: true };
    const runtime = new FakeRuntime();
    runtime.dispatch({ type: 'autosave-key-set', key: 'editor' });
    runtime.dispatch({ type: 'started', work: null });
    runtime.dispatch({ type: 'storage-read', stored: { work, recent: [version] } });
    runtime.read(testPicture('cat.png'));
    runtime.solve();
    return runtime;
  };

  it('is offered until the person chooses', () => {
    const runtime = restored();
    expect(englishNotice(runtime.state)?.text).toContain('cat.png was changed in two tabs');
    runtime.dispatch({ type: 'notice-answered', other: true });
    expect(englishNotice(runtime.state)).toBeNull();
    expect(stores(runtime).at(-1)?.recent).toMatchObject([{ id: 'other' }]);
    expect(stores(runtime).at(-1)?.recent[0]?.fromOtherTab).toBeUndefined();
  });

  it('gives way to the other version, and stays in the list', () => {
    const runtime = restored();
    runtime.dispatch({ type: 'notice-answered' });
    runtime.read(testPicture('cat.png'));
    runtime.solve();
    expect(runtime.state.opening.recent.map(({ id, fromOtherTab }) => [id, fromOtherTab])).toEqual([
      ['cat.png', undefined],
    ]);
  });

  it('only replaces the stored work of another tab after changes', () => {
    const runtime = stored();
    runtime.dispatch({ type: 'work-stored', stored: true, newest: true });
    runtime.dispatch({
      type: 'handle-added',
      handle: { id: 'a', kind: 'point', rest: [5, 5], posed: [5, 5] },
    });
    expect(stores(runtime).at(-1)?.changed).toBe(true);
    runtime.dispatch({ type: 'work-stored', stored: true, newest: true });
    runtime.dispatch({ type: 'handles-selected', ids: [] });
    expect(stores(runtime).at(-1)?.changed).toBe(false);
  });
});

describe('a change', () => {
  it('is unsaved until a file holds it', () => {
    const runtime = stored();
    expect(isUnsaved(runtime.state)).toBe(false);
    edit(runtime);
    expect(isUnsaved(runtime.state)).toBe(true);
    runtime.dispatch({ type: 'project-saved', project: projectOf(runtime.state) });
    expect(isUnsaved(runtime.state)).toBe(false);
    runtime.dispatch({ type: 'undo-asked' });
    expect(isUnsaved(runtime.state)).toBe(true);
    runtime.dispatch({ type: 'redo-asked' });
    expect(isUnsaved(runtime.state)).toBe(false);
  });

  it('stays unsaved when the file holds another picture', () => {
    const runtime = stored();
    edit(runtime);
    const { project } = runtime.state.document.history.present;
    open(runtime, 'dog.png');
    edit(runtime);
    runtime.dispatch({ type: 'project-saved', project });
    expect(isUnsaved(runtime.state)).toBe(true);
  });

  it('is kept once the newest state is stored', () => {
    const runtime = stored();
    edit(runtime);
    runtime.dispatch({ type: 'work-stored', stored: true, newest: false });
    expect(isKept(runtime.state)).toBe(false);
    runtime.dispatch({ type: 'work-stored', stored: true, newest: true });
    expect(isKept(runtime.state)).toBe(true);
    edit(runtime, true);
    runtime.dispatch({ type: 'work-stored', stored: false, newest: true });
    expect(isKept(runtime.state)).toBe(false);
  });

  it('is reported to the page with the name of the picture', () => {
    const runtime = stored();
    edit(runtime);
    const titles = runtime.effects.flatMap((effect) =>
      effect.type === 'notify-page' && effect.notification.type === 'titlechange'
        ? [effect.notification.title]
        : [],
    );
    expect(titles).toEqual([
      { name: 'cat.png', unsaved: false },
      { name: 'cat.png', unsaved: true },
    ]);
  });
});
