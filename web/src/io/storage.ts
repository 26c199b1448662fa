/** What is kept in this browser, in a database of its own: values that can be cloned, files among them, by name. */
import { createStore, get, set, type UseStore } from 'idb-keyval';

let store: UseStore | undefined;

/** Opened at the first use, so that this module loads where there is no database. */
function kept(): UseStore {
  store ??= createStore('c2warp', 'kept');
  return store;
}

/** @throws DOMException where the browser grants no storage. */
export function readKept<Value>(name: string): Promise<Value | undefined> {
  return get<Value>(name, kept());
}

/** @throws DOMException where the browser grants no storage, or no more of it. */
export function writeKept(name: string, value: unknown): Promise<void> {
  return set(name, value, kept());
}
