/** The next picture of an element as a promise. */
import type { C2WarpError } from '../error';
import type { TypedElement } from './events';

/** Resolves with the next `load`. Rejects with the `error` before `ready`, if no `load` occurs. */
export function loadOf(element: TypedElement): Promise<void> {
  const heard = new AbortController();
  const { signal } = heard;
  let failure: C2WarpError | null = null;
  const loaded = new Promise<void>((resolve, reject) => {
    element.addEventListener('load', () => resolve(), { signal });
    const onError = ({ detail }: CustomEvent<C2WarpError>) => {
      failure = detail;
    };
    element.addEventListener('error', onError, { signal });
    element.addEventListener('ready', () => failure && reject(failure), { signal });
  });
  return loaded.finally(() => heard.abort());
}
