/** Error handling for methods of the element. */
import { asC2WarpError, isAbort } from '../error';

/**
 * Turns failures of the work into errors of the class C2WarpError, except an AbortError and the reason of the page's
 * signal.
 */
export async function coded<T>(work: Promise<T>, signal?: AbortSignal): Promise<T> {
  try {
    return await work;
  } catch (error) {
    throw signal?.aborted || isAbort(error) ? error : asC2WarpError(error);
  }
}
