/** The newest picture that a page has asked an element for, as a promise. */

interface Asked {
  readonly promise: Promise<void>;
  readonly resolve: () => void;
  readonly reject: (reason: unknown) => void;
  /** A call of `load()` has its own result, and hears of no other picture. */
  readonly byCall: boolean;
  state: 'pending' | 'open' | 'failed';
}

export class Loading {
  #asked = asked(false);

  get promise(): Promise<void> {
    return this.#asked.promise;
  }

  /** The page names another picture by attributes: the promise before it is rejected. */
  renew(): void {
    this.#replace(false);
  }

  /** The page loads another picture. */
  follow(work: Promise<void>): void {
    const { resolve, reject } = this.#replace(true);
    work.then(resolve, reject);
  }

  /** The picture is opened again, after the element was moved. */
  reopen(): void {
    if (this.#asked.state !== 'pending') this.#asked = asked(false);
  }

  /** A picture is open, whoever asked for it. */
  opened(): void {
    if (this.#asked.state === 'failed') this.#asked = asked(false);
    if (!this.#asked.byCall) this.#asked.resolve();
  }

  /** The picture of the attributes cannot be opened. */
  failed(reason: unknown): void {
    if (!this.#asked.byCall) this.#asked.reject(reason);
  }

  #replace(byCall: boolean): Asked {
    this.#asked.reject(new DOMException('another picture was asked for', 'AbortError'));
    this.#asked = asked(byCall);
    return this.#asked;
  }
}

function asked(byCall: boolean): Asked {
  let [resolve, reject]: [() => void, (reason: unknown) => void] = [() => {}, () => {}];
  const promise = new Promise<void>((...settle) => {
    [resolve, reject] = settle;
  });
  // A page that does not wait for the picture hears of a failure by `error`.
  promise.catch(() => {});
  const end = (state: Asked['state']) => {
    if (result.state === 'pending') result.state = state;
  };
  const result: Asked = {
    promise,
    byCall,
    state: 'pending',
    resolve: () => {
      end('open');
      resolve();
    },
    reject: (reason) => {
      end('failed');
      reject(reason);
    },
  };
  return result;
}
