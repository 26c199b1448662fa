/** Stores values by name in an IndexedDB database. Values can be anything that can be cloned, files included. */
import { createStore, getMany, promisifyRequest, type UseStore } from 'idb-keyval';

let store: UseStore | undefined;

/** Opens the database at first use, so that this module loads without IndexedDB too. */
function database(): UseStore {
  store ??= createStore('c2warp', 'kept');
  return store;
}

/**
 * Reads all values in one transaction.
 *
 * @throws DOMException if the browser refuses storage.
 */
export function readStored(names: readonly string[]): Promise<readonly unknown[]> {
  return getMany([...names], database());
}

/**
 * Writes all values in one transaction, or none.
 *
 * @param unless More `values`, skipped if `name` already holds the value `is`.
 * @throws DOMException if the browser refuses storage or the quota is exceeded.
 */
export function writeStored(
  values: Readonly<Record<string, unknown>>,
  unless: { readonly name: string; readonly is: unknown; readonly values: Readonly<Record<string, unknown>> },
): Promise<void> {
  return database()('readwrite', async (store) => {
    const unchanged = (await promisifyRequest(store.get(unless.name))) === unless.is;
    for (const [name, value] of Object.entries({ ...values, ...(unchanged ? {} : unless.values) })) {
      store.put(value, name);
    }
    await promisifyRequest(store.transaction);
  });
}
