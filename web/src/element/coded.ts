/** Rejections of methods of the element. */
import { asC2WarpError, isAbort } from '../error';

/**
 * The same work, whose failures are of the class C2WarpError.
 *
 * An AbortError stays as it is, and so does the reason of the page's own signal.
 */
export async function coded<T>(work: Promise<T>, signal?: AbortSignal): Promise<T> {
  try {
    return await work;
  } catch (error) {
    throw signal?.aborted || isAbort(error) ? error : asC2WarpError(error);
  }
}
