/** Finds the handles that a page names, and applies its changes. */
import { type Document, handleById } from '../document/document';
import { checkedHandle } from '../document/handle';
import { deepCopy, type Handle } from '../document/project';

/** @throws RangeError if the handle does not exist. */
export function namedHandle(document: Document, id: string): Handle {
  const handle = handleById(document, id);
  if (!handle) throw new RangeError(`there is no handle "${id}"`);
  return handle;
}

/** A handle with a page's changes. @throws RangeError if the result is invalid, or a `fixed` key would change. */
export function changedHandle(
  document: Document,
  id: string,
  change: object,
  fixed: readonly ('id' | 'kind' | 'rest')[] = ['id', 'kind'],
): Handle {
  const handle = namedHandle(document, id);
  const changed = deepCopy(checkedHandle({ ...handle, ...change } as Handle));
  for (const key of fixed) {
    if (String(changed[key]) !== String(handle[key]))
      throw new RangeError(`handle "${id}", ${key}: cannot be changed`);
  }
  return changed;
}
