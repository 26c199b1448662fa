/** Stores values by name in an IndexedDB database. Values can be anything that can be cloned, files included. */
import { createStore, promisifyRequest, type UseStore } from 'idb-keyval';

let store: UseStore | undefined;

/** Opens the database at first use, so that this module loads without IndexedDB too. */
function database(): UseStore {
  store ??= createStore('c2warp', 'kept');
  return store;
}

/** The names and values of one transaction. */
export interface StoredValues {
  get(name: string): Promise<unknown>;
  /** The values whose names begin so, in the order of their names. */
  under(prefix: string): Promise<readonly unknown[]>;
  put(name: string, value: unknown): void;
  delete(name: string): void;
}

/**
 * Reads and writes in one transaction: all of it, or nothing. `change` may wait for these values alone.
 *
 * @throws DOMException if the browser refuses storage or the quota is exceeded.
 */
export async function inTransaction<T>(
  mode: IDBTransactionMode,
  change: (values: StoredValues) => Promise<T>,
): Promise<T> {
  return database()(mode, async (store) => {
    const { transaction } = store;
    const done = promisifyRequest(transaction);
    // A failure of the change itself is reported instead.
    done.catch(() => {});
    try {
      const result = await change(valuesOf(store));
      await done;
      return result;
    } catch (error) {
      // Of a transaction that has ended already, nothing is left to take back.
      if (!transaction.error) abort(transaction);
      throw error;
    }
  });
}

const valuesOf = (store: IDBObjectStore): StoredValues => ({
  get: (name) => promisifyRequest(store.get(name)),
  // U+FFFF sorts behind every name.
  under: (prefix) => promisifyRequest(store.getAll(IDBKeyRange.bound(prefix, `${prefix}\uffff`))),
  put: (name, value) => {
    store.put(value, name);
  },
  delete: (name) => {
    store.delete(name);
  },
});

function abort(transaction: IDBTransaction): void {
  try {
    transaction.abort();
  } catch {
    // It has ended.
  }
}
