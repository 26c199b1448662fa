import { describe, expect, it, vi } from 'vitest';
import { Notices } from './notices';

function notices() {
  const told: unknown[] = [];
  const emit = (type: string, detail: unknown) => type === 'progress' && told.push(detail);
  return { told, notices: new Notices({ changed: () => {}, emit, answerable: true, playing: false }) };
}

describe('a notice that disappears by itself', () => {
  it('stays as long as a pointer or the focus is on it', () => {
    vi.useFakeTimers();
    const { notices: it } = notices();
    it.notify({ kind: 'info', text: 'a word' });
    it.linger(true);
    vi.runAllTimers();
    expect(it.notice?.text).toBe('a word');
    it.linger(false);
    vi.runAllTimers();
    expect(it.notice).toBeNull();
    vi.useRealTimers();
  });
});

describe('progress', () => {
  it('shows the newest of what is under way, and each until its own end', () => {
    const { notices: it, told } = notices();
    const solved = it.begin('Sampling', () => {});
    const exported = it.begin('Exporting');
    expect(it.progress).toEqual({ label: 'Exporting', cancel: null });
    solved();
    expect(it.progress?.label).toBe('Exporting');
    const again = it.begin('Weighting', () => {});
    again();
    expect(it.progress?.label).toBe('Exporting');
    exported();
    expect(it.progress).toBeNull();
    expect(told.map((detail) => Object.values(detail as object)[0])).toEqual([
      'Sampling',
      'Exporting',
      'Weighting',
      'Exporting',
      null,
    ]);
  });

  it('gives up what it belongs to', () => {
    const { notices: it } = notices();
    let given = '';
    it.begin('Sampling', () => {
      given = 'Sampling';
    });
    const exported = it.begin('Exporting');
    it.progress?.cancel?.();
    expect(given).toBe('');
    exported();
    it.progress?.cancel?.();
    expect(given).toBe('Sampling');
  });
});
