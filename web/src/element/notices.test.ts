import { describe, expect, it, vi } from 'vitest';
import { ENGINE, EngineError } from '../compute/errors';
import { Notices } from './notices';

function notices() {
  const told: unknown[] = [];
  const emit = (type: string, detail: unknown) => type === 'progress' && told.push(detail);
  const host = { changed: () => {}, emit, answerable: true, playing: false, again: () => told.push('again') };
  return { told, notices: new Notices(host) };
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

describe('what is said about a step', () => {
  const lost = { kind: 'info', text: 'One is gone.', ofStep: true } as const;

  it('ends with the next one, unlike what is said about anything else', () => {
    const { notices: it } = notices();
    it.notify(lost);
    it.stepped();
    expect(it.notice).toBeNull();
    it.notify({ kind: 'info', text: 'a word' });
    it.stepped();
    expect(it.notice?.text).toBe('a word');
  });

  it('is said together, each once, with what can be done about it', () => {
    const { notices: it } = notices();
    let held = false;
    const run = () => {
      held = true;
    };
    const action = { label: 'Hold', run };
    it.notify({ ...lost, action, passes: true });
    it.notify({ kind: 'info', text: 'Two lie beside it.', ofStep: true });
    it.notify({ kind: 'info', text: 'Two lie beside it.', ofStep: true });
    expect(it.notice?.text).toBe('One is gone. Two lie beside it.');
    it.notice?.action?.run();
    expect(held).toBe(true);
    expect(it.notice).toBeNull();
  });
});

describe('an error', () => {
  const error = new EngineError({ code: ENGINE, message: 'The solver could not be loaded' });

  it('of the solver can be tried again, and goes once the solver works', () => {
    const { notices: it, told } = notices();
    it.report(error);
    it.notice?.action?.run();
    expect(told).toEqual(['again']);
    expect(it.notice).toBeNull();
    it.report(error);
    it.solved();
    expect(it.notice).toBeNull();
  });

  it('of anything else stays', () => {
    const { notices: it } = notices();
    it.report(new Error('no picture'));
    it.solved();
    expect(it.notice).toEqual({ kind: 'error', text: 'no picture' });
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
