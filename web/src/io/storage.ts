/** Values by name, kept in a database (IndexedDB) of the editor's own. Anything that can be cloned, files included. */
import { createStore, getMany, promisifyRequest, type UseStore } from 'idb-keyval';

let store: UseStore | undefined;

/** Opened at first use, so that this module loads where there is no database. */
function kept(): UseStore {
  store ??= createStore('c2warp', 'kept');
  return store;
}

/** Reads all values in one transaction. @throws DOMException where the browser grants no storage. */
export function readKept(names: readonly string[]): Promise<readonly unknown[]> {
  return getMany([...names], kept());
}

/**
 * Writes some values, all of them or none.
 * @param unless values that are written too, unless `name` already holds the value `is`.
 * @throws DOMException where the browser grants no storage, or no more of it.
 */
export function writeKept(
  values: Readonly<Record<string, unknown>>,
  unless: { readonly name: string; readonly is: unknown; readonly values: Readonly<Record<string, unknown>> },
): Promise<void> {
  return kept()('readwrite', async (store) => {
    const same = (await promisifyRequest(store.get(unless.name))) === unless.is;
    for (const [name, value] of Object.entries({ ...values, ...(same ? {} : unless.values) })) {
      store.put(value, name);
    }
    await promisifyRequest(store.transaction);
  });
}
