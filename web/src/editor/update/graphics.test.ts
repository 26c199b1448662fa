import { describe, expect, it } from 'vitest';
import { englishNotice } from '../english';
import { FakeRuntime, PAGE, testPicture } from '../fake_runtime';

function lost(page = PAGE): FakeRuntime {
  const runtime = new FakeRuntime(page);
  runtime.open();
  runtime.dispatch({ type: 'graphics-lost' });
  return runtime;
}

const elapse = (runtime: FakeRuntime) => runtime.dispatch({ type: 'timer-elapsed', timer: 'graphics' });

describe('a lost graphics context', () => {
  it('is reported after a moment, until it is restored', () => {
    const runtime = lost();
    expect(runtime.effects.at(-1)).toMatchObject({ type: 'start-timer', timer: 'graphics' });
    expect(englishNotice(runtime.state)).toBeNull();
    elapse(runtime);
    expect(englishNotice(runtime.state)?.text).toContain('graphics card');
    runtime.dispatch({ type: 'graphics-restored' });
    expect(englishNotice(runtime.state)).toBeNull();
  });

  it('is not reported if it is restored in time', () => {
    const runtime = lost();
    runtime.dispatch({ type: 'graphics-restored' });
    expect(runtime.effects.at(-1)).toEqual({ type: 'stop-timer', timer: 'graphics' });
  });

  it('is still reported when another picture is opened, and can be dismissed', () => {
    const runtime = lost();
    elapse(runtime);
    runtime.open(testPicture('dog.png'));
    expect(englishNotice(runtime.state)?.text).toContain('graphics card');
    runtime.dispatch({ type: 'notice-dismissed' });
    expect(englishNotice(runtime.state)).toBeNull();
  });

  it('leaves stored work where it is; other work should be saved first', () => {
    const runtime = lost();
    elapse(runtime);
    expect(englishNotice(runtime.state)?.text).toContain('Save the project');
    runtime.dispatch({ type: 'autosave-key-set', key: 'work' });
    elapse(runtime);
    expect(englishNotice(runtime.state)?.text).toContain('Your work is safe. Reload');
  });

  it('is also reported to readers, who have nothing to save', () => {
    const runtime = lost();
    runtime.dispatch({ type: 'page-changed', page: { ...PAGE, posable: true } });
    elapse(runtime);
    expect(englishNotice(runtime.state)?.text).toMatch(/picture\. Reload the page\.$/);
  });
});
