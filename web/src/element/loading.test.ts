import { describe, expect, it } from 'vitest';
import { Loading } from './loading';

const result = (promise: Promise<void>): Promise<string> =>
  Promise.race([
    promise.then(
      () => 'open',
      (reason) => (reason instanceof Error ? reason.name : String(reason)),
    ),
    new Promise<string>((resolve) => setTimeout(() => resolve('pending'))),
  ]);

describe('the promise of the newest picture', () => {
  it('is rejected when the page asks for another one', async () => {
    const loading = new Loading();
    const first = loading.promise;
    loading.renew();
    expect(loading.promise).not.toBe(first);
    expect([await result(first), await result(loading.promise)]).toEqual(['AbortError', 'pending']);
    loading.opened();
    expect(await result(loading.promise)).toBe('open');
  });

  it('of a call ends as the call does, whatever else is opened', async () => {
    const loading = new Loading();
    let resolve = () => {};
    loading.follow(
      new Promise((done) => {
        resolve = done;
      }),
    );
    loading.opened();
    loading.failed('another file');
    expect(await result(loading.promise)).toBe('pending');
    resolve();
    expect(await result(loading.promise)).toBe('open');
  });

  it('that failed gives way to the picture that a person opens', async () => {
    const loading = new Loading();
    loading.renew();
    loading.failed('no such file');
    expect(await result(loading.promise)).toBe('no such file');
    loading.opened();
    expect(await result(loading.promise)).toBe('open');
  });

  it('waits again when an element that has been moved opens its picture', async () => {
    const loading = new Loading();
    loading.reopen();
    const before = loading.promise;
    loading.opened();
    loading.reopen();
    expect(loading.promise).not.toBe(before);
    expect(await result(loading.promise)).toBe('pending');
  });
});
