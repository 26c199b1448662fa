/** The errors of requests to the worker. */
import { WarpError } from '../error';
import type { Failure } from './messages';

/** The error of a request that the worker refuses. */
export const failureError = ({ code, message, handles = [] }: Failure): WarpError =>
  new WarpError(code, message, { handles });

/** The error of a request that a newer one has made pointless. */
export const superseded = (): DOMException => new DOMException('superseded', 'AbortError');
